#include "viscoelastic_collision.hpp"

#include <ricochet/support/root.hpp>

#include <cmath>
#include <numbers>
#include <optional>

namespace ricochet::collision {
namespace {

/// The first zero after `from`, looked for in steps of a thirtieth of a half period or less; none up to `until`.
template <class F>
std::optional<double> first_fall(const F& f, double from, double until = 1e5) {
  constexpr double step = 0.1;
  double low = from, at_low = 1;
  while (low < until) {
    const double high = low + step, at_high = f(high);
    if (at_high <= 0) return support::root(f, low, high, at_low, at_high);
    low = high, at_low = at_high;
  }
  return std::nullopt;
}

/// The zero of the overlap between its maximum and its first minimum, which comes within a period of the pole's, if at
/// all: what the cut leaves of the rate never changes its sign.
std::optional<double> returned(const ViscoelasticMotion& motion, double turn) {
  const double period = 2 * std::numbers::pi / motion.pole().imag();
  const auto falling = [&](double t) { return -motion.rate(t); };
  const auto minimum = first_fall(falling, turn * (1 + 1e-9), turn + period);
  const auto overlap = [&](double t) { return motion.overlap(t); };
  if (!minimum || !(overlap(*minimum) < 0)) return std::nullopt;
  return support::root(overlap, turn, *minimum);
}

/// When the force is greatest. It rises like t^{1−α}, so near α = 1 its maximum may be at any early time.
void find_peak(const ViscoelasticMotion& motion, double end, Collision& out) {
  const auto slope = [&](double t) { return motion.force_slope(t); };
  double high = end, low = 0.5 * end;
  while (slope(low) <= 0 && low > 1e-40) high = low, low *= 0.5;
  out.time_max_force = slope(low) > 0 ? support::root(slope, low, high) : low;
  out.max_force = motion.force(out.time_max_force);
}

}  // namespace

Collision closed_form(const ViscoelasticMotion& motion, ContactEnd end) {
  const auto turn = first_fall([&](double t) { return motion.rate(t); }, 0);
  const auto slack = first_fall([&](double t) { return motion.force(t); }, 0);
  if (!turn || !slack) return {.status = CollisionStatus::out_of_range};
  const auto ended = end == ContactEnd::force ? slack : returned(motion, *turn);
  if (!ended) return {};
  Collision out;
  out.status = end == ContactEnd::force ? CollisionStatus::ended_by_force : CollisionStatus::ended_by_overlap;
  out.tcol = *ended;
  out.en = -motion.rate(*ended);
  out.overlap_end = end == ContactEnd::force ? motion.overlap(*ended) : 0;
  out.time_max_overlap = *turn;
  out.max_overlap = motion.overlap(*turn);
  find_peak(motion, *slack, out);
  return out;
}

}  // namespace ricochet::collision
