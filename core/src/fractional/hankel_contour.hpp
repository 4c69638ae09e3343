#pragma once

#include <array>
#include <complex>
#include <cstddef>

namespace ricochet::fractional {

using Complex = std::complex<double>;

/// The trapezoidal nodes of ½ of a symmetric Hankel contour; the mirrored half is in the weights:
/// Σ Re(weight·F(s)) ≈ (1/2πi) ∫ e^s F(s) ds. Parts apart, for loops over all nodes.
struct ContourNodes {
  static constexpr std::size_t capacity = 48;
  using Row = std::array<double, capacity>;
  Row s_re, s_im, log_size, argument;              ///< s, log |s|, arg s
  Row weight_re, weight_im, over_s_re, over_s_im;  ///< weight, weight/s
};

/// The hyperbola s(u) = μ(1 + sin(iu − φ)), −∞ < u < ∞, around the negative axis, with the trapezoidal rule of step h
/// in u. (Weideman and Trefethen, Math. Comp. 76, 1341 (2007), for the contour; μ is kept small here, so that e^s never
/// exceeds e^1.3 on it and rounding is not amplified.) Two interlaced grids are offered, so that one of them is at
/// least h/4 away from any point.
class HankelContour {
 public:
  enum Grid { on_axis = 0, off_axis = 1 };  ///< whether u = 0 is a node

  /// For integrands that behave as s^{-β} towards the cut; the apex of the contour follows the saddle of e^s s^{-β}.
  explicit HankelContour(double beta);

  std::size_t size() const noexcept { return size_; }
  const ContourNodes& nodes(Grid g) const noexcept { return nodes_[g]; }

  /// u with s(u) = s, in |arg s| < π.
  Complex parameter(Complex s) const;
  /// The grid whose nodes are farther from Re u.
  Grid grid_away_from(Complex u) const;

  /// What the trapezoidal rule leaves out of a simple pole at u: 1 far right of the contour, 0 far left, and in between
  /// exactly what makes rule + factor·residue independent of the contour: 1/(1 − exp(−2πi(u − u_0)/h)).
  Complex pole_factor(Complex u, Grid g) const;
  /// The same less 1: what is left when the whole residue is accounted for elsewhere.
  Complex pole_factor_less_one(Complex u, Grid g) const;

 private:
  Complex turns(Complex u, Grid g) const;

  double mu_, step_;
  std::size_t size_;
  std::array<ContourNodes, 2> nodes_{};
};

/// The contour for E_{a,b}, b ≤ 120: one shared by all b up to some limit, laid out once a process.
const HankelContour& contour_for(double b);

/// e^z − 1 without cancellation for small z.
Complex expm1(Complex z);

/// Products without the checks for infinities that std::complex makes.
inline Complex product(Complex p, Complex q) {
  return {p.real() * q.real() - p.imag() * q.imag(), p.real() * q.imag() + p.imag() * q.real()};
}

}  // namespace ricochet::fractional
