#pragma once

#include <ricochet/contact/friction.hpp>
#include <ricochet/contact/geometry.hpp>
#include <ricochet/motion/engine/compliant_contact.hpp>

namespace ricochet::motion {

/// The motion in a contact, Eq. (9), of bodies that approach each other at v = v_i − v_j and spin.
RICOCHET_INNERMOST SlipMotion slip_of(const ContactGeometry& g, Vec3 v, Vec3 wi, Vec3 wj) noexcept {
  return {tangential(v, g.normal) + cross(g.arm_i * wi + g.arm_j * wj, g.normal), dot(wi - wj, g.normal),
          cross(wi - wj, g.normal)};
}

/// What u_t gains over half a step while the normal turns and the branches shorten, velocities staying as they are.
/// Sticking then holds at the step's end, not half a step late.
RICOCHET_INNERMOST Vec3 turning(const ContactGeometry& g, Vec3 v, Vec3 wi, Vec3 wj, bool wall,
                                double half_step) noexcept {
  const double rate = dot(v, g.normal), d = g.arm_i + g.arm_j;
  if (wall) return half_step * -0.5 * rate * cross(wi, g.normal);
  if (!(d > 0)) return {};
  const double per_d = 1 / d;
  const Vec3 across = tangential(v, g.normal), normal_rate = -per_d * across;
  const double rate_i = -rate * (1 - g.arm_i * per_d), rate_j = -rate * (1 - g.arm_j * per_d);
  const Vec3 arms = g.arm_i * wi + g.arm_j * wj;
  return half_step * (rate * per_d * across + cross(rate_i * wi + rate_j * wj, g.normal) +
                      dot(arms, g.normal) * cross(g.normal, normal_rate));
}

}  // namespace ricochet::motion
