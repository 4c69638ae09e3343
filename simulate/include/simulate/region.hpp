#pragma once

#include <simulate/random.hpp>

#include <console/node.hpp>
#include <ricochet/motion/periodic.hpp>

#include <optional>

namespace ricochet::simulate {

/// Where spheres are put: a box {"low", "high"}, or a cylinder {"point", "axis", "radius"} as long as its axis. Spheres
/// are in it as a whole, but for borders where space repeats itself.
class PourRegion {
 public:
  PourRegion(const console::Node& node, const Periodic& periodic);

  double volume() const noexcept;  ///< [m³]
  /// The corners of the box around it.
  Vec3 low() const noexcept { return low_; }
  Vec3 high() const noexcept { return high_; }
  bool holds(Vec3 centre, double radius) const noexcept;
  /// Somewhere in it, all places alike; `high` < `low` of a sphere that does not fit says so by fits().
  Vec3 somewhere(double radius, Random& random) const noexcept;
  bool fits(double radius) const noexcept;

 private:
  struct Tube {
    Vec3 point, axis;  // unit
    double length, radius;
  };
  double margin(double radius, double Vec3::*axis) const noexcept;

  Vec3 low_, high_;
  Vec3 open_{};  // 1 along axes whose borders are none
  std::optional<Tube> tube_;
};

}  // namespace ricochet::simulate
