#pragma once

#include <console/node.hpp>

#include <simulate/scene.hpp>

namespace ricochet::simulate {

/// A look ahead along straight lines from the start, for spheres that fly at a wall or at another sphere so fast that
/// they would go in by a radius or more, that is v t_col/π, the depth of a linear contact without damping: a remark on
/// the first of them, or BadInput where it is as deep as Breakthrough has it. What comes later is seen when it comes.
/// Pairs of spheres are not looked through beyond 5000 spheres.
std::string look_ahead(const console::Node& root, const Scene& scene);

}  // namespace ricochet::simulate
