#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace ricochet::simulate {

/// Whole numbers 0 … `greatest` for an interval of real ones: how a page keeps places and speeds.
struct Quanta {
  double low = 0, quantum = 0;
  std::uint32_t greatest = 0;

  /// From `low` to `high` by numbers of 16 bits, or of 32.
  Quanta(double low, double high, bool wide);
  /// The number whose value is nearest: off by half a quantum at most.
  std::uint32_t of(double value) const noexcept;
};

/// Numbers one after the other, their bytes from the lowest on.
class Bytes {
 public:
  void add(std::uint32_t number, int bytes);
  void add(float number);
  std::string base64() const;

 private:
  std::vector<std::uint8_t> bytes_;
};

}  // namespace ricochet::simulate
