#pragma once

#include <memory>

namespace ricochet {

namespace fractional {
class PreparedMittagLeffler;
}

/// The two-parameter Mittag-Leffler function (53), E_{a,b}(x) = Σ_k x^k/Γ(ak + b), of real x.
///
/// Domain: 0 < a ≤ 3, 0 < b ≤ 120, −1e6 ≤ x ≤ 5; anything else throws std::invalid_argument naming the value. A value
/// past the largest double (small a, x > 1) throws std::overflow_error; one below the smallest is returned as 0.
///
/// Error: |error| ≤ 1e-13·max(1, b/100)·|E| + 20 ε·|x E'(x)|, ε = 2.2e-16: full relative accuracy in the tails as
/// well (for b = a too, which decays as x^-2), 20 roundings of x near a zero. The bound is measured, see
/// tests/fractional. It grows with b by the rounding of the exponent (a−b) ln s of the integrand, ½ε b ln b, which is
/// 0.6e-13 at b = 120.
///
/// Method: the inverse Laplace integral (1/2πi) ∫ e^s s^{a−b}/(s^a − x) ds on one fixed hyperbola by the trapezoidal
/// rule. The poles s^a = x are added in closed form, each with the factor that makes rule plus pole exact wherever the
/// pole lies, also on the contour. For x ≤ −1 the leading term −1/(x Γ(b−a)) is split off, and near a = 1 with b near 0
/// or 1, where the whole tail vanishes with a − 1, the integrand of a = 1 is subtracted; for a < 0.1, where it hardly
/// depends on s, its constant part. So the digits of small tails come from
/// 1/Γ and expm1 and not from a difference of large numbers. On an AMD EPYC 0.5–1.2 µs a value.
double mittag_leffler(double a, double b, double x);

/// E_{a,b} prepared for many x at one (a, b); see `mittag_leffler` for domain and error. Polynomials of degree 15 take
/// over where they are faster, interpolating the values of the method above; about 10 ns a value for a ≥ 1 and x ≥ −16,
/// 50–200 ns elsewhere, 0.2 ms to prepare. Immutable, cheap to copy, safe to share between threads.
class MittagLeffler {
 public:
  MittagLeffler(double a, double b);

  double a() const noexcept;
  double b() const noexcept;
  double operator()(double x) const;

 private:
  std::shared_ptr<const fractional::PreparedMittagLeffler> prepared_;
};

}  // namespace ricochet
