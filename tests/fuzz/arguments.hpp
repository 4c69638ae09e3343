#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <stdexcept>

/// A fuzzer's bytes as the numbers that a function takes.
class Arguments {
 public:
  Arguments(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}

  /// Any bits; 1 when the input is spent.
  double number() {
    if (size_ < sizeof(double)) return 1;
    double value;
    std::memcpy(&value, data_, sizeof value);
    data_ += sizeof value, size_ -= sizeof value;
    return value;
  }
  /// In [0, 1), so that more inputs get past the first check.
  double share() { return std::fabs(std::fmod(number(), 1.0)); }
  std::uint8_t byte() {
    if (size_ == 0) return 0;
    return --size_, *data_++;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_;
};

inline void expect_finite(std::initializer_list<double> values) {
  for (const double value : values)
    if (!std::isfinite(value)) throw std::logic_error("a result marked good is not finite");
}
