// Exact motions of viscoelastic oscillators against the double series of Kelvin and Voigt's, in 50 digits, against
// quadratures of the cut's integral, and against sums of exponentials where α = 1.

#include <ricochet/fractional/viscoelastic_motion.hpp>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace ricochet;

namespace {

using Real = boost::multiprecision::cpp_bin_float_50;
using Complex = std::complex<double>;

/// x = Σ (−1)^{i+j} C(i+j, j) g^j t^{2i+(2−α)j+1}/Γ(2i+(2−α)j+2), or its n-th derivative, at k = m = 1.
double by_series(double pot, double alpha, int derivative, double t) {
  const Real time(t), square = time * time;
  Real sum = 0;
  for (int j = 0; j < 40; ++j) {
    const Real z = (2 - Real(alpha)) * j + 1 - derivative;
    Real term = 0;
    for (int i = 0; i < 40; ++i) {
      const Real power = z + 2 * i;
      if (power < 0 && j == 0) continue;  // the derivatives of t
      if (term == 0)
        term = (i + j) % 2 == 0 ? Real(1) : Real(-1),
        term *= pow(Real(pot), Real(j)) * pow(time, power) / tgamma(power + 1);
      else
        term *= -Real(i + j) / i * square / (power * (power - 1));
      sum += term;
    }
  }
  return static_cast<double>(sum);
}

/// Twice the residue at the pole, and what e^{−rt} leaves of the cut: another path of the same inversion.
double by_cut(const ViscoelasticModulus& m, Complex pole, int derivative, double t) {
  const auto modulus = [&](Complex s) {
    const Complex power = std::pow(s, m.alpha);
    return m.spring + m.pot * power / (1.0 + m.softness * m.pot * power);
  };
  const Complex power = std::pow(pole, m.alpha), series = 1.0 + m.softness * m.pot * power;
  const Complex slope = 2.0 * pole + m.alpha * m.pot * power / pole / (series * series);
  const double residue = 2 * (std::pow(pole, derivative) * std::exp(pole * t) / slope).real();
  const auto integrand = [&](double log_r) {
    const double r = std::exp(log_r);
    const Complex at = modulus(std::polar(r, std::numbers::pi));
    return r * std::pow(-r, derivative) * std::exp(-r * t) * at.imag() / std::norm(r * r + at);
  };
  boost::math::quadrature::tanh_sinh<double> rule;
  double sum = 0;  // in pieces, as the integrand has a peak at |pole|
  for (int piece = -24; piece < 8; ++piece) sum += rule.integrate(integrand, piece, piece + 1.0);
  return residue + sum / std::numbers::pi;
}

void check_close(double got, double exact, double scale, double bound) {
  CAPTURE(got, exact);
  CHECK(std::abs(got - exact) <= bound * scale);
}

}  // namespace

TEST_CASE("a Kelvin-Voigt motion is its double series") {
  for (const double alpha : {0.05, 0.25, 0.5, 0.75, 0.97})
    for (const double pot : {0.01, 0.5, 2.0})
      for (const double t : {0.03, 0.7, 2.5}) {
        CAPTURE(alpha, pot, t);
        const ViscoelasticMotion motion({1, pot, 0, alpha});
        check_close(motion.overlap(t), by_series(pot, alpha, 0, t), t, 1e-13);
        check_close(motion.rate(t), by_series(pot, alpha, 1, t), 1, 1e-13);
        check_close(motion.force(t), -by_series(pot, alpha, 2, t), 1 + pot, 1e-13);
        check_close(motion.force_slope(t), -by_series(pot, alpha, 3, t), (1 + pot) / t, 1e-12);
      }
}

TEST_CASE("a Zener motion is what its pole and its cut make of it") {
  for (const double alpha : {0.2, 0.5, 0.8})
    for (const double k1 : {0.5, 10.0})
      for (const double tau : {0.01, 0.3, 5.0}) {
        CAPTURE(alpha, k1, tau);
        const ViscoelasticModulus m{1, k1 * std::pow(tau, alpha), 1 / k1, alpha};
        const ViscoelasticMotion motion(m);
        for (const double t : {0.4, 1.5, 3.0}) {
          check_close(motion.overlap(t), by_cut(m, motion.pole(), 0, t), 1, 1e-11);
          check_close(motion.rate(t), by_cut(m, motion.pole(), 1, t), 1, 1e-11);
          check_close(motion.force(t), -by_cut(m, motion.pole(), 2, t), 1 + k1, 1e-11);
        }
      }
}

TEST_CASE("at α = 1 an overdamped motion is two exponentials, to the last digits of its slow one") {
  for (const double damping : {1.5, 30.0, 1e4}) {
    CAPTURE(damping);
    const double root = std::sqrt((damping - 1) * (damping + 1)), slow = 1 / (damping + root), fast = damping + root;
    const ViscoelasticMotion motion({1, 2 * damping, 0, 1});
    for (const double t : {0.1 / fast, 3 / fast, 30 / fast}) {
      const double rate = (fast * std::exp(-fast * t) - slow * std::exp(-slow * t)) / (2 * root);
      check_close(motion.rate(t), rate, std::abs(rate), 1e-11);
    }
  }
}

TEST_CASE("a viscoelastic motion refuses what is none") {
  CHECK_THROWS_WITH(ViscoelasticMotion({0, 1, 0, 0.5}), Catch::StartsWith("spring = 0"));
  CHECK_THROWS_WITH(ViscoelasticMotion({1, 0, 0, 0.5}), Catch::StartsWith("pot = 0"));
  CHECK_THROWS_WITH(ViscoelasticMotion({1, 1, -1, 0.5}), Catch::StartsWith("softness = -1"));
  CHECK_THROWS_WITH(ViscoelasticMotion({1, 1, 0, 0}), Catch::StartsWith("alpha = 0"));
}
