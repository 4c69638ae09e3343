#pragma once

#include <vector>

namespace ricochet {

/// A polynomial in Chebyshev form on [0, end].
class ChebyshevSeries {
 public:
  ChebyshevSeries() = default;
  ChebyshevSeries(std::vector<double> coefficients, double end);

  double operator()(double y) const;
  ChebyshevSeries derivative() const;
  const std::vector<double>& coefficients() const noexcept { return coefficients_; }
  double end() const noexcept { return end_; }

 private:
  std::vector<double> coefficients_;
  double end_ = 1;
};

/// The motion of m ζ'' + c^α k^{1−α} D^α ζ = 0 from ζ = 0, ζ' = v₀, by collocation of its Volterra equation
///   ζ'(t) = v₀ − A/Γ(2−α) ∫_0^t (t−s)^{1−α} ζ'(s) ds,  A = c^α k^{1−α}/m,
/// in the units v₀ = A = 1 (time in A^{−1/(2−α)}). In y = t^{2−α} the solution is entire, so a polynomial in y (a Müntz
/// polynomial in t) converges faster than any power of the number of nodes. Independent of the Mittag-Leffler function.
///
///   ζ' = rate(y),  R/(m A v₀) = t^{1−α} force(y),  ζ = t overlap(y),  0 ≤ y ≤ end.
///
/// Domain: α < 1 (α ≥ −2), 4 ≤ nodes ≤ 120, 1e-150 ≤ end ≤ 1e150; throws std::invalid_argument otherwise. The error
/// is that of Chebyshev interpolation; at end = 10.5 and 24 nodes it is near rounding for all 0 ≤ α ≤ 1, see
/// tests/fractional.
struct FractionalMotion {
  ChebyshevSeries rate, force, overlap;
};

FractionalMotion collocate_motion(double alpha, int nodes, double end);

}  // namespace ricochet
