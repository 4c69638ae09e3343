#include "hankel_contour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::detail {

using std::numbers::pi;
using Complex = std::complex<double>;

namespace {

constexpr double angle = 0.82;  // φ: nearly as far from the cut (π/2 − φ) as from the line where e^s grows (φ)

}  // namespace

HankelContour::HankelContour(double beta) {
  const double apex = std::max(1.28, beta - 1);  // s(0) = μ(1 − sin φ)
  mu_ = apex / (1 - std::sin(angle));
  // The saddle of e^s s^{-β} has the width √β in s, so 1/√β in u.
  step_ = 0.1 / std::sqrt(std::max(1.0, beta / 2.5));
  // The last node is where e^s has fallen by e^-44 below the apex, algebraic factors included generously.
  const double reach = std::acosh(1 + 44 / (mu_ * std::sin(angle)));
  size_ = std::min(capacity, static_cast<std::size_t>(reach / step_) + 1);
  for (const Grid g : {on_axis, off_axis}) {
    for (std::size_t k = 0; k < size_; ++k) {
      const double u = (static_cast<double>(k) + (g == off_axis ? 0.5 : 0.0)) * step_;
      const double mirrored = u == 0 ? 1 : 2;
      const Complex s = mu_ * Complex(1 - std::sin(angle) * std::cosh(u), std::cos(angle) * std::sinh(u));
      const Complex slope = mu_ * Complex(std::cos(angle) * std::cosh(u), std::sin(angle) * std::sinh(u));
      nodes_[g][k] = {s, std::log(s), mirrored * step_ / (2 * pi) * slope};
    }
  }
}

Complex HankelContour::parameter(Complex s) const {
  // 1 + sin θ = 2 sin²(θ/2 + π/4) avoids the cancellation near s = 0; θ = iu − φ.
  const Complex iu = angle - pi / 2 + 2.0 * std::asin(std::sqrt(s / (2 * mu_)));
  return {iu.imag(), -iu.real()};
}

HankelContour::Grid HankelContour::grid_away_from(Complex u) const {
  const double position = u.real() / step_;
  return std::abs(position - std::round(position)) < 0.25 ? off_axis : on_axis;
}

Complex HankelContour::pole_factor(Complex u, Grid g) const {
  const Complex exponent = Complex(0, -2 * pi) * (u / step_ - (g == off_axis ? 0.5 : 0.0));
  if (exponent.real() > 41) return 0;  // so near the cut that it belongs to the branch point, which the rule resolves
  return -1.0 / expm1(exponent);
}

Complex expm1(Complex z) {
  const double growth = std::expm1(z.real()), half = std::sin(z.imag() / 2);
  const double turn = -2 * half * half;  // cos − 1
  return {growth + turn + growth * turn, (growth + 1) * std::sin(z.imag())};
}

}  // namespace ricochet::detail
