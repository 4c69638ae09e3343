#include "hankel_contour.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace ricochet::fractional {

using std::numbers::pi;

namespace {

constexpr double angle = 0.82;  // φ: about as far from the cut (π/2 − φ) as from the line where e^s grows (φ)

}  // namespace

HankelContour::HankelContour(double beta) {
  const double apex = std::max(1.28, beta - 1);  // s(0) = μ(1 − sin φ)
  mu_ = apex / (1 - std::sin(angle));
  // The saddle of e^s s^{-β} has the width √β in s, so 1/√β in u.
  step_ = 0.1 / std::sqrt(std::max(1.0, beta / 2.5));
  // The last node is where e^s has fallen by e^-44 below the apex, algebraic factors included generously.
  const double reach = std::acosh(1 + 44 / (mu_ * std::sin(angle)));
  size_ = std::min(ContourNodes::capacity, static_cast<std::size_t>(reach / step_) + 1);
  for (const Grid g : {on_axis, off_axis}) {
    for (std::size_t k = 0; k < size_; ++k) {
      const double u = (static_cast<double>(k) + (g == off_axis ? 0.5 : 0.0)) * step_;
      const double mirrored = u == 0 ? 1 : 2;
      const Complex s = mu_ * Complex(1 - std::sin(angle) * std::cosh(u), std::cos(angle) * std::sinh(u));
      const Complex slope = mu_ * Complex(std::cos(angle) * std::cosh(u), std::sin(angle) * std::sinh(u));
      const Complex weight = mirrored * step_ / (2 * pi) * slope * std::exp(s), over_s = weight / s,
                    log_s = std::log(s);
      ContourNodes& n = nodes_[g];
      n.s_re[k] = s.real(), n.s_im[k] = s.imag();
      n.log_size[k] = log_s.real(), n.argument[k] = log_s.imag();
      n.weight_re[k] = weight.real(), n.weight_im[k] = weight.imag();
      n.over_s_re[k] = over_s.real(), n.over_s_im[k] = over_s.imag();
    }
  }
}

Complex HankelContour::parameter(Complex s) const {
  // 1 + sin θ = 2 sin²(θ/2 + π/4), θ = iu − φ, avoids the cancellation near s = 0.
  if (s.imag() == 0 && s.real() >= 0) {
    const double root = std::sqrt(s.real() / (2 * mu_));
    if (root > 1) return {2 * std::acosh(root), -pi / 2 - angle};
    return {0, pi / 2 - angle - 2 * std::asin(root)};
  }
  const Complex iu = angle - pi / 2 + 2.0 * std::asin(std::sqrt(s / (2 * mu_)));
  return {iu.imag(), -iu.real()};
}

HankelContour::Grid HankelContour::grid_away_from(Complex u) const {
  const double position = u.real() / step_;
  return std::abs(position - std::round(position)) < 0.25 ? off_axis : on_axis;
}

Complex HankelContour::turns(Complex u, Grid g) const {
  return Complex(0, -2 * pi) * (u / step_ - (g == off_axis ? 0.5 : 0.0));
}

Complex HankelContour::pole_factor(Complex u, Grid g) const {
  const Complex q = turns(u, g);
  if (q.real() > 41) return 0;   // so near the cut that it belongs to the branch point, which the rule resolves
  if (q.real() < -41) return 1;  // beyond the strip over which e^s lets the rule be shifted
  return -1.0 / expm1(q);
}

Complex HankelContour::pole_factor_less_one(Complex u, Grid g) const {
  const Complex q = turns(u, g);
  if (q.real() > 41) return -1;
  if (q.real() < -41) return 0;
  return -std::exp(q) / expm1(q);
}

namespace {

// Contours for all b up to (√2.5 + 0.4 n)², each laid out where it is first asked for. One that fits a b greater by the
// share δ has its apex that much too far out, which costs a factor exp(b(δ − ln(1+δ))) ≈ exp(bδ²/2) < 1.4 of rounding.
constexpr double first_root = 1.5811388300841898, root_step = 0.4;

template <int N>
const HankelContour& shared_contour() {
  static const HankelContour contour((first_root + N * root_step) * (first_root + N * root_step));
  return contour;
}

template <int... N>
const HankelContour& shared_contour(std::size_t n, std::integer_sequence<int, N...>) {
  constexpr const HankelContour& (*each[])() = {shared_contour<N>...};
  return each[n]();
}

}  // namespace

const HankelContour& contour_for(double b) {
  constexpr int count = 25;  // the last fits b up to (√2.5 + 0.4·24)² = 125
  const double n = std::max(0.0, std::ceil((std::sqrt(b) - first_root) / root_step));
  return shared_contour(static_cast<std::size_t>(n), std::make_integer_sequence<int, count>{});
}

Complex expm1(Complex z) {
  const double growth = std::expm1(z.real()), sine = std::sin(z.imag() / 2), cosine = std::cos(z.imag() / 2);
  const double turn = -2 * sine * sine;  // cos(Im z) − 1
  return {growth + turn + growth * turn, (growth + 1) * (2 * sine * cosine)};
}

}  // namespace ricochet::fractional
