#pragma once

#include <ricochet/collision/collision.hpp>

#include <cmath>

namespace ricochet::collision {

/// Every duty of `collide` but the choice of the method.
Collision closed_form(const Linear& law, const Impact& impact, ContactEnd end);
Collision closed_form(const Hysteretic& law, const Impact& impact, ContactEnd end);
Collision closed_form(const Fractional& law, const Impact& impact, ContactEnd end);
/// What a collision that ends at rest (26) has taken up by then [J].
inline double energy_at_rest(const Impact& impact) {
  return 0.5 * impact.mass_eff * impact.velocity * impact.velocity * (1 - at_rest * at_rest);
}

/// The same for α ≥ 1, which ends at rest.
Collision come_to_rest(const Fractional& law, const Impact& impact, double breakage_energy);
/// And for a dashpot c dζ^{3/2}/dt alone.
Collision come_to_rest(const FractionalHertz& law, const Impact& impact, double breakage_energy);

/// `unit` [s] is the time the scaled collision was counted in: turns it into SI units. Scales that are no normal double
/// (parameters that are far apart) would give zeros, infinities or lost digits: out_of_range.
inline Collision in_units(Collision scaled, const Impact& impact, double unit) {
  const double length = impact.velocity * unit, force = impact.mass_eff * impact.velocity / unit;
  if (!(std::isnormal(unit) && std::isnormal(length) && std::isnormal(force)))
    return {.status = CollisionStatus::out_of_range};
  scaled.tcol *= unit;
  scaled.time_max_overlap *= unit;
  scaled.time_max_force *= unit;
  scaled.max_overlap *= length;
  scaled.overlap_end *= length;
  scaled.max_force *= force;
  const bool finite = std::isfinite(scaled.tcol) && std::isfinite(scaled.max_overlap) &&
                      std::isfinite(scaled.max_force) && (!scaled.separated() || std::isnormal(scaled.en));
  return finite ? scaled : Collision{.status = CollisionStatus::out_of_range};
}

}  // namespace ricochet::collision
