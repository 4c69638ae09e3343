#pragma once

#include <cstdint>

namespace ricochet::simulate {

/// The same numbers on every machine: SplitMix64 (Steele, Lea and Flood, OOPSLA 2014), and distributions made of sums,
/// products and comparisons alone, as those of the standard library and logarithms of the C library differ from one to
/// the next.
class Random {
 public:
  explicit Random(std::uint64_t seed) noexcept : state_(seed) {}
  /// One of many that say nothing about each other.
  Random(std::uint64_t seed, std::uint64_t stream) noexcept : state_(seed) {
    state_ = bits() ^ stream;
    state_ = bits();
  }

  std::uint64_t bits() noexcept;
  double uniform() noexcept { return static_cast<double>(bits() >> 11) * 0x1p-53; }  ///< in [0, 1)
  double between(double low, double high) noexcept { return low + (high - low) * uniform(); }
  /// Mean 0, deviation 1, by comparing uniform numbers: Karney, ACM Trans. Math. Softw. 42, 3 (2016), algorithm N.
  double normal() noexcept;

 private:
  bool happens(double minus_log) noexcept;  // with probability e^−x

  std::uint64_t state_;
};

/// e^x by sums and products, to 1e-14 of itself for |x| ≤ 50.
double exponential(double x) noexcept;

}  // namespace ricochet::simulate
