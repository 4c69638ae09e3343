#pragma once

#include "case.hpp"

namespace ricochet::verify::conformance {

/// The first two bodies, or the first and the first wall, which touch at the time 0, meet once: `collide`, exact or of
/// 1e-9. Two spheres whose line of centres turns by an angle are off by it, which counts as error.
Solution one_collision(const Case& of, ContactArm arm);

/// One body that flies from wall to wall without gravity: `collide` again and again, from new contacts every time.
Solution collisions_of_one(const Case& of, ContactArm arm);

/// Bodies on a line, from the first wall (or body) on along its normal, by laws without memory, gravity along the line:
/// Runge-Kutta-Fehlberg 7(8) with error control, every begin and end of a contact located to rounding.
Solution on_a_line(const Case& of, ContactArm arm);

/// One sphere that stays on the first wall, a floor of constant pressure, and slides or rolls there: tangential spring
/// and rolling spring without dashpots, each with its limit, by the same integration.
Solution on_a_floor(const Case& of, ContactArm arm);

}  // namespace ricochet::verify::conformance
