#pragma once

#include <ricochet/contact/geometry.hpp>
#include <ricochet/motion/wall.hpp>

namespace ricochet::motion {

/// A wall made ready for the steps: unit directions, and where it is at a time.
class Surface {
 public:
  explicit Surface(const Wall& wall);

  /// A sphere of radius r at x and the surface, at `time` [s].
  ContactGeometry meet(Vec3 x, double r, double time) const noexcept {
    return flat_ ? sphere_wall(x, r, point(time), axis_) : meet_curved(x - point(time), r);
  }
  Vec3 velocity(double time) const noexcept;                 ///< of its points, spin apart [m/s]
  Vec3 spin() const noexcept { return wall_spin_ * axis_; }  ///< [1/s]
  /// What the spin adds to the velocity at a point [m/s].
  Vec3 swept(Vec3 at, double time) const noexcept { return wall_spin_ * cross(axis_, at - point(time)); }
  /// By how much distances to it can have changed between two times [m].
  double moved(double from, double to) const noexcept;

  bool flat() const noexcept { return flat_; }        ///< a plane without end
  bool travels() const noexcept { return travels_; }  ///< changes its place
  bool spins() const noexcept { return wall_spin_ != 0; }
  bool swings() const noexcept { return swings_; }                      ///< changes its velocity
  bool drives() const noexcept { return travels_ || wall_spin_ != 0; }  ///< does work
  bool two_sided() const noexcept { return two_sided_; }

 private:
  Vec3 point(double time) const noexcept { return travels_ ? point_ + displacement(time) : point_; }
  Vec3 displacement(double time) const noexcept;
  ContactGeometry meet_curved(Vec3 from_point, double r) const noexcept;

  Vec3 point_, axis_;
  WallForm form_;
  WallMotion motion_;
  double wall_spin_;
  bool flat_, travels_, swings_, two_sided_;
};

/// What the slip of a sphere on the surface gains over `time_on` [s] while the sphere flies on and the contact point,
/// the normal and the arm move with it, velocities staying as they are.
struct SurfaceSlip {
  Vec3 position, velocity, spin;  ///< of the sphere
  double radius = 0;
  Vec3 wall_velocity;
};
Vec3 slip_gain(const Surface& surface, const SurfaceSlip& s, double time, double time_on) noexcept;

}  // namespace ricochet::motion
