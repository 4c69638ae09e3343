#pragma once

#include "materials.hpp"

#include <simulate/scene.hpp>

namespace ricochet::simulate {

/// Puts the spheres of "lattice" and of "pour" without a rate among those that are there, and appends the poured ones
/// that come later to scene.later. Walls are read before. Throws console::BadInput with how many found room.
void generate(const console::Node& root, const Materials& materials, Scene& scene);

}  // namespace ricochet::simulate
