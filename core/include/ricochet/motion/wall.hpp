#pragma once

#include <ricochet/contact/vec3.hpp>

#include <cstddef>
#include <variant>
#include <vector>

namespace ricochet {

/// How a wall moves, as a rigid body without end: its points stand at x + V t + A sin(2πft), and it spins about its own
/// axis, which leaves the surface where it is but carries whom it rubs.
struct WallMotion {
  Vec3 velocity{};       ///< V [m/s]
  double spin = 0;       ///< about the direction Wall::inward, by the right hand [1/s]; 0 for a plate
  Vec3 amplitude{};      ///< A [m]
  double frequency = 0;  ///< f [Hz], ≥ 0
};

/// Surfaces that spheres meet at their nearest point, where they count as planes: contact disc and effective radius are
/// those of a sphere on a plane. Half of them end somewhere (cone, plate): a sphere meets their edges too, and comes
/// from either side.
namespace surface {
/// The plane through Wall::point; spheres are on the side of Wall::inward.
struct Plane {};
/// The inside of a cylinder without end about the axis through Wall::point along Wall::inward.
struct Cylinder {
  double radius = 0;  ///< [m], > that of every sphere
};
/// What the segment between radius `first` at Wall::point and radius `last`, `length` along the axis Wall::inward,
/// sweeps as it turns about the axis: a frustum; a tube for equal radii; for no length a ring, or a disc from radius 0.
struct Cone {
  double length = 0;           ///< [m], ≥ 0
  double first = 0, last = 0;  ///< [m], > that of every sphere; 0 only without length
};
/// The parallelogram of two edges from its corner Wall::point; `inward` says nothing.
struct Plate {
  Vec3 first{}, second{};  ///< [m], at right angles
};
}  // namespace surface

using WallForm = std::variant<surface::Plane, surface::Cylinder, surface::Cone, surface::Plate>;

/// What spheres meet besides each other, of infinite mass. By itself an immovable plane through `point`; `inward` (any
/// length > 0) points to the side of the spheres, of a form with an axis along it.
struct Wall {
  Vec3 point{};
  Vec3 inward{0, 0, 1};
  std::size_t material = 0;
  WallForm form{};
  WallMotion motion{};
};

/// The six walls of the box from `low` to `high`, spheres inside: low and high x, then y, then z. Throws
/// std::invalid_argument unless low < high.
std::vector<Wall> box_walls(Vec3 low, Vec3 high, std::size_t material = 0);

/// The least radius of a cylinder or cone, which every sphere has to be smaller than, as else it would touch in more
/// than one point; infinite for planes, rings, discs and plates.
double narrowest(const Wall& wall) noexcept;

/// Throws std::invalid_argument naming what is wrong: a number that is not finite, no direction, a radius or length out
/// of its domain, edges that are not at right angles (to 1e-6) or a plate that spins.
void check(const Wall& wall);

}  // namespace ricochet
