#pragma once

#include <ricochet/contact/mean_force.hpp>

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ricochet::motion {

/// The memories of a column's contacts. Contact j follows law `laws[kind[j]]`; both outlive the bank.
template <ContactLaw Law>
class ColumnMemory {
 public:
  using Memory = typename Law::Memory;

  ColumnMemory(std::span<const Law> laws, std::span<const std::uint32_t> kind, double step)
      : laws_(laws), kind_(kind), step_(step), memory_(kind.size()) {}

  static constexpr bool remembers = !std::same_as<Memory, NoMemory>;
  const Law& law(std::size_t j) const noexcept { return laws_[kind_[j]]; }
  Memory memory(std::size_t j) const noexcept { return remembers ? memory_[j] : Memory{}; }
  void reset(std::size_t j) noexcept { memory_[j] = Memory{}; }

  /// Whether the force of a contact that opens freely may turn repulsive again before the pair has parted: only if its
  /// memory moves on meanwhile.
  bool may_wake(std::size_t j, Approach now) const noexcept {
    if constexpr (!remembers) {
      return false;
    } else if constexpr (std::equality_comparable<Memory>) {
      Memory then = memory_[j];
      law(j).advance(then, now, {now.overlap + step_ * now.rate, now.rate}, step_);
      return !(then == memory_[j]);
    } else {
      return true;
    }
  }

  /// Mean force over a whole step, and over a part of one that begins at its start or at the first touch.
  double step_mean(std::size_t j, double overlap, double rate) const noexcept {
    return mean_force(law(j), overlap, rate, memory_[j], step_);
  }
  double mean(std::size_t j, double overlap, double rate, double dt) const noexcept {
    return mean_force(law(j), overlap, rate, memory_[j], dt);
  }

  /// Advances over dt from `before` to `after` (overlaps and rates at the ends). Where the rate changes sign on the
  /// way the law sees the turning point, so that a greatest overlap is not missed between two steps.
  void advance(std::size_t j, Approach before, Approach after, double dt) noexcept {
    if constexpr (remembers) {
      if (before.rate > 0 && after.rate < 0) {
        const double rise = dt * before.rate / (before.rate - after.rate);
        const Approach top{before.overlap + 0.5 * before.rate * rise, 0};
        law(j).advance(memory_[j], before, top, rise);
        law(j).advance(memory_[j], top, after, dt - rise);
      } else {
        law(j).advance(memory_[j], before, after, dt);
      }
    }
  }

 private:
  std::span<const Law> laws_;
  std::span<const std::uint32_t> kind_;
  double step_;
  std::vector<Memory> memory_;
};

/// A bank that steps the memories of neighbouring contacts under one law all at once; see column_arms.hpp.
template <class Bank>
concept StepsInBlocks = requires(Bank& bank, std::size_t first, const double* overlaps) {
  bank.advance_steps(first, first, overlaps, overlaps);
};

}  // namespace ricochet::motion
