#include <ricochet/fractional/viscoelastic_motion.hpp>
#include <ricochet/support/require.hpp>

#include "hankel_contour.hpp"

#include <cmath>

namespace ricochet {

using fractional::contour_for;
using fractional::HankelContour;
using fractional::product;

ViscoelasticMotion::ViscoelasticMotion(const ViscoelasticModulus& modulus) : m_(modulus) {
  support::require_positive("spring", m_.spring);
  support::require_positive("pot", m_.pot);
  support::require_not_negative("softness", m_.softness);
  support::require(m_.alpha > 0 && m_.alpha <= 1, "alpha", m_.alpha, "in (0, 1]");
  const HankelContour& contour = contour_for(1);
  for (const auto grid : {HankelContour::on_axis, HankelContour::off_axis}) {
    const auto& nodes = contour.nodes(grid);
    for (std::size_t k = 0; k < contour.size(); ++k) {
      const Complex log_z(nodes.log_size[k], nodes.argument[k]);
      power_[grid].push_back(std::exp(m_.alpha * log_z));
      deficit_[grid].push_back(-fractional::expm1((m_.alpha - 1) * log_z));
    }
  }
  find_pole();
}

/// `power` = s^α.
ViscoelasticMotion::Complex ViscoelasticMotion::modulus(Complex, Complex power) const {
  return m_.spring + m_.pot * power / (1.0 + m_.softness * m_.pot * power);
}

ViscoelasticMotion::Complex ViscoelasticMotion::modulus_slope(Complex s) const {
  const Complex power = std::pow(s, m_.alpha), series = 1.0 + m_.softness * m_.pot * power;
  return m_.alpha * m_.pot * power / s / (series * series);
}

// The iterates of i√M(s) near the fixed point, Newton's method to the last digit. Where that leaves the quadrant or the
// iterates stay slow, the pole is at the cut, where the rule has no need of it.
void ViscoelasticMotion::find_pole() {
  constexpr Complex i(0, 1);
  const auto at = [&](Complex s) { return modulus(s, std::pow(s, m_.alpha)); };
  Complex s = std::sqrt(m_.spring + m_.pot) * Complex(-0.6, 0.8);
  for (int n = 0; n < 400; ++n) {
    const Complex next = i * std::sqrt(at(s));
    const double change = std::abs(next - s);
    s = next;
    if (change < 1e-4 * std::abs(s)) break;
  }
  for (int n = 0; n < 8; ++n) {
    const Complex next = s - (s * s + at(s)) / (2.0 * s + modulus_slope(s));
    if (!(next.imag() > 0 && next.real() <= 0)) break;
    s = next;
  }
  pole_ = s;
  pole_weight_ = 1.0 / (2.0 * s + modulus_slope(s));
}

/// The same of M = γ s: x = (1 − e^{−γt})/γ and its derivatives.
double ViscoelasticMotion::pot_motion(int what, double t, double gamma) const {
  if (what == 0) return -std::expm1(-gamma * t) / gamma;
  const double decay = std::exp(-gamma * t);
  return what == 1 ? decay : what == 2 ? gamma * decay : -gamma * gamma * decay;
}

// With d = γ − M/s the transforms less those of γs are x: d/(s (s + M/s)(s + γ)) and s, −s², −s³ times that.
double ViscoelasticMotion::value(int what, double t) const {
  const HankelContour& contour = contour_for(1);
  const Complex u = contour.parameter(pole_ * t);
  const auto grid = contour.grid_away_from(u);
  const auto& nodes = contour.nodes(grid);
  const double pot = m_.pot * std::pow(t, -m_.alpha), rigid = m_.softness * pot, gamma = pot * t / (1 + rigid);
  double sum = 0;
  for (std::size_t k = 0; k < contour.size(); ++k) {
    const Complex s(nodes.s_re[k] / t, nodes.s_im[k] / t), inverse = 1.0 / s;
    const Complex deficit = deficit_[grid][k], series = gamma / (1.0 + rigid * power_[grid][k]);
    const Complex spring = m_.spring * inverse;
    const Complex arm = product((1 + rigid) * (1.0 - deficit), series);  // M/s is that and spring
    const Complex difference = product(deficit + rigid * product(1.0 - deficit, t * s - 1.0), series) - spring;
    const Complex rate = difference / product(s + spring + arm, s + gamma);
    Complex value = rate;
    if (what == 0) value = product(rate, inverse);
    for (int n = 1; n < what; ++n) value = product(value, n == 1 ? -s : s);
    sum += nodes.weight_re[k] * value.real() - nodes.weight_im[k] * value.imag();
  }
  double result = pot_motion(what, t, gamma) + sum / t;
  const Complex factor = contour.pole_factor(u, grid);
  if (factor != 0.0) {
    Complex residue = pole_weight_ * std::exp(pole_ * t);
    for (int n = 0; n < what; ++n) residue *= n == 1 ? -pole_ : pole_;
    result += 2 * (factor * residue).real();
  }
  return result;
}

}  // namespace ricochet
