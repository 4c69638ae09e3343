#pragma once

#include <ricochet/collision/oblique.hpp>

#include <cmath>

namespace ricochet::collision {

/// What the shape of two bodies says of their contact at the overlap ζ, and how it changes with ζ.
struct Lever {
  double radius = 0, radius_slope = 0;  ///< a of the contact disc (6), (17) [m], and da/dζ
  double arm_i = 0, arm_i_slope = 0;    ///< |s_i| [m], (7), (18) or the radius
  double arm_j = 0, arm_j_slope = 0;
};

/// As geometry.hpp has it, at a given overlap ζ > 0 below both diameters; there the overlap is a difference of
/// positions, which leaves nothing of one as small as at a touch.
inline Lever lever(const ImpactBody& i, const ImpactBody& j, ContactArm arm, double overlap) noexcept {
  const double z = overlap, ri = i.radius, rj = j.radius;
  Lever at{.arm_i = ri, .arm_j = j.is_wall() ? 0 : rj};
  const bool at_point = arm == ContactArm::contact_point;
  if (j.is_wall()) {
    at.radius = std::sqrt(std::max(0.0, z * (2 * ri - z)));
    at.radius_slope = at.radius > 0 ? (ri - z) / at.radius : 0;
    if (at_point) at.arm_i = ri - 0.5 * z, at.arm_i_slope = -0.5;
    return at;
  }
  const double sum = ri + rj, d = sum - z;
  at.radius = 0.5 * std::sqrt(std::max(0.0, z * (2 * ri - z) * (2 * rj - z) * (2 * sum - z))) / d;
  // Of the logarithm of a².
  const double growth = 1 / z - 1 / (2 * ri - z) - 1 / (2 * rj - z) - 1 / (2 * sum - z) + 2 / d;
  at.radius_slope = 0.5 * at.radius * growth;
  if (!at_point) return at;
  at.arm_i = ri - z * (2 * rj - z) / (2 * d);
  at.arm_j = d - at.arm_i;
  at.arm_i_slope = -((rj - z) / d + 0.5 * z * (2 * rj - z) / (d * d));
  at.arm_j_slope = -1 - at.arm_i_slope;
  return at;
}

}  // namespace ricochet::collision
