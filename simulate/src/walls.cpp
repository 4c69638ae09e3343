#include "walls.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>

namespace ricochet::simulate {
namespace {

using console::Node;

Vec3 direction(const Node& node) {
  const Vec3 v = node.vector();
  if (!(norm(v) > 0)) node.reject("a direction, not zero");
  return v;
}

std::pair<double, double> radii(const Node& node) {
  if (!node.json().is_array() || node.json().size() != 2) node.reject("two radii [a, b]");
  return {node.at(0).not_negative(), node.at(1).not_negative()};
}

Wall plane(const Node& entry) { return {.point = entry.at("point").vector(), .inward = direction(entry.at("inward"))}; }

Wall cylinder(const Node& entry) {
  return {.point = entry.at("point").vector(),
          .inward = direction(entry.at("axis")),
          .form = surface::Cylinder{entry.at("radius").positive()}};
}

Wall cone(const Node& entry) {
  const Vec3 from = entry.at("from").vector(), along = entry.at("to").vector() - from;
  if (!(norm(along) > 0)) entry.at("to").reject("another point than from");
  const auto [first, last] = radii(entry.at("radii"));
  if (!(first > 0 && last > 0)) entry.at("radii").reject("two radii > 0");
  return {.point = from, .inward = along, .form = surface::Cone{norm(along), first, last}};
}

Wall ring(const Node& entry) {
  const auto [inner, outer] = radii(entry.at("radii"));
  if (!(inner < outer)) entry.at("radii").reject("an inner radius, 0 of a disc, and a greater outer one");
  return {.point = entry.at("point").vector(),
          .inward = direction(entry.at("axis")),
          .form = surface::Cone{0, inner, outer}};
}

Wall plate(const Node& entry) {
  const Node edges = entry.at("edges");
  if (!edges.json().is_array() || edges.json().size() != 2) edges.reject("two edges [[x, y, z], [x, y, z]]");
  const Vec3 first = direction(edges.at(0)), second = direction(edges.at(1));
  if (std::abs(dot(first, second)) > 1e-6 * norm(first) * norm(second)) edges.reject("at right angles");
  return {.point = entry.at("corner").vector(), .form = surface::Plate{first, second}};
}

/// One kind of walls: its array in the scene, the names that its walls have without one, what only it says.
struct Kind {
  std::string array, name;
  std::vector<std::string_view> keys;
  bool spins;
  Wall (*read)(const Node&);
};

const std::array<Kind, 5>& kinds() {
  static const std::array<Kind, 5> all{{{"walls", "wall", {"point", "inward"}, true, plane},
                                        {"cylinders", "cylinder", {"point", "axis", "radius"}, true, cylinder},
                                        {"cones", "cone", {"from", "to", "radii"}, true, cone},
                                        {"rings", "ring", {"point", "axis", "radii"}, true, ring},
                                        {"plates", "plate", {"corner", "edges"}, false, plate}}};
  return all;
}

WallMotion read_motion(const Node& entry) {
  WallMotion motion;
  if (entry.has("velocity")) motion.velocity = entry.at("velocity").vector();
  if (entry.has("spin")) motion.spin = entry.at("spin").number();
  if (entry.has("oscillation")) {
    const Node swing = entry.at("oscillation");
    swing.allow({"amplitude", "frequency"});
    motion.amplitude = swing.at("amplitude").vector();
    motion.frequency = swing.at("frequency").positive();
  }
  return motion;
}

class Reader {
 public:
  Reader(const Materials& materials, Scene& scene) : materials_(materials), scene_(scene) {}

  void read(const Node& array, const Kind& kind) {
    std::vector<std::string_view> keys = kind.keys;
    keys.insert(keys.end(), {"material", "name", "velocity", "oscillation"});
    if (kind.spins) keys.emplace_back("spin");
    for (std::size_t k = 0; k < array.size(); ++k) {
      const Node entry = array.at(k);
      entry.allow(keys);
      Wall wall = kind.read(entry);
      wall.material = material_of(entry.at("material"), materials_).index;
      wall.motion = read_motion(entry);
      add(entry, wall, name_of(entry, fmt::format("{}{}", kind.name, k + 1)));
    }
  }

  void read_boxes(const Node& array) {
    for (std::size_t k = 0; k < array.size(); ++k) {
      const Node entry = array.at(k);
      entry.allow({"low", "high", "material", "name"});
      const Vec3 low = entry.at("low").vector(), high = entry.at("high").vector();
      if (!(low.x < high.x && low.y < high.y && low.z < high.z)) entry.at("high").reject("above low in x, y and z");
      const std::string name = name_of(entry, fmt::format("box{}", k + 1));
      const auto walls = box_walls(low, high, material_of(entry.at("material"), materials_).index);
      for (std::size_t side = 0; side < walls.size(); ++side)
        add(entry, walls[side], fmt::format("{} {} {}", name, side % 2 == 0 ? "low" : "high", "xyz"[side / 2]));
    }
  }

 private:
  static std::string name_of(const Node& entry, const std::string& otherwise) {
    if (!entry.has("name")) return otherwise;
    std::string name = entry.at("name").text();
    const bool letter = !name.empty() && std::isalpha(static_cast<unsigned char>(name.front()));
    if (!letter || name.find_first_of(",;\"") != std::string::npos)
      entry.at("name").reject("a name that begins with a letter, without , ; and quotes");
    return name;
  }

  void add(const Node& entry, const Wall& wall, const std::string& name) {
    if (std::find(scene_.wall_names.begin(), scene_.wall_names.end(), name) != scene_.wall_names.end())
      entry.complain(fmt::format("another wall is named \"{}\"; names must differ", name));
    scene_.setup.walls.push_back(wall);
    scene_.wall_names.push_back(name);
  }

  const Materials& materials_;
  Scene& scene_;
};

}  // namespace

void read_walls(const Node& root, const Materials& materials, Scene& scene) {
  Reader reader(materials, scene);
  for (const Kind& kind : kinds()) {
    if (root.has(kind.array)) reader.read(root.at(kind.array), kind);
    if (kind.array == "walls" && root.has("boxes")) reader.read_boxes(root.at("boxes"));
  }
}

}  // namespace ricochet::simulate
