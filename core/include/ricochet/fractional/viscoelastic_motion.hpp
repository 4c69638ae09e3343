#pragma once

#include <array>
#include <complex>
#include <vector>

namespace ricochet {

/// The modulus of a spring beside an arm of a springpot and a spring in series, per unit of mass,
///   M(s) = spring + pot s^α/(1 + softness pot s^α)
/// of s the Laplace variable; softness 0 leaves the springpot alone (Kelvin–Voigt), pot = k₁τ^α and softness = 1/k₁ are
/// Zener's.
struct ViscoelasticModulus {
  double spring;    ///< > 0 [s^{−2}]
  double pot;       ///< > 0 [s^{α−2}]
  double softness;  ///< ≥ 0 [s²]
  double alpha;     ///< 0 < α ≤ 1
};

/// The motion x'' + M x = 0 from x = 0, x' = 1, exactly: the inverse Laplace transforms of
///   x: 1/(s² + M),  x': s/(s² + M),  R = −x'': M/(s² + M),  R': sM/(s² + M).
///
/// Method: (1/2πi) ∫ e^{st} F(s) ds by the trapezoidal rule on one fixed hyperbola around the cut, scaled by t, and the
/// residues of the pair of poles s² + M(s) = 0 with the factor that makes rule plus pole exact wherever the pole lies
/// (as in mittag_leffler.hpp). On the principal sheet there is one pair at most: s ↦ i√M(s) maps the second quadrant
/// into itself, so that by Schwarz and Pick it has one fixed point there at most, to which its iterates go. From F the
/// transform of a dashpot's motion, γ = t (M(1/t) − spring), is taken out and its e^{−γt} added in closed form.
/// The rest vanishes with 1 − α and the spring: the small velocities of a strongly damped rebound keep their digits.
///
/// Error: 1e-13 relative to the greatest value of each, and 1e-12 of the value itself where the motion has lost all
/// oscillation (measured in tests/fractional against sums and quadratures of 50 digits). Times in a unit in which the
/// larger of √M's parts is about 1. Some 0.3 µs a value, 10 µs to prepare. Immutable.
class ViscoelasticMotion {
 public:
  /// Throws std::invalid_argument for a modulus outside its domain.
  explicit ViscoelasticMotion(const ViscoelasticModulus& modulus);

  // At t > 0.
  double overlap(double t) const { return value(0, t); }
  double rate(double t) const { return value(1, t); }
  double force(double t) const { return value(2, t); }        ///< R per unit of mass
  double force_slope(double t) const { return value(3, t); }  ///< dR/dt

  /// The pole in the second quadrant: how the motion oscillates, and how fast it decays.
  std::complex<double> pole() const noexcept { return pole_; }

 private:
  using Complex = std::complex<double>;

  Complex modulus(Complex s, Complex power) const;
  Complex modulus_slope(Complex s) const;
  void find_pole();
  double value(int what, double t) const;
  double pot_motion(int what, double t, double gamma) const;

  ViscoelasticModulus m_;
  Complex pole_, pole_weight_;                           // e^{pt} comes with 1/(2p + M'(p))
  std::array<std::vector<Complex>, 2> power_, deficit_;  // of both grids: z^α and 1 − z^{α−1}
};

}  // namespace ricochet
