#pragma once

#include "motion.hpp"

#include <ricochet/motion/wall.hpp>

#include <vector>

namespace ricochet::simulate {

/// A line through points, SI units.
using Polyline = std::vector<Vec3>;

/// The edges of a wall at time 0, which move as it does.
struct WallOutline {
  std::vector<Polyline> lines;
  Vec3 point{}, axis{};  ///< about which it spins
  WallMotion motion{};
};

/// What bounds the spheres: each plane is cut by the planes of all others, and where none bounds it a little outside of
/// `focus`, so that a box becomes its six faces. Cylinders without end reach as far. Round walls are their rims and
/// straight lines between them.
std::vector<WallOutline> wall_outlines(const std::vector<Wall>& walls, const Region& focus);

/// `focus` and the walls at time 0, but for what is cut without being bounded.
Region with_walls(const Region& focus, const std::vector<WallOutline>& outlines);

}  // namespace ricochet::simulate
