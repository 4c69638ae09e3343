#include <simulate/scene.hpp>

#include "crowd.hpp"
#include "fingerprint.hpp"
#include "friction.hpp"
#include "generate.hpp"
#include "law.hpp"
#include "law_by_target.hpp"
#include "materials.hpp"
#include "passage.hpp"
#include "start.hpp"
#include "walls.hpp"

#include <console/exit.hpp>
#include <console/number.hpp>
#include <console/progress.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
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

// What is to be done with a text: two looks at its bytes, then its spheres, then who overlaps and meets whom.
class Work {
 public:
  Work(const std::string& file, std::size_t bytes) : bytes_(bytes), progress_("read " + file, 4 * bytes) {}

  console::Progress* progress() noexcept { return &progress_; }
  // The k-th of n parts of what is as much as one look.
  void part(std::size_t k, std::size_t n) {
    progress_.advance(static_cast<std::uint64_t>(double(bytes_) / double(n) * double(k + 1)) -
                      static_cast<std::uint64_t>(double(bytes_) / double(n) * double(k)));
  }

 private:
  std::size_t bytes_;
  console::Progress progress_;
};

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

void read_spheres(const Node& node, const Materials& materials, Scene& scene, Work& work) {
  scene.setup.spheres.reserve(node.size());
  for (std::size_t k = 0; k < node.size(); ++k) {
    work.part(k, node.size());
    const Node entry = node.at(k);
    entry.allow({"radius", "density", "material", "position", "velocity", "spin"});
    const Material& material = material_of(entry.at("material"), materials);
    Sphere s;
    s.radius = entry.at("radius").positive();
    s.material = material.index;
    s.density = density_of(entry, material);
    s.position = entry.at("position").vector();
    if (entry.has("velocity")) s.velocity = entry.at("velocity").vector();
    if (entry.has("spin")) s.spin = entry.at("spin").vector();
    scene.setup.spheres.push_back(s);
  }
}

void read_periods(const Node& node, Scene& scene) {
  node.allow({"x", "y", "z"});
  for (const auto& [key, axis] : {std::pair("x", &Vec3::x), std::pair("y", &Vec3::y), std::pair("z", &Vec3::z)}) {
    if (!node.has(key)) continue;
    const Node borders = node.at(key);
    if (!borders.json().is_array() || borders.json().size() != 2) borders.reject("two borders [low, high]");
    scene.cell_low.*axis = borders.at(0).number(), scene.cell_high.*axis = borders.at(1).number();
    scene.setup.periodic.period.*axis = scene.cell_high.*axis - scene.cell_low.*axis;
    if (!(scene.setup.periodic.period.*axis > 0)) borders.reject("two borders [low, high], low < high");
  }
}

void read_outlets(const Node& node, Scene& scene) {
  for (std::size_t k = 0; k < node.size(); ++k) {
    const Node entry = node.at(k);
    entry.allow({"point", "inward"});
    const Vec3 inward = entry.at("inward").vector();
    if (!(norm(inward) > 0)) entry.at("inward").reject("a direction, not zero");
    scene.outlets.push_back({entry.at("point").vector(), inward / norm(inward)});
  }
}

// Where no period says it: the box that boxes take together, else spheres and regions of pours.
void choose_cell(const Node& root, Scene& scene) {
  constexpr double far = std::numeric_limits<double>::max();
  Vec3 low{far, far, far}, high = -low;
  const auto cover = [&](Vec3 from, Vec3 to) {
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z})
      low.*axis = std::min(low.*axis, from.*axis), high.*axis = std::max(high.*axis, to.*axis);
  };
  const std::size_t boxes = root.has("boxes") ? root.at("boxes").size() : 0;
  for (std::size_t k = 0; k < boxes; ++k)
    cover(root.at("boxes").at(k).at("low").vector(), root.at("boxes").at(k).at("high").vector());
  for (std::size_t k = 0; boxes == 0 && k < scene.setup.spheres.size(); ++k) {
    const Sphere& s = scene.setup.spheres[k];
    const Vec3 r{s.radius, s.radius, s.radius};
    cover(s.position - r, s.position + r);
  }
  for (const Pour& pour : scene.pours) cover(pour.region.low(), pour.region.high());
  for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z})
    if (scene.setup.periodic.period.*axis == 0) scene.cell_low.*axis = low.*axis, scene.cell_high.*axis = high.*axis;
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

// Of bodies that overlap; of spheres in a trajectory or a generator too, which no place in the file stands for.
class Overlaps {
 public:
  Overlaps(const Node& root, const Scene& scene) : root_(root), scene_(scene) {}

  std::string look() {
    const auto& spheres = scene_.setup.spheres;
    std::vector<Vec3> positions;
    std::vector<double> radii;
    positions.reserve(spheres.size()), radii.reserve(spheres.size());
    for (const Sphere& s : spheres) positions.push_back(s.position), radii.push_back(s.radius);
    for (const NearPair& pair : near_pairs(positions, radii, 0, scene_.setup.periodic)) {
      const Vec3 way = scene_.setup.periodic.shortest(positions[pair.j] - positions[pair.i]);
      note(
          pair.j, [&] { return place(pair.i); }, radii[pair.i] + radii[pair.j] - norm(way),
          std::min(radii[pair.i], radii[pair.j]));
    }
    for (std::size_t w = 0; w < scene_.setup.walls.size(); ++w) {
      const motion::Surface wall(scene_.setup.walls[w]);
      for (std::size_t i = 0; i < positions.size(); ++i)
        note(
            i, [&] { return scene_.wall_names[w]; }, wall.meet(positions[i], radii[i], 0).overlap, radii[i]);
    }
    if (count_ == 0) return {};
    return fmt::format("{} pairs overlap at the start, {}; their contacts begin at time 0", count_, deepest_);
  }

 private:
  std::string place(std::size_t i) const {
    return i < given() ? fmt::format("/spheres/{}", i) : fmt::format("sphere {}", i + 1);
  }
  std::size_t given() const { return root_.has("spheres") ? root_.at("spheres").size() : 0; }

  template <class Name>
  void note(std::size_t i, Name&& other, double overlap, double radius) {
    if (!(overlap > touching * radius)) return;
    ++count_;
    if (overlap <= deepest_overlap_) return;
    deepest_overlap_ = overlap;
    deepest_ = fmt::format("{} and {} by {} m", place(i), other(), significant(overlap, 3));
    if (overlap < radius) return;
    const std::string found = fmt::format("overlaps {} by {} m at the start; it must be less than a radius, {} m",
                                          other(), significant(overlap, 3), significant(radius, 3));
    if (i < given()) root_.at("spheres").at(i).complain(found);
    root_.complain(fmt::format("sphere {} {}", i + 1, found));
  }

  const Node& root_;
  const Scene& scene_;
  std::size_t count_ = 0;
  double deepest_overlap_ = 0;
  std::string deepest_;
};

void note_materials(const Node& root, const Materials& materials, Scene& scene) {
  scene.materials.resize(materials.size());
  std::map<std::string, std::string> words;
  for (const auto& [name, material] : materials) {
    scene.materials[material.index] = name;
    if (const auto [other, fresh] = words.emplace(species(name), name); !fresh)
      root.at("materials")
          .complain(fmt::format("\"{}\" and \"{}\" are the same word in a trajectory, {}; must differ", other->second,
                                name, other->first));
  }
  scene.stuff.reserve(scene.sphere_count());
  for (std::size_t k = 0; k < scene.sphere_count(); ++k)
    scene.stuff.push_back(static_cast<std::uint32_t>(scene.sphere(k).material));
}

std::string body(const Scene& scene, std::size_t k) {
  const std::size_t spheres = scene.setup.spheres.size();
  return k < spheres ? fmt::format("sphere {}", k + 1) : scene.wall_names[k - spheres];
}

// The period of the wall that swings fastest [s]; infinite where none does.
double shortest_swing(const ClusterSetup& setup) {
  double greatest = 0;
  for (const Wall& wall : setup.walls)
    if (wall.motion.amplitude != Vec3{}) greatest = std::max(greatest, wall.motion.frequency);
  return greatest > 0 ? 1 / greatest : std::numeric_limits<double>::infinity();
}

// The step, such that the output interval is a whole number of steps.
void choose_step(const Node& root, Scene& scene) {
  const double duration = root.at("duration").positive();
  const double interval = root.has("output_interval") ? root.at("output_interval").positive() : duration / 100;
  if (interval > duration) root.at("output_interval").reject("at most the duration");
  scene.stiffest = stiffest_contact(scene.setup);
  const double tcol = scene.stiffest.tcol;
  const double period = shortest_swing(scene.setup);
  double step = std::min(tcol > 0 ? std::min(tcol / steps_per_collision, interval) : interval / 100,
                         period / steps_per_collision);
  if (root.has("step")) {
    step = root.at("step").positive();
    if (step > interval) root.at("step").reject(fmt::format("at most the output interval, {} s", shortest(interval)));
    if (tcol > 0 && step > tcol / least_steps_per_collision)
      root.at("step").reject(fmt::format("at most {} s, a 20th of the {} s that {} and {} {}",
                                         shortest(tcol / least_steps_per_collision), significant(tcol, 3),
                                         body(scene, scene.stiffest.i), body(scene, scene.stiffest.j),
                                         scene.stiffest.tangential ? "swing on their tangential spring" : "collide"));
    if (step > period / least_steps_per_collision)
      root.at("step").reject(fmt::format("at most {} s, a 20th of the {} s that a wall takes to swing",
                                         shortest(period / least_steps_per_collision), significant(period, 3)));
  }
  const double per_output = std::ceil(interval / step * (1 - 1e-12));
  if (duration / step > 1e15)
    root.at("duration").reject(fmt::format("less than 1e15 steps of {} s", significant(step, 3)));
  scene.output_every = static_cast<std::uint64_t>(per_output);
  scene.options.step = interval / per_output;
  scene.steps = static_cast<std::uint64_t>(std::ceil(duration / scene.options.step * (1 - 1e-12)));
  scene.options.longest_contact = std::min(duration, 4e5 * scene.options.step);
}

}  // namespace

namespace {

// Everybody that will ever be there, whether from the start or later.
void read_bodies(const std::string& file, const Node& root, const Materials& materials, Scene& scene, std::string& used,
                 Work& work) {
  if (root.has("periodic")) read_periods(root.at("periodic"), scene);
  read_walls(root, materials, scene);
  if (root.has("spheres")) read_spheres(root.at("spheres"), materials, scene, work);
  if (root.has("start")) used += read_start(root.at("start"), file, materials, scene);
  generate(root, materials, scene);
  if (root.has("outlets")) read_outlets(root.at("outlets"), scene);
  if (scene.sphere_count() == 0) {
    if (root.has("spheres")) root.at("spheres").reject("at least one sphere");
    root.complain("\"spheres\" is missing; they, \"start\", \"lattice\" or \"pour\" must be given");
  }
  choose_cell(root, scene);
}

// What a cluster would refuse, or could not move right.
/// Doubles tell a place in its cell to 1e-10 of a period as far as this many periods off.
void check_distances(const Node& root, const Scene& scene) {
  constexpr double most_periods = 1e6;
  const std::size_t given = root.has("spheres") ? root.at("spheres").size() : 0;
  for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z})
    for (std::size_t i = 0; i < scene.setup.spheres.size() && scene.setup.periodic.period.*axis > 0; ++i) {
      if (std::abs(scene.setup.spheres[i].position.*axis) <= most_periods * scene.setup.periodic.period.*axis) continue;
      constexpr const char* accepted = "a million periods off at most along a periodic axis";
      if (i < given) root.at("spheres").at(i).at("position").reject(accepted);
      root.complain(fmt::format("sphere {}: its position must be {}", i + 1, accepted));
    }
}

void check_space(const Node& root, const Scene& scene) {
  check_distances(root, scene);
  double largest = 0, smallest = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < scene.sphere_count(); ++k)
    largest = std::max(largest, scene.sphere(k).radius), smallest = std::min(smallest, scene.sphere(k).radius);
  for (std::size_t w = 0; w < scene.setup.walls.size(); ++w) {
    if (const double width = narrowest(scene.setup.walls[w]); !(largest < width))
      root.complain(fmt::format("a sphere of radius {} m is no smaller than the radius of {}, {} m; it must be smaller",
                                significant(largest, 3), scene.wall_names[w], significant(width, 3)));
    if (!same_along(scene.setup.walls[w], scene.setup.periodic))
      root.at("periodic")
          .complain(fmt::format(
              "{} is not the same all along a periodic axis; it must be, as planes and cylinders along it are",
              scene.wall_names[w]));
  }
  // The neighbour list keeps a third of the smallest radius in reserve.
  const double least = 4 * largest + 2.0 / 3 * smallest;
  for (const auto& [key, axis] : {std::pair("x", &Vec3::x), std::pair("y", &Vec3::y), std::pair("z", &Vec3::z)})
    if (const double period = scene.setup.periodic.period.*axis; period > 0 && !(period > 1.001 * least))
      root.at("periodic")
          .at(key)
          // Such that a value of three digits is accepted.
          .reject(fmt::format("borders more than {} m apart, two diameters", significant(1.006 * least, 3)));
}

}  // namespace

Scene read_scene(const std::string& file, const std::string& text) {
  Work work(file, text.size());
  const console::Json json = console::parse_json(file, text, "docs/scenes.md", work.progress());
  const Node root(file, text, json);
  root.allow({"schema",       "title",           "duration", "output_interval", "step",     "gravity", "materials",
              "interactions", "spheres",         "start",    "lattice",         "pour",     "walls",   "boxes",
              "cylinders",    "cones",           "rings",    "plates",          "periodic", "outlets", "reclosing",
              "insist",       "solver_tolerance"});
  if (root.has("schema")) root.at("schema").one_of({"ricochet/scene/1"});
  Scene scene;
  if (root.has("title")) scene.title = root.at("title").text();
  const Materials materials = read_materials(root.at("materials"));
  ByPair by_pair;
  scene.setup.interactions = read_interactions(root.at("interactions"), materials, by_pair);
  if (root.has("gravity")) scene.setup.gravity = root.at("gravity").vector();
  std::string read = json.dump();
  read_bodies(file, root, materials, scene, read, work);
  note_materials(root, materials, scene);
  if (root.has("reclosing") && root.at("reclosing").one_of({"repels", "silent"}) == "silent")
    scene.options.reclosing = Reclosing::silent;
  if (root.has("solver_tolerance")) {
    scene.options.solver_tolerance = root.at("solver_tolerance").positive();
    if (scene.options.solver_tolerance > 0.01) root.at("solver_tolerance").reject("at most 0.01");
  }
  check_space(root, scene);
  work.part(0, 3);
  scene.remark = Overlaps(root, scene).look();
  work.part(1, 3);
  // Laws by target and the step are for those that come later as well.
  std::vector<Sphere>&spheres = scene.setup.spheres, &later = scene.setup.later;
  const std::size_t first = spheres.size();
  spheres.insert(spheres.end(), later.begin(), later.end());
  check_pairs(root, materials, scene);
  resolve(by_pair, scene.setup);
  choose_step(root, scene);
  later.assign(spheres.begin() + static_cast<std::ptrdiff_t>(first), spheres.end());
  spheres.resize(first);
  if (const std::string ahead = look_ahead(root, scene); !ahead.empty())
    scene.remark += (scene.remark.empty() ? "" : ". ") + ahead;
  scene.fingerprint = fingerprint(read);
  return scene;
}

}  // namespace ricochet::simulate
