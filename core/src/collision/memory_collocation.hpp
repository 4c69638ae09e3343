#pragma once

#include <ricochet/collision/collision.hpp>

#include <memory>

namespace ricochet::collision {

/// The collision x'' + κP(x) + γ D^α P(x) = load, x(0) = 0, x'(0) = 1, P(x) = x or x^{3/2}, that ends by force.
struct MemoryEquation {
  double spring;    ///< κ ≥ 0
  double pot;       ///< γ > 0; the unit of time is such that neither is much greater than 1
  double alpha;     ///< 0 < α < 1
  bool hertzian;    ///< P(x) = x^{3/2}
  double load = 0;  ///< ≥ 0, presses the bodies together; below 100, say
};

/// By collocation of Volterra's equation x' = 1 + load t − κ ∫P − γ I^{1−α}P, panel by panel: on each P is the
/// polynomial through its values at 16 Chebyshev points, which Newton's method finds; the memory of panels before is
/// integrated by Gauss's rules, graded where it is near. The solution is a series in t^{p+1} and t^{p+1−α}, p the power
/// of P, so that only t = 0 is singular: up to 1e-5 its first two terms are taken, whose error is 1e-15, from there on
/// panels double, which converges as fast as a power series for every α, and halve where coefficients fall too slowly
/// (towards the end of a nearly elastic Hertzian contact, where x^{3/2} is about to lose its argument). Knows no
/// transform and no Mittag-Leffler function. Times in the equation's unit; see `in_units`. evaluations counts the
/// values of P.
///
/// Error of t_col, e_n and the extremes: 1e-12 + 1e-14/e_n relative (tests/collision); no_separation where it has not
/// come to an end after 600 panels, or under a load turns inwards again.
Collision follow_memory(const MemoryEquation& equation);

/// The motion itself, from 0 to the end of a collision that ended by force.
class MemoryMotion {
 public:
  explicit MemoryMotion(const MemoryEquation& equation);

  struct Instant {
    double overlap, rate, force, slope;  ///< x, x', κP + γ D^αP and its derivative
  };
  /// At 0 < t ≤ t_col; the errors are those of `follow_memory`, of the slope 1e-10.
  Instant at(double t) const;

 private:
  struct Panels;
  std::shared_ptr<const Panels> panels_;
};

}  // namespace ricochet::collision
