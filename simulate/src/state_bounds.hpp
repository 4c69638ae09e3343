#pragma once

#include <simulate/scene.hpp>

#include <cstdint>

namespace ricochet::simulate {

/// What spheres of a scene can have come to after `steps` of its steps. A run ends where a sphere moves by more than
/// its radius in a step or goes deeper than Breakthrough::share of a radius into another body: what a run saves lies
/// within.
class StateBounds {
 public:
  StateBounds(const Scene& scene, std::uint64_t steps);

  /// That the sphere comes with, or by which it moves through its radius in a step [m/s].
  double speed(const Sphere& sphere) const noexcept;
  /// From the origin: of the farthest that is there from the start or will be poured, and then a radius a step [m].
  double distance(const Sphere& sphere) const noexcept;
  /// Whose energy is still a number [1/s].
  static double spin(const Sphere& sphere) noexcept;
  /// Either way [m].
  static double overlap(double smaller_radius) noexcept { return Breakthrough::share * smaller_radius; }
  /// The end of the coming step, into which those who touch at the start are seen [s].
  double latest() const noexcept { return latest_; }

 private:
  double step_, latest_, moves_, farthest_ = 0;
};

}  // namespace ricochet::simulate
