#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet {

namespace {

using support::root;

/// E_{a,b}(−z)
double e(double a, double b, double z) { return mittag_leffler(a, b, -z); }

/// First zero of E_{a,b}(−z) past `from`. The zeros of the three functions needed are more than 1 apart for 1 < a ≤ 2.
double zero_after(double from, double a, double b) {
  double z = from;
  while (e(a, b, z + 0.5) > 0) z += 0.5;
  return root([=](double y) { return e(a, b, y); }, z, z + 0.5);
}

/// z of the end by force: never below 4.4 (at α ≈ 0.77), and growing as −ln(1−α) towards α = 1.
double end_by_force(double a) { return zero_after(4, a, a); }

/// z of the end by overlap, the first zero of E_{a,2}(−z). It lies between the greatest overlap and the first minimum
/// of the overlap, the two first zeros of the rate, which bracket it also where it is about to become a double zero.
double end_by_overlap(double a, double z_max_overlap) {
  double z = z_max_overlap + 1;
  while (e(a, 1, z + 0.5) < 0) z += 0.5;
  const double minimum = root([=](double y) { return e(a, 1, y); }, z, z + 0.5);
  return e(a, 2, minimum) < 0 ? root([=](double y) { return e(a, 2, y); }, z_max_overlap, minimum) : minimum;
}

void require_degree(double alpha, ContactEnd end) {
  if (end == ContactEnd::force)
    support::require(alpha >= -1 && 2 - alpha > 1, "alpha", alpha,
                     "in [-1, 1) for a contact that ends by force, and told from 1 by the rounding of 2 - alpha");
  else
    support::require(alpha >= -1 && alpha < overlap_limit, "alpha", alpha,
                     "in [-1, 0.400884...) for a contact that ends by overlap");
}

/// z of the greatest force before the end: dR/dt ∝ E_{a,a−1}(−z). At α = −1 it is the end itself.
double strongest(double a, double end) {
  if (e(a, a - 1, end) >= 0) return end;
  return root([=](double z) { return e(a, a - 1, z); }, 0, end);
}

}  // namespace

FractionalContact fractional_contact(double alpha, ContactEnd end) {
  require_degree(alpha, end);
  const double a = 2 - alpha;
  FractionalContact c{};
  c.alpha = alpha;
  c.z_max_overlap = zero_after(2, a, 1);
  const bool by_force = end == ContactEnd::force && alpha >= 0;
  const double z_force = alpha >= 0 ? end_by_force(a) : 0;
  c.z_star = by_force ? z_force : end_by_overlap(a, c.z_max_overlap);
  c.tau = std::pow(c.z_star, 1 / a);
  const double en = -e(a, 1, c.z_star);
  c.en = alpha > 0 ? std::min(1.0, en) : alpha < 0 ? std::max(1.0, en) : 1;
  c.overlap_end = by_force && alpha > 0 ? e(a, 2, c.z_star) : 0.0;
  c.t_max_overlap = std::pow(c.z_max_overlap / c.z_star, 1 / a);
  c.max_overlap = c.t_max_overlap * e(a, 2, c.z_max_overlap);
  const double z_max_force = strongest(a, alpha >= 0 ? z_force : c.z_star);
  c.t_max_force = std::pow(z_max_force / c.z_star, 1 / a);
  c.max_force = c.z_star * std::pow(c.t_max_force, a - 1) * e(a, a, z_max_force);
  return c;
}

double conversion_degree(double en, ContactEnd end) {
  support::require(en >= least_restitution(end) && en <= 1, "en", en,
                   end == ContactEnd::force ? "in [1e-15, 1]" : "in [1e-6, 1] for a contact that ends by overlap");
  if (en == 1) return 0;
  const auto excess = [=](double alpha) {
    const double a = 2 - alpha;
    const double z = end == ContactEnd::force ? end_by_force(a) : end_by_overlap(a, zero_after(2, a, 1));
    return -e(a, 1, z) - en;
  };
  const double low = 0, high = end == ContactEnd::force ? 1 - 0x1p-50 : overlap_limit;
  const double at_low = excess(low), at_high = excess(high);
  if (at_low <= 0) return low;  // e_n is 1 to its last digit
  if (at_high >= 0) return high;
  // Down to neighbours: near the ends e_n takes every digit of α that there is.
  return support::root_bracket(excess, low, high, at_low, at_high, {.relative = 0}).first;
}

double tcol_estimate(double coefficient, double alpha) {
  support::require_positive("coefficient", coefficient);
  support::require(alpha >= 0 && alpha < 1, "alpha", alpha, "in [0, 1)");
  return std::pow(std::pow(1.641, 1 - alpha) * std::tgamma(4 - alpha) / coefficient, 1 / (2 - alpha));
}

namespace {

double checked_degree(double alpha) {
  support::require(alpha >= -1 && alpha < 2, "alpha", alpha, "in [-1, 2)");
  return alpha;
}

}  // namespace

FractionalTrajectory::FractionalTrajectory(double coefficient, double alpha, double mass_eff, double velocity)
    : alpha_(checked_degree(alpha)),
      mass_eff_(mass_eff),
      velocity_(velocity),
      time_scale_(std::pow(mass_eff / coefficient, 1 / (2 - alpha))),
      overlap_(2 - alpha, 2),
      rate_(2 - alpha, 1),
      force_(2 - alpha, 2 - alpha) {
  support::require_positive("coefficient", coefficient);
  support::require_positive("mass_eff", mass_eff);
  support::require_positive("velocity", velocity);
  for (const double unit : {time_scale_, velocity * time_scale_, mass_eff * velocity / time_scale_})
    support::require(std::isnormal(unit), "unit of the motion", unit, "a normal double");
}

double FractionalTrajectory::argument(double t) const {
  support::require_not_negative("t", t);
  return -std::pow(t / time_scale_, 2 - alpha_);
}

namespace {

double carried(double value, double t) {
  support::require(std::isfinite(value), "t", t, "a time at which the motion is within the range of doubles");
  return value;
}

}  // namespace

double FractionalTrajectory::overlap(double t) const { return carried(velocity_ * t * overlap_(argument(t)), t); }

double FractionalTrajectory::rate(double t) const { return carried(velocity_ * rate_(argument(t)), t); }

double FractionalTrajectory::force(double t) const {
  if (alpha_ > 1) support::require_positive("t", t);
  const double s = t / time_scale_;
  return carried(mass_eff_ * velocity_ / time_scale_ * std::pow(s, 1 - alpha_) * force_(argument(t)), t);
}

}  // namespace ricochet
