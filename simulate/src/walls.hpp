#pragma once

#include "materials.hpp"

#include <simulate/scene.hpp>

namespace ricochet::simulate {

/// "walls", "boxes", "cylinders", "cones", "rings" and "plates", in this order, with their names and how they move.
void read_walls(const console::Node& root, const Materials& materials, Scene& scene);

}  // namespace ricochet::simulate
