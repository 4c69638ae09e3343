#pragma once

#include <console/exit.hpp>
#include <simulate/scene.hpp>

#include <string>

namespace ricochet::simulate {

/// No frame holds a sphere.
struct NothingToShow : console::BadInput {
  using BadInput::BadInput;
};

/// A whole document that plays the run in `folder`: what trajectory.xyz holds, the contacts that follow from it, and
/// the walls of the scene. It loads nothing. Long runs are thinned to evenly spread frames, which the page says, as it
/// does how exactly places and speeds are kept. Throws console::BadInput where the trajectory cannot be read, and
/// NothingToShow.
std::string view_page(const Scene& scene, const std::string& folder);

}  // namespace ricochet::simulate
