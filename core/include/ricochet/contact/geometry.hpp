#pragma once

#include <ricochet/contact/vec3.hpp>

#include <algorithm>

namespace ricochet {

/// Where and how two bodies touch. The branch vectors s_i = arm_i·normal and s_j = −arm_j·normal end in the same
/// point, so that a pair of opposite forces there changes neither the momentum nor the angular momentum of the pair.
struct ContactGeometry {
  Vec3 normal;         ///< e, from i to j, Eq. (1)
  double overlap = 0;  ///< ζ [m], Eqs. (5), (16); negative when apart
  double radius = 0;   ///< of the contact disc [m]: half the chord w of Eqs. (6), (17); 0 when apart
  double arm_i = 0;    ///< |x_i c| along the normal [m], Eqs. (7), (18), which do not go over into each other
  double arm_j = 0;    ///< |c x_j| along the normal [m]; 0 for a wall, which cannot turn
};

/// Two spheres. The lens exists for 0 < ζ < 2 min(r_i, r_j); outside, `radius` is 0. Coincident centres have no
/// normal: they get e_z, so that nothing downstream meets a NaN.
/// Whoever has no use for the disc leaves it out.
inline ContactGeometry sphere_sphere(Vec3 xi, double ri, Vec3 xj, double rj, bool disc = true) noexcept {
  const Vec3 branch = xj - xi;
  const double d = norm(branch);
  ContactGeometry g;
  const double per_d = d > 0 ? 1 / d : 0;
  g.normal = d > 0 ? per_d * branch : Vec3{0, 0, 1};
  g.overlap = ri + rj - d;
  const double z = g.overlap;
  if (disc && z < 2 * std::min(ri, rj)) {
    const double lens = z * (2 * ri - z) * (2 * rj - z) * (2 * (ri + rj) - z);
    g.radius = 0.5 * std::sqrt(std::max(0.0, lens)) * per_d;
  }
  g.arm_i = d > 0 ? ri - 0.5 * z * (2 * rj - z) * per_d : 0.0;
  g.arm_j = d - g.arm_i;
  return g;
}

/// A sphere and a plane wall through `point`; `inward` is the wall's unit normal on the side of the spheres, so that
/// e = −inward also for a sphere pushed through the plane. The arm is that of (18), (20), r − ζ/2, half-way between the
/// plane and the sphere's deepest point. It is not the limit of (7) for r_j → ∞, which is r − ζ, the plane itself: a
/// wall is not quite the sphere without bound that it is elsewhere, by ζ/2 of the arm.
inline ContactGeometry sphere_wall(Vec3 xi, double ri, Vec3 point, Vec3 inward) noexcept {
  ContactGeometry g;
  g.normal = -inward;
  g.overlap = ri - dot(xi - point, inward);
  g.radius = std::sqrt(std::max(0.0, g.overlap * (2 * ri - g.overlap)));
  g.arm_i = ri - 0.5 * g.overlap;
  return g;
}

}  // namespace ricochet
