#pragma once

#include <ricochet/support/require.hpp>
#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/instant.hpp>

#include <cstddef>
#include <vector>

namespace ricochet {

/// The motion m ζ'' + force = 0 from ζ = 0, ζ' = v₀ over `duration` [s] in equal steps, to be drawn or listed: the
/// velocity Verlet scheme with the rate extrapolated for the force and corrected once, second order where the law is
/// smooth. `collide` is the accurate way to the numbers of a collision; this is the way to its curves. Gives steps + 1
/// points. Throws std::invalid_argument unless velocity, mass_eff and duration are finite and > 0 and steps at least 1.
template <ContactLaw Law>
std::vector<Instant> trace(const Law& law, const Impact& impact, double duration, std::size_t steps) {
  support::require_positive("velocity", impact.velocity);
  support::require_positive("mass_eff", impact.mass_eff);
  support::require_positive("duration", duration);
  support::require(steps >= 1, "steps", static_cast<double>(steps), "at least 1");
  const double h = duration / static_cast<double>(steps), m = impact.mass_eff;
  typename Law::Memory memory{};
  Approach now{0, impact.velocity};
  double force = law.force(now, memory);
  std::vector<Instant> points{{0, now.overlap, now.rate, force}};
  for (std::size_t n = 1; n <= steps; ++n) {
    Approach after{now.overlap + h * (now.rate - 0.5 * h * force / m), now.rate - h * force / m};
    typename Law::Memory next = memory;
    for (int pass = 0; pass < 2; ++pass) {
      next = memory;
      law.advance(next, now, after, h);
      after.rate = now.rate - 0.5 * h * (force + law.force(after, next)) / m;
    }
    memory = next;
    now = after;
    force = law.force(now, memory);
    points.push_back({h * static_cast<double>(n), now.overlap, now.rate, force});
  }
  return points;
}

}  // namespace ricochet
