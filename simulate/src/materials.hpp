#pragma once

#include <console/node.hpp>

#include <ricochet/motion/bodies.hpp>

#include <map>
#include <optional>
#include <string>

namespace ricochet::simulate {

struct Material {
  std::size_t index = 0;
  std::optional<double> density = {};
};
using Materials = std::map<std::string, Material>;

Materials read_materials(const console::Node& node);
/// Of a value that names one.
const Material& material_of(const console::Node& node, const Materials& materials);
/// The density that an entry gives, or else its material.
double density_of(const console::Node& entry, const Material& material);

}  // namespace ricochet::simulate
