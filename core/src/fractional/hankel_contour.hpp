#pragma once

#include <array>
#include <complex>
#include <cstddef>

namespace ricochet::detail {

/// One trapezoidal node of ½ of a symmetric Hankel contour; the mirrored half is in the weight.
struct ContourNode {
  std::complex<double> s, log_s;
  std::complex<double> weight;  ///< so that Σ Re(weight·e^s·F(s)) ≈ (1/2πi) ∫ e^s F(s) ds
};

/// The hyperbola s(u) = μ(1 + sin(iu − φ)), −∞ < u < ∞, around the negative axis, with the trapezoidal rule of step h in
/// u. (Weideman and Trefethen, Math. Comp. 76, 1341 (2007), for the contour; μ is kept small, so that e^s never exceeds
/// e^1 on it and rounding is not amplified.) Two interlaced grids are offered, so that one of them is at
/// least h/4 away from any point.
class HankelContour {
 public:
  static constexpr std::size_t capacity = 72;
  enum Grid { on_axis = 0, off_axis = 1 };  ///< whether u = 0 is a node

  /// For integrands that behave as s^{-β} towards the cut; the apex of the contour follows the saddle of e^s s^{-β}.
  explicit HankelContour(double beta);

  std::size_t size() const noexcept { return size_; }
  const ContourNode& node(Grid g, std::size_t k) const noexcept { return nodes_[g][k]; }

  /// u with s(u) = s, in |arg s| < π.
  std::complex<double> parameter(std::complex<double> s) const;
  /// The grid whose nodes are farther from Re u.
  Grid grid_away_from(std::complex<double> u) const;
  /// What the trapezoidal rule leaves out of a simple pole at u: 1 far right of the contour, 0 far left, and in between
  /// exactly what makes rule + factor·residue independent of the contour: 1/(1 − exp(−2πi(u − u_0)/h)).
  std::complex<double> pole_factor(std::complex<double> u, Grid g) const;

 private:
  double mu_, step_;
  std::size_t size_;
  std::array<std::array<ContourNode, capacity>, 2> nodes_;
};

/// e^z − 1 without cancellation for small z.
std::complex<double> expm1(std::complex<double> z);

}  // namespace ricochet::detail
