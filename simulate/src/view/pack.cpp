#include "pack.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace ricochet::simulate {

Quanta::Quanta(double first, double last, bool wide)
    : low(first),
      greatest(wide ? std::numeric_limits<std::uint32_t>::max() : std::numeric_limits<std::uint16_t>::max()) {
  quantum = (last - first) / greatest;
}

std::uint32_t Quanta::of(double value) const noexcept {
  if (!(quantum > 0)) return 0;
  return static_cast<std::uint32_t>(
      std::clamp(std::round((value - low) / quantum), 0.0, static_cast<double>(greatest)));
}

void Bytes::add(std::uint32_t number, int bytes) {
  for (int k = 0; k < bytes; ++k) bytes_.push_back(static_cast<std::uint8_t>(number >> (8 * k)));
}

void Bytes::add(float number) { add(std::bit_cast<std::uint32_t>(number), 4); }

std::string Bytes::base64() const {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes_.size() + 2) / 3 * 4);
  for (std::size_t k = 0; k < bytes_.size(); k += 3) {
    const std::size_t held = std::min<std::size_t>(3, bytes_.size() - k);
    std::uint32_t word = 0;
    for (std::size_t b = 0; b < 3; ++b) word = word << 8 | (b < held ? bytes_[k + b] : 0);
    for (std::size_t d = 0; d < 4; ++d) text += d > held ? '=' : digits[word >> (18 - 6 * d) & 63];
  }
  return text;
}

}  // namespace ricochet::simulate
