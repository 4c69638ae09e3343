#include "materials.hpp"

#include <fmt/format.h>

#include <string_view>
#include <vector>

namespace ricochet::simulate {

Materials read_materials(const console::Node& node) {
  Materials materials;
  if (!node.json().is_object() || node.json().empty())
    node.reject("an object of at least one material, {\"name\": {...}}");
  node.require_names();
  for (const auto& [name, value] : node.json().items()) {
    const console::Node material = node.at(name);
    material.allow({"density"});
    Material read{materials.size(), {}};
    if (material.has("density")) read.density = material.at("density").positive();
    materials.emplace(name, read);
  }
  return materials;
}

const Material& material_of(const console::Node& node, const Materials& materials) {
  const auto found = materials.find(node.text());
  if (found != materials.end()) return found->second;
  std::vector<std::string_view> known;
  known.reserve(materials.size());
  for (const auto& [name, material] : materials) known.push_back(name);
  node.reject(fmt::format("one of the materials {}", fmt::join(known, ", ")));
}

double density_of(const console::Node& entry, const Material& material) {
  if (entry.has("density")) return entry.at("density").positive();
  if (material.density) return *material.density;
  entry.complain("\"density\" is missing; the sphere or its material must give it");
}

}  // namespace ricochet::simulate
