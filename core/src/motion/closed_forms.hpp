#pragma once

#include <ricochet/motion/collision.hpp>

namespace ricochet::motion {

/// Every duty of `collide` but the choice of the method.
Collision closed_form(const Linear& law, const Impact& impact, ContactEnd end);
Collision closed_form(const Hysteretic& law, const Impact& impact, ContactEnd end);
Collision closed_form(const Fractional& law, const Impact& impact, ContactEnd end);

/// `unit` [s] is the time the scaled collision was counted in: turns it into SI units.
inline Collision in_units(Collision scaled, const Impact& impact, double unit) {
  const double length = impact.velocity * unit;
  scaled.tcol *= unit;
  scaled.time_max_overlap *= unit;
  scaled.time_max_force *= unit;
  scaled.max_overlap *= length;
  scaled.overlap_end *= length;
  scaled.max_force *= impact.mass_eff * impact.velocity / unit;
  return scaled;
}

}  // namespace ricochet::motion
