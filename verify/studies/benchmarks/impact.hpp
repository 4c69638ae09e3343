#pragma once

#include <ricochet/motion/cluster.hpp>

namespace ricochet::verify::benchmarks {

/// Two bodies that meet once, as a cluster moves them.
struct Meeting {
  double tcol = 0;                                  ///< [s]
  double greatest_overlap = 0, greatest_force = 0;  ///< [m], [N]; of a parabola through the three highest steps
  Vec3 velocity{}, spin{};                          ///< of the first sphere afterwards
  std::vector<std::pair<double, double>> loading;   ///< overlap and force while they compress
};

/// Follows the setup until its first contact is over. Throws std::runtime_error where it does not end within ten
/// million steps.
Meeting meet(const ClusterSetup& setup, double step);

/// A sphere against the plane z = 0, on whose far side it would go on: `velocity` z < 0, touching at the time 0.
ClusterSetup against_wall(const Sphere& sphere, const Interaction& interaction);

/// Spheres that touch along x at the time 0.
ClusterSetup against_sphere(Sphere first, Sphere second, const Interaction& interaction);

}  // namespace ricochet::verify::benchmarks
