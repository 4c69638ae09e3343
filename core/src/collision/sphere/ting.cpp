// The impact on a power-law half-space by Ting's formulation; see power_law_sphere.hpp.

#include <ricochet/collision/power_law_sphere.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include "approach.hpp"
#include "quadrature.hpp"

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet {
namespace {

using collision::gauss_jacobi, collision::Quadrature, collision::SphereApproach;
using Eigen::MatrixXd, Eigen::VectorXd;

/// Polynomials through the Chebyshev points of [0, 1], and two linear maps of their values there.
struct Points {
  VectorXd x, barycentric;
  MatrixXd integral;  ///< to ∫_0^{x_i}
  MatrixXd memory;    ///< to ∫_0^{x_i} (x_i − y)^{−α} … dy

  Points(int degree, double alpha);
  /// The values' weights in the polynomial at y.
  VectorXd at(double y) const;
  double value(const VectorXd& values, double y) const { return at(y).dot(values); }
};

VectorXd Points::at(double y) const {
  VectorXd weights(x.size());
  for (Eigen::Index k = 0; k < x.size(); ++k) {
    if (y == x[k]) return VectorXd::Unit(x.size(), k);
    weights[k] = barycentric[k] / (y - x[k]);
  }
  return weights / weights.sum();
}

Points::Points(int degree, double alpha)
    : x(degree + 1),
      barycentric(degree + 1),
      integral(MatrixXd::Zero(degree + 1, degree + 1)),
      memory(MatrixXd::Zero(degree + 1, degree + 1)) {
  for (int i = 0; i <= degree; ++i) {
    const double half = 0.5 * std::numbers::pi * i / degree;
    x[i] = std::sin(half) * std::sin(half);
    barycentric[i] = (i % 2 == 0 ? 1 : -1) * (i == 0 || i == degree ? 0.5 : 1);
  }
  const Quadrature plain = gauss_jacobi(degree / 2 + 2, 0, 0), fading = gauss_jacobi(degree / 2 + 2, -alpha, 0);
  for (int i = 1; i <= degree; ++i)
    for (std::size_t q = 0; q < plain.node.size(); ++q) {
      integral.row(i) += x[i] * plain.weight[q] * at(x[i] * plain.node[q]).transpose();
      memory.row(i) += std::pow(x[i], 1 - alpha) * fading.weight[q] * at(x[i] * fading.node[q]).transpose();
    }
}

/// The return: ζ' at `points` of the time from the turning point on, in units of its length.
class Return {
 public:
  Return(double alpha, int nodes);
  SphereImpact solve();

 private:
  void settle();
  VectorXd forces();
  double felt(double t1, double t) const;
  double force(double t1, double t) const;
  double next_length();

  double alpha_, by_gamma_;
  SphereApproach approach_;
  Points points_;
  Quadrature plain_, rooted_;
  double length_;
  VectorXd rate_, derivative_;  // ζ', and D^α ζ, of which the last element's force is a multiple
};

Return::Return(double alpha, int nodes)
    : alpha_(alpha),
      by_gamma_(1 / std::tgamma(1 - alpha)),
      approach_(alpha),
      points_(nodes, alpha),
      plain_(gauss_jacobi(nodes + 8, 0, 0)),
      rooted_(gauss_jacobi(nodes + 8, 0, 0.5)),
      length_(approach_.turn()),
      rate_(-0.5 * points_.x),
      derivative_(VectorXd::Zero(nodes + 1)) {}

/// ∫ (t−s)^{−α} ζ'(s) ds / Γ(1−α) from t₁ to the turning point. t stands behind it by no less than a (1−α)-th of its
/// length where t₁ is the sought one, so Gauss's rule is not disturbed by the kernel.
double Return::felt(double t1, double t) const {
  const double span = approach_.turn() - t1;
  return by_gamma_ * span * plain_([&](double x) {
           const double s = t1 + span * x;
           return std::pow(t - s, -alpha_) * approach_.rate(s);
         });
}

/// Ting's force. The second half of [0, t₁], which comes close to t, is integrated over ln(t − s).
double Return::force(double t1, double t) const {
  const double half = 0.5 * t1;
  const double early = std::pow(half, 1.5) * rooted_([&](double x) {
                         return std::pow(t - half * x, -alpha_) * approach_.reduced_power_rate(half * x);
                       });
  const double nearest = std::log(t - t1), span = std::log((t - half) / (t - t1));
  const double late = span * plain_([&](double x) {
                        const double age = std::exp(nearest + span * x);
                        const double s = std::max(half, t - age);  // which rounding may miss
                        return std::pow(age, 1 - alpha_) * std::sqrt(s) * approach_.reduced_power_rate(s);
                      });
  return by_gamma_ * (early + late);
}

VectorXd Return::forces() {
  const VectorXd since = by_gamma_ * std::pow(length_, 1 - alpha_) * (points_.memory * rate_);
  VectorXd force = VectorXd::Zero(rate_.size());
  force[0] = approach_.turning_force();
  derivative_[0] = approach_.turning_derivative();
  const double turn = approach_.turn();
  for (Eigen::Index i = 1; i < rate_.size(); ++i) {
    const double t = turn + length_ * points_.x[i];
    derivative_[i] = felt(0, t) + since[i];
    if (derivative_[i] <= 0) continue;
    const auto outermost = [&](double t1) { return felt(t1, t) + since[i]; };
    const double t1 = since[i] >= 0 ? turn : support::root(outermost, 0.0, turn, derivative_[i], since[i]);
    force[i] = this->force(t1, t);
  }
  return force;
}

/// To the fixed point of rate and force on the length that it has.
void Return::settle() {
  constexpr int most = 100;
  for (int sweep = 0; sweep < most; ++sweep) {
    const VectorXd next = -length_ * (points_.integral * forces());
    const double change = (next - rate_).cwiseAbs().maxCoeff();
    rate_ = next;
    if (change < 1e-14) return;
  }
}

/// Moves the length to where D^α ζ falls to 0 and takes the rate along; by what factor.
double Return::next_length() {
  const Eigen::Index last = rate_.size() - 1;
  const auto derivative = [this](double x) { return points_.value(derivative_, x); };
  double factor = 1;
  if (derivative_[last] < 0) {
    factor = support::root(derivative, points_.x[1], 1.0);
  } else {
    const double slope = (derivative_[last - 1] - derivative_[last]) / (points_.x[last] - points_.x[last - 1]);
    factor += std::min(0.3, derivative_[last] / slope);
  }
  VectorXd moved(rate_.size());
  for (Eigen::Index i = 0; i <= last; ++i)
    moved[i] = factor < 1.05 ? points_.value(rate_, factor * points_.x[i]) : factor * rate_[i];
  rate_ = moved;
  length_ *= factor;
  return factor;
}

SphereImpact Return::solve() {
  constexpr int most = 30;
  for (int k = 0; k < most; ++k) {
    settle();
    if (std::abs(next_length() - 1) < 1e-13) break;
  }
  const double turn = approach_.turn(), deepest = approach_.overlap(turn);
  const Eigen::Index last = rate_.size() - 1;
  return {.en = -rate_[last],
          .tcol = turn + length_,
          .max_overlap = deepest,
          .time_max_overlap = turn,
          .overlap_end = deepest + length_ * (points_.integral * rate_)[last]};
}

}  // namespace

SphereImpact power_law_sphere(double alpha, int nodes) {
  support::require(alpha >= 0 && alpha <= 0.8, "alpha", alpha, "in [0, 0.8]");
  support::require(nodes >= 8 && nodes <= 64, "nodes", nodes, "in [8, 64]");
  return Return(alpha, nodes).solve();
}

}  // namespace ricochet
