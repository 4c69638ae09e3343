#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

namespace ricochet::motion {

/// How many doubles a law's memory is.
template <class Memory>
inline constexpr std::size_t memory_size = std::is_empty_v<Memory> ? 0 : sizeof(Memory) / sizeof(double);

// Braces let nothing but a double be made of a double (bar long double, which does not fit).
template <class Memory, std::size_t... Each>
constexpr bool made_of_doubles(std::index_sequence<Each...>) {
  return requires(double value) { Memory{(static_cast<void>(Each), value)...}; };
}

/// A memory that is an aggregate of doubles and nothing else, so that it can be saved and restored as such.
template <class Memory>
concept MemoryOfDoubles = std::is_empty_v<Memory> ||
    (std::is_trivially_copyable_v<Memory>&& std::is_aggregate_v<Memory> && sizeof(Memory) % sizeof(double) == 0 &&
     made_of_doubles<Memory>(std::make_index_sequence<sizeof(Memory) / sizeof(double)>()));

/// So many values before it is read one is fetched: a step of a contact takes tens of nanoseconds, memory a hundred or
/// more.
inline constexpr std::size_t look_ahead = 8;

/// Begins to load a value that will be read soon.
template <class Value>
void fetch(const Value& value) noexcept {
  constexpr std::size_t line = 64;
  for (std::size_t at = 0; at < sizeof(Value); at += line)
    __builtin_prefetch(reinterpret_cast<const char*>(&value) + at);
}

/// The memories of all contacts of one law, side by side. A slot that is given back is the next to be taken. Empty
/// memories take no room.
template <MemoryOfDoubles Memory>
class MemorySlots {
 public:
  /// A slot with the memory of a first touch.
  std::uint32_t take() {
    if constexpr (std::is_empty_v<Memory>) return 0;
    if (free_.empty()) {
      memories_.emplace_back();
      return static_cast<std::uint32_t>(memories_.size() - 1);
    }
    const std::uint32_t slot = free_.back();
    free_.pop_back();
    memories_[slot] = {};
    return slot;
  }

  void give_back(std::uint32_t slot) {
    if constexpr (!std::is_empty_v<Memory>) free_.push_back(slot);
  }

  Memory& operator[](std::uint32_t slot) noexcept {
    if constexpr (std::is_empty_v<Memory>)
      return none_;
    else
      return memories_[slot];
  }
  const Memory& operator[](std::uint32_t slot) const noexcept { return const_cast<MemorySlots&>(*this)[slot]; }

  /// Brings a memory near before it is asked for: slots follow first touches, an order that no processor foresees.
  void fetch(std::uint32_t slot) const noexcept {
    if constexpr (!std::is_empty_v<Memory>) motion::fetch(memories_[slot]);
  }

 private:
  std::vector<Memory> memories_;
  std::vector<std::uint32_t> free_;
  Memory none_{};
};

/// `values` are memory_size<Memory> doubles.
template <MemoryOfDoubles Memory>
void save(const Memory& memory, std::span<double> values) noexcept {
  if constexpr (!std::is_empty_v<Memory>) std::memcpy(values.data(), &memory, sizeof memory);
}
template <MemoryOfDoubles Memory>
void restore(Memory& memory, std::span<const double> values) noexcept {
  if constexpr (!std::is_empty_v<Memory>) std::memcpy(static_cast<void*>(&memory), values.data(), sizeof memory);
}

}  // namespace ricochet::motion
