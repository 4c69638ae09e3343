#pragma once

#include <ricochet/collision/collision.hpp>
#include <ricochet/support/root.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace ricochet::collision {

/// Without the load the force is negative between its first two zeros, from tau on; with it, if at all, then in the
/// same dip, which is no longer than `dip`.
template <class Motion>
std::optional<double> end_of(const Motion& motion, double tau, double dip) {
  constexpr int cells = 64;
  double least = std::numeric_limits<double>::infinity(), where = tau;
  const double cell = dip / cells;
  for (int i = 0; i <= cells; ++i)
    if (const double t = tau + i * cell, f = motion.force(t); f < least) least = f, where = t;
  const auto force = [&](double t) { return motion.force(t); };
  if (least > 0) {
    const auto [t, f] = boost::math::tools::brent_find_minima(force, std::max(tau, where - cell), where + cell, 40);
    if (f > 0) return std::nullopt;
    where = t;
  }
  const double before = force(0.5 * tau), after = force(where);
  return after == 0 ? where : support::root(force, 0.5 * tau, where, before, after);
}

/// The collision of a motion under a load, in its own units: overlap(t), rate(t) and force(t) at t > 0, and the tau and
/// dip of `end_of`.
template <class Motion>
Collision follow_loaded(const Motion& motion, double tau, double dip) {
  const auto end = end_of(motion, tau, dip);
  if (!end) return {};
  Collision out{.status = CollisionStatus::ended_by_force, .tcol = *end, .en = -motion.rate(*end)};
  if (!(out.en > 0)) return {};
  out.overlap_end = motion.overlap(*end);
  out.time_max_overlap = support::root([&](double t) { return motion.rate(t); }, 0.0, *end, 1.0, -out.en);
  out.max_overlap = motion.overlap(out.time_max_overlap);
  const auto [time, force] =
      boost::math::tools::brent_find_minima([&](double t) { return -motion.force(t); }, 0.0, *end, 40);
  out.time_max_force = time;
  out.max_force = -force;
  return out;
}

}  // namespace ricochet::collision
