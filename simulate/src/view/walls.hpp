#pragma once

#include "motion.hpp"

#include <ricochet/motion/bodies.hpp>

#include <vector>

namespace ricochet::simulate {

/// A line through points, SI units.
using Polyline = std::vector<Vec3>;

/// The edges of the walls as far as they bound the spheres: each plane is cut by the planes of all others, and where
/// none bounds it a little outside of `focus`. A box becomes its six faces.
std::vector<Polyline> wall_outlines(const std::vector<Wall>& walls, const Region& focus);

/// `focus` and the corners at which walls meet.
Region with_walls(const Region& focus, const std::vector<Polyline>& outlines);

}  // namespace ricochet::simulate
