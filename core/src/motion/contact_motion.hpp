#pragma once

#include <ricochet/contact/friction.hpp>
#include <ricochet/contact/geometry.hpp>
#include <ricochet/motion/engine/compliant_contact.hpp>

namespace ricochet::motion {

/// u_t of Eq. (9) of bodies that approach each other at v = v_i − v_j; `swing` is arm_i ω_i + arm_j ω_j.
RICOCHET_INNERMOST Vec3 slip_between(Vec3 normal, Vec3 v, Vec3 swing) noexcept {
  return tangential(v, normal) + cross(swing, normal);
}

/// The motion in a contact, Eq. (9), of bodies that approach each other at v and spin.
RICOCHET_INNERMOST SlipMotion slip_of(const ContactGeometry& g, Vec3 v, Vec3 wi, Vec3 wj) noexcept {
  return {slip_between(g.normal, v, g.arm_i * wi + g.arm_j * wj), dot(wi - wj, g.normal), cross(wi - wj, g.normal)};
}

/// The normal of two spheres `lag` ago, who fly straight since.
RICOCHET_INNERMOST Vec3 normal_before(const ContactGeometry& g, Vec3 v, double lag) noexcept {
  const Vec3 branch = (g.arm_i + g.arm_j) * g.normal + lag * v;
  const double distance = norm(branch);
  return distance > 0 ? 1 / distance * branch : g.normal;
}

/// What u_t gains over half a step while the normal turns and the branches shorten, velocities staying as they are.
/// Sticking then holds at the step's end, not half a step late.
RICOCHET_INNERMOST Vec3 turning(const ContactGeometry& g, Vec3 v, Vec3 wi, Vec3 wj, bool wall,
                                double half_step) noexcept {
  const Vec3 n = g.normal;
  const double rate = dot(v, n), d = g.arm_i + g.arm_j, per_d = d > 0 ? 1 / d : 0;
  // u_t = v_t + (arm_i ω_i + arm_j ω_j)×n with n' = −v_t/d; of a branch that shortens by `rate` each arm has its share.
  const Vec3 across = tangential(v, n), swing = g.arm_i * wi + g.arm_j * wj;
  const Vec3 shortened = rate * (across - cross(g.arm_j * wi + g.arm_i * wj, n));
  const Vec3 of_spheres = per_d * (shortened - dot(swing, n) * cross(n, across));
  const Vec3 of_a_wall = -0.5 * rate * cross(wi, n);
  return half_step * (wall ? of_a_wall : of_spheres);
}

}  // namespace ricochet::motion
