#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>

namespace ricochet::support {

/// The polynomial of degree 15 through a function's values at the Chebyshev points of [low, high], by powers of the
/// local variable in [−1, 1]. To be used where the function's Chebyshev coefficients fall to rounding well before the
/// last: then the powers lose nothing, and they can be summed as a tree.
class Panel {
 public:
  static constexpr std::size_t size = 16;
  using Row = std::array<double, size>;

  /// The abscissae, j < size.
  static double abscissa(std::size_t j, double low, double high) {
    return 0.5 * (low + high) + 0.5 * (high - low) * std::cos(angle(j));
  }

  /// From the values at the abscissae.
  Panel(const Row& value, double low, double high) : centre_(0.5 * (low + high)), scale_(2 / (high - low)) {
    Row before{}, powers{1};  // of T_{k−1} and T_k
    for (std::size_t k = 0; k < size; ++k) {
      const double c = coefficient(value, k);
      for (std::size_t i = 0; i < size; ++i) c_[i] += c * powers[i];
      Row after{};
      for (std::size_t i = 1; i < size; ++i) after[i] = (k == 0 ? 1 : 2) * powers[i - 1];
      for (std::size_t i = 0; k > 0 && i < size; ++i) after[i] -= before[i];
      before = powers;
      powers = after;
    }
  }

  template <class F>
  requires std::is_invocable_r_v<double, const F&, double> Panel(const F& f, double low, double high)
      : Panel(sample(f, low, high), low, high) {}

  double operator()(double x) const noexcept {
    const double t = (x - centre_) * scale_, t2 = t * t, t4 = t2 * t2, t8 = t4 * t4;
    const auto four = [&](std::size_t i) { return (c_[i] + c_[i + 1] * t) + (c_[i + 2] + c_[i + 3] * t) * t2; };
    return (four(0) + four(4) * t4) + (four(8) + four(12) * t4) * t8;
  }

 private:
  template <class F>
  static Row sample(const F& f, double low, double high) {
    Row value{};
    for (std::size_t j = 0; j < size; ++j) value[j] = f(abscissa(j, low, high));
    return value;
  }

  static double angle(std::size_t j) { return std::numbers::pi * (static_cast<double>(j) + 0.5) / size; }
  static double coefficient(const Row& value, std::size_t k) {
    double sum = 0;
    for (std::size_t j = 0; j < size; ++j) sum += value[j] * std::cos(static_cast<double>(k) * angle(j));
    return sum * (k == 0 ? 1.0 : 2.0) / size;
  }

  double centre_ = 0, scale_ = 0;
  Row c_{};
};

}  // namespace ricochet::support
