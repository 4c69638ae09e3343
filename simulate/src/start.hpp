#pragma once

#include "materials.hpp"

#include <simulate/scene.hpp>

#include <string>

namespace ricochet::simulate {

/// Appends the spheres of a frame of a trajectory that simulate wrote, {"trajectory": file, "frame": number}: the last
/// frame without a number. `scene_file`: a relative path counts from its folder. Returns the text of the frame. Throws
/// console::BadInput "trajectory:line: …" for what is no such frame.
std::string read_start(const console::Node& node, const std::string& scene_file, const Materials& materials,
                       Scene& scene);

/// A material's name as a word of a trajectory: blanks, quotes and commas are underscores.
std::string species(const std::string& material);

}  // namespace ricochet::simulate
