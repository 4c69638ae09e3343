#include <simulate/scene.hpp>

#include "friction.hpp"
#include "law.hpp"
#include "law_by_target.hpp"
#include "passage.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

namespace ricochet::simulate {
namespace {

using console::Node;
using console::shortest;
using console::significant;

// The collision of the stiffest pair is resolved by 200 steps if the scene leaves the choice, by 20 at least.
constexpr double steps_per_collision = 200, least_steps_per_collision = 20;

struct Material {
  std::size_t index;
  std::optional<double> density;
};
using Materials = std::map<std::string, Material>;

Materials read_materials(const Node& node) {
  Materials materials;
  if (!node.json().is_object() || node.json().empty())
    node.reject("an object of at least one material, {\"name\": {...}}");
  node.require_names();
  for (const auto& [name, value] : node.json().items()) {
    const Node material = node.at(name);
    material.allow({"density"});
    Material read{materials.size(), {}};
    if (material.has("density")) read.density = material.at("density").positive();
    materials.emplace(name, read);
  }
  return materials;
}

const Material& material_of(const Node& node, const Materials& materials) {
  const auto found = materials.find(node.text());
  if (found != materials.end()) return found->second;
  std::vector<std::string_view> known;
  known.reserve(materials.size());
  for (const auto& [name, material] : materials) known.push_back(name);
  node.reject(fmt::format("one of the materials {}", fmt::join(known, ", ")));
}

// Springs that are each pair's own are set pair by pair.
void read_tangent_plane(const Node& entry, std::pair<std::size_t, std::size_t> pair, const AnyLaw& normal,
                        const std::optional<LawByTarget>& target, ByPair& by_pair, Interaction& interaction) {
  const Node friction = entry.at("friction");
  interaction.friction = read_friction(friction);
  interaction.rolling.mu = read_mu_rolling(friction);
  std::optional<TangentialAsked> asked = read_tangential(friction);
  if (!asked) return;
  asked->normal = normal;
  if (target && entry.at("law").has("velocity") && !asked->velocity) asked->velocity = target->velocity;
  if (target)
    if (const auto* moduli = std::get_if<scale::Moduli>(&target->scale)) asked->solid = *moduli;
  if (asked->by_pair() || target)
    by_pair.tangentials.emplace(pair, *asked);
  else
    set_tangential(*asked, normal, {}, interaction);
}

Interactions read_interactions(const Node& node, const Materials& materials, ByPair& by_pair) {
  Interactions interactions;
  for (std::size_t k = 0; k < node.size(); ++k) {
    const Node entry = node.at(k);
    entry.allow({"between", "law", "friction", "breakage_energy"});
    const Node between = entry.at("between");
    if (!between.json().is_array() || between.json().size() != 2) between.reject("two materials [\"a\", \"b\"]");
    const auto pair =
        std::minmax(material_of(between.at(0), materials).index, material_of(between.at(1), materials).index);
    const Node law = entry.at("law");
    const std::optional<LawByTarget> target = is_by_target(law) ? std::optional(read_law_by_target(law)) : std::nullopt;
    const AnyLaw normal = target ? AnyLaw(Linear(1, 0)) : read_law(law);  // one by target is set pair by pair
    Interaction interaction{normal};
    if (target) by_pair.laws.emplace(pair, *target);
    if (law.has("end") && law.at("end").one_of({"force", "overlap"}) == "overlap")
      interaction.end = ContactEnd::overlap;
    if (entry.has("friction")) read_tangent_plane(entry, pair, normal, target, by_pair, interaction);
    if (entry.has("breakage_energy")) interaction.breakage_energy = entry.at("breakage_energy").not_negative();
    if (!interactions.emplace(pair, interaction).second) between.reject("a pair that is given once");
  }
  return interactions;
}

void read_spheres(const Node& node, const Materials& materials, Scene& scene) {
  if (node.size() == 0) node.reject("at least one sphere");
  for (std::size_t k = 0; k < node.size(); ++k) {
    const Node entry = node.at(k);
    entry.allow({"radius", "density", "material", "position", "velocity", "spin"});
    const Material& material = material_of(entry.at("material"), materials);
    Sphere s;
    s.radius = entry.at("radius").positive();
    s.material = material.index;
    if (entry.has("density"))
      s.density = entry.at("density").positive();
    else if (material.density)
      s.density = *material.density;
    else
      entry.complain("\"density\" is missing; the sphere or its material must give it");
    s.position = entry.at("position").vector();
    if (entry.has("velocity")) s.velocity = entry.at("velocity").vector();
    if (entry.has("spin")) s.spin = entry.at("spin").vector();
    scene.setup.spheres.push_back(s);
    scene.body_names.push_back(fmt::format_int(k + 1).str());
  }
}

void read_walls(const Node& root, const Materials& materials, Scene& scene) {
  const auto add = [&](const Wall& wall) {
    scene.setup.walls.push_back(wall);
    scene.body_names.push_back(fmt::format("wall{}", scene.setup.walls.size()));
  };
  for (std::size_t k = 0; root.has("walls") && k < root.at("walls").size(); ++k) {
    const Node entry = root.at("walls").at(k);
    entry.allow({"point", "inward", "material"});
    const Vec3 inward = entry.at("inward").vector();
    if (!(norm(inward) > 0)) entry.at("inward").reject("a direction, not zero");
    add({entry.at("point").vector(), inward, material_of(entry.at("material"), materials).index});
  }
  for (std::size_t k = 0; root.has("boxes") && k < root.at("boxes").size(); ++k) {
    const Node entry = root.at("boxes").at(k);
    entry.allow({"low", "high", "material"});
    const Vec3 low = entry.at("low").vector(), high = entry.at("high").vector();
    if (!(low.x < high.x && low.y < high.y && low.z < high.z)) entry.at("high").reject("above low in x, y and z");
    for (const Wall& wall : box_walls(low, high, material_of(entry.at("material"), materials).index)) add(wall);
  }
}

std::string name_of(const Materials& materials, std::size_t index) {
  for (const auto& [name, material] : materials)
    if (material.index == index) return name;
  return {};
}

// Every two materials of which bodies exist that can meet.
void check_pairs(const Node& root, const Materials& materials, const Scene& scene) {
  std::map<std::size_t, int> spheres, walls;
  for (const Sphere& s : scene.setup.spheres) ++spheres[s.material];
  for (const Wall& w : scene.setup.walls) ++walls[w.material];
  const auto need = [&](std::size_t a, std::size_t b) {
    if (scene.setup.interactions.contains(std::minmax(a, b))) return;
    root.at("interactions")
        .complain(fmt::format("no entry between \"{}\" and \"{}\", which can meet; it must be given",
                              name_of(materials, a), name_of(materials, b)));
  };
  for (const auto& [a, count] : spheres) {
    if (count > 1) need(a, a);
    for (const auto& [b, others] : spheres)
      if (a < b) need(a, b);
    for (const auto& [b, others] : walls) need(a, b);
  }
}

void check_apart(const Node& root, const ClusterSetup& setup) {
  std::vector<Vec3> positions;
  std::vector<double> radii;
  for (const Sphere& s : setup.spheres) positions.push_back(s.position), radii.push_back(s.radius);
  const auto complain = [&](std::size_t i, const std::string& other, double overlap) {
    root.at("spheres").at(i).complain(fmt::format(
        "overlaps {} by {} m at the start; bodies must be apart or just touch", other, significant(overlap, 3)));
  };
  for (const NearPair& pair : near_pairs(positions, radii, 0)) {
    const double reach = radii[pair.i] + radii[pair.j], overlap = reach - norm(positions[pair.j] - positions[pair.i]);
    if (overlap > 1e-12 * reach) complain(pair.j, fmt::format("/spheres/{}", pair.i), overlap);
  }
  for (std::size_t i = 0; i < positions.size(); ++i)
    for (std::size_t w = 0; w < setup.walls.size(); ++w) {
      const Wall& wall = setup.walls[w];
      const double overlap = radii[i] - dot(positions[i] - wall.point, wall.inward) / norm(wall.inward);
      if (overlap > 1e-12 * radii[i]) complain(i, fmt::format("wall{}", w + 1), overlap);
    }
}

std::string body(const Scene& scene, std::size_t k) {
  return fmt::format("{}{}", k < scene.setup.spheres.size() ? "sphere " : "", scene.body_names[k]);
}

// The step, such that the output interval is a whole number of steps.
void choose_step(const Node& root, Scene& scene) {
  const double duration = root.at("duration").positive();
  const double interval = root.has("output_interval") ? root.at("output_interval").positive() : duration / 100;
  if (interval > duration) root.at("output_interval").reject("at most the duration");
  scene.stiffest = stiffest_contact(scene.setup);
  const double tcol = scene.stiffest.tcol;
  double step = tcol > 0 ? std::min(tcol / steps_per_collision, interval) : interval / 100;
  if (root.has("step")) {
    step = root.at("step").positive();
    if (step > interval) root.at("step").reject(fmt::format("at most the output interval, {} s", shortest(interval)));
    if (tcol > 0 && step > tcol / least_steps_per_collision)
      root.at("step").reject(fmt::format("at most {} s, a 20th of the {} s that {} and {} collide",
                                         shortest(tcol / least_steps_per_collision), significant(tcol, 3),
                                         body(scene, scene.stiffest.i), body(scene, scene.stiffest.j)));
  }
  const double per_output = std::ceil(interval / step * (1 - 1e-12));
  if (duration / step > 1e15)
    root.at("duration").reject(fmt::format("less than 1e15 steps of {} s", significant(step, 3)));
  scene.output_every = static_cast<std::uint64_t>(per_output);
  scene.options.step = interval / per_output;
  scene.steps = static_cast<std::uint64_t>(std::ceil(duration / scene.options.step * (1 - 1e-12)));
  scene.options.longest_contact = std::min(duration, 4e5 * scene.options.step);
}

std::string fingerprint(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // FNV-1a
  for (unsigned char byte : text) hash = (hash ^ byte) * 0x100000001b3u;
  return fmt::format_int(hash).str();
}

}  // namespace

Scene read_scene(const std::string& file, const std::string& text) {
  const console::Json json = console::parse_json(file, text, "docs/scenes.md");
  const Node root(file, text, json);
  root.allow({"schema", "title", "duration", "output_interval", "step", "gravity", "materials", "interactions",
              "spheres", "walls", "boxes", "reclosing"});
  if (root.has("schema")) root.at("schema").one_of({"ricochet/scene/1"});
  Scene scene;
  if (root.has("title")) scene.title = root.at("title").text();
  const Materials materials = read_materials(root.at("materials"));
  ByPair by_pair;
  scene.setup.interactions = read_interactions(root.at("interactions"), materials, by_pair);
  if (root.has("gravity")) scene.setup.gravity = root.at("gravity").vector();
  read_spheres(root.at("spheres"), materials, scene);
  read_walls(root, materials, scene);
  if (root.has("reclosing") && root.at("reclosing").one_of({"repels", "silent"}) == "silent")
    scene.options.reclosing = Reclosing::silent;
  check_pairs(root, materials, scene);
  check_apart(root, scene.setup);
  resolve(by_pair, scene.setup);
  choose_step(root, scene);
  scene.remark = look_ahead(root, scene);
  scene.fingerprint = fingerprint(json.dump());
  return scene;
}

}  // namespace ricochet::simulate
