#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ricochet {

/// A discrete fractional operator on a uniform mesh t_l = l h, l = 0..N: a convolution of the samples, with the weights
/// of the first two samples set right because the mesh starts there,
///   y_n = Σ_{l=0}^{n} w_{n−l} x_l + first_n x_0 + second_n x_1.
/// The samples are those of the function itself or of its rate, as each rule below says. Immutable.
class ConvolutionRule {
 public:
  /// `first` and `second` may be empty (all zero). Throws std::invalid_argument unless lengths agree and are > 0, and
  /// all weights are finite.
  explicit ConvolutionRule(std::vector<double> weights, std::vector<double> first = {},
                           std::vector<double> second = {});

  /// Number of samples that the rule can take, N+1.
  std::size_t size() const noexcept { return weights_.size(); }
  std::span<const double> weights() const noexcept { return weights_; }
  std::span<const double> first() const noexcept { return first_; }
  std::span<const double> second() const noexcept { return second_; }

  /// y_n at the last of the samples given; N+1 multiplications.
  double last(std::span<const double> samples) const;
  /// y_0..y_n, each from its full history: n²/2 multiplications.
  std::vector<double> all(std::span<const double> samples) const;

 private:
  void check(std::span<const double> samples) const;
  double edge(std::span<const double> samples, std::size_t n) const;

  std::vector<double> weights_, first_, second_;
};

// The rules. Orders are of the error at a fixed time t > 0 as h → 0, for functions as smooth as the contact's own
// motion (ζ' = v₀ + O(t^{2−α}), analytic in t^{2−α}); docs/theory/orders.md derives them. All throw
// std::invalid_argument unless 0 < alpha < 1 (0 < beta ≤ 10), step > 0, and where the weights, powers of h, are no
// normal doubles; `steps` is N.

/// (59) as written, from samples of the rate: D^α f = 1/Γ(2−α) [f'_0 t^{1−α} + Σ (f'_l − f'_{l−1})(t−t_l)^{1−α}]: the
/// rate is held at its left value over each step. Order 1 (exact for f = t).
ConvolutionRule rectangle_derivative(double alpha, double step, std::size_t steps);

/// (60) as written, from samples of f: I^β f = 1/Γ(β+1) [f_0 t^β + Σ (f_l − f_{l−1})(t−t_l)^β]. Order 1 (exact for
/// constants). (59) is (60) of the rate with β = 1−α.
ConvolutionRule rectangle_integral(double beta, double step, std::size_t steps);

/// L1, from samples of f: f linear over each step. Order 2−α (exact for f = t).
ConvolutionRule l1_derivative(double alpha, double step, std::size_t steps);

/// L1-2 (Gao, Sun, Zhang, J. Comput. Phys. 259, 33 (2014)), from samples of f: f quadratic through the three points up
/// to each step's end, linear over the first step. Order 3−α (exact for f = t).
ConvolutionRule l12_derivative(double alpha, double step, std::size_t steps);

/// Product trapezoid for the derivative, from samples of the rate: rate linear over each step. Order 2 (exact for t,
/// t²).
ConvolutionRule trapezoid_derivative(double alpha, double step, std::size_t steps);

/// Product trapezoid for the integral of order β, from samples of f: f linear over each step. Order 2 (exact for 1, t).
ConvolutionRule trapezoid_integral(double beta, double step, std::size_t steps);

/// Grünwald-Letnikov, from samples of f: h^{−α} Σ (−1)^j C(α, j) f_{n−j}. Order 1, for f(0) = 0.
ConvolutionRule gruenwald_letnikov_derivative(double alpha, double step, std::size_t steps);

/// The last node's value on any mesh 0 = t_0 < t_1 < … : L1 (from samples of f) and the product trapezoid (from samples
/// of the rate). With f ~ t^{1+σ}, 0 < σ < 1, at the start, a uniform mesh leaves errors of order 1+σ−α in the first
/// steps; on t_l = T (l/N)^r the orders 2−α and 2 hold at every node for r ≥ (2−α)/(1+σ−α) and r ≥ 2/(1+σ−α).
double l1_derivative(double alpha, std::span<const double> times, std::span<const double> values);
double trapezoid_derivative(double alpha, std::span<const double> times, std::span<const double> rates);

/// t_l = end·(l/N)^grading, l = 0..N.
std::vector<double> graded_mesh(double end, std::size_t steps, double grading);

}  // namespace ricochet
