#pragma once

// The best positive exponential sum for t^{−α}, the engine room of memory_kernel. Time is in units of δ.

#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <vector>

namespace ricochet::fractional {

inline constexpr long double pi = std::numbers::pi_v<long double>;

/// S(t) = spring + Σ strength_j exp(−rate_j t) ≈ t^{−α} on [1, R]. Long double, because the error of good sums (1e-12)
/// is so close to the rounding of double that the exchange of points would chase noise. The unknowns are logarithms:
/// positivity needs no thought and Newton's steps are relative.
class KernelFit {
 public:
  using Real = long double;
  using Vector = std::vector<Real>;

  KernelFit(Real alpha, Vector log_unknowns) : alpha_(alpha) { take(std::move(log_unknowns)); }

  std::size_t arms() const { return x_.size() / 2; }
  Real alpha() const { return alpha_; }
  Real spring() const { return std::exp(x_[0]); }
  Real strength(std::size_t j) const { return std::exp(x_[1 + j]); }
  Real rate(std::size_t j) const { return rate_[j]; }
  const Vector& unknowns() const { return x_; }

  /// 1 − S(t) t^α.
  Real deviation(Real t) const;
  /// ∫₀¹ S dτ; the true kernel has 1/(1−α).
  Real impulse() const;

  /// Makes the deviation alternate, (−1)^i·level, at `points` and the first moment ∫₀¹τS dτ = 1/(2−α). With 2n points
  /// the level stays (0: interpolation); with 2n+1 it is an unknown too. Damped Newton; false if it does not converge.
  bool meet(const Vector& points, Real& level, Real tolerance);

  /// Largest |deviation| of each half wave between sign changes on [1, R], where it is, and the sign changes.
  struct Waves {
    Vector extrema, zeros;
    Real highest = 0, lowest = 0;
  };
  Waves waves(Real ratio) const;

 private:
  void take(Vector log_unknowns);

  Real alpha_;
  Vector x_;     // log spring, log strengths, log rates
  Vector rate_;  // kept, as every value of S needs them
};

/// The sum with the fewest arms (at most max_arms) whose deviation on [1, ratio] is at most `tolerance`.
KernelFit fit_kernel(long double alpha, long double ratio, long double tolerance, std::size_t max_arms);

}  // namespace ricochet::fractional
