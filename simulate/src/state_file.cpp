#include "state_file.hpp"

#include "fingerprint.hpp"
#include "state_bounds.hpp"

#include <console/bound.hpp>
#include <console/exit.hpp>
#include <console/node.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

namespace ricochet::simulate {
namespace {

using console::Json;
using console::Node;
using Present = std::vector<std::uint32_t>;

constexpr const char* schema = "ricochet/state/6";
constexpr auto any_integer = std::numeric_limits<std::int64_t>::max();

Json json(double value) { return console::number_or_null(value); }  // only `never` is infinite

Json json(std::span<const double> values) {
  Json j = Json::array();
  for (double v : values) j.push_back(json(v));
  return j;
}

Json json(Vec3 v) { return {v.x, v.y, v.z}; }

Json json(std::span<const Vec3> vectors) {
  Json j = Json::array();
  for (Vec3 v : vectors) j.push_back(json(v));
  return j;
}

Json json(const ContactState& c, const ContactMemory& memory) {
  const Encounter& r = c.record;
  return {{"pair", {r.i, r.j}},
          {"begin", r.begin},
          {"end", json(r.end)},
          {"how", static_cast<int>(r.how)},
          {"phases", json(r.phase_begin)},
          {"law", memory.law},
          {"memory", json(memory.values)},
          {"overlap", c.approach.overlap},
          {"rate", c.approach.rate},
          {"force", c.force},
          {"lag", c.lag},
          {"impulse", c.normal_impulse},
          {"sliding", json(c.friction.sliding)},
          {"torsion", c.friction.torsion},
          {"rolling", json(c.friction.rolling)},
          {"stored", c.stored},
          {"impact_rate", c.impact_rate},
          {"speed_scale", c.speed_scale},
          {"elongation",
           {{"slide", json(c.elongation.slide)}, {"twist", c.elongation.twist}, {"roll", json(c.elongation.roll)}}},
          {"strained", c.strained}};
}

void expect_length(const Node& array, std::size_t length, const std::string& of_what) {
  if (!array.json().is_array() || array.json().size() != length)
    array.reject(fmt::format("an array of {} {}", length, of_what));
}

double read_time(const Node& node, double earliest, double latest) {
  const double time = node.not_negative();
  if (time < earliest || time > latest)
    node.reject(fmt::format("a time from {} to {} s", console::shortest(earliest), console::shortest(latest)));
  return time;
}

double time_or_never(const Node& node, double earliest, double latest) {
  return node.json().is_null() ? Encounter::never : read_time(node, earliest, latest);
}

double no_greater(const Node& node, double most, const char* unit) {
  const double value = node.number();
  if (!(std::abs(value) <= most))
    node.reject(fmt::format("at most {} {} in size", console::bound_text(console::Bound::upper, most, 3), unit));
  return value;
}

// Vectors, one a sphere that is there, none longer than `most` says of its sphere.
template <class Most>
std::vector<Vec3> read_vectors(const Node& node, const Scene& scene, const Present& present, Most&& most,
                               const char* unit) {
  expect_length(node, present.size(), "vectors, one a sphere");
  std::vector<Vec3> all;
  all.reserve(present.size());
  for (std::size_t k = 0; k < present.size(); ++k) {
    const Node one = node.at(k);
    const double longest = most(scene.sphere(present[k]));
    if (all.push_back(one.vector()); !(norm(all.back()) <= longest))
      one.reject(fmt::format("a vector of at most {} {}, as the scene lets it become by then",
                             console::bound_text(console::Bound::upper, longest, 3), unit));
  }
  return all;
}

// Bodies of a contact, in the order that contacts have: by i, then by j.
void read_pair(const Node& node, const Scene& scene, std::size_t spheres, Encounter& record) {
  const std::size_t bodies = spheres + scene.setup.walls.size();
  if (spheres == 0) node.reject("nothing, as no sphere is there");
  expect_length(node, 2, "bodies");
  record.i = static_cast<std::uint32_t>(node.at(0).integer(0, spheres - 1));
  record.j = static_cast<std::uint32_t>(node.at(1).integer(record.i + std::uint64_t(1), bodies - 1));
}

void read_record(const Node& node, double latest, Encounter& r) {
  r.begin = read_time(node.at("begin"), 0, latest);
  r.end = time_or_never(node.at("end"), r.begin, latest);
  const Node how = node.at("how");
  r.how = static_cast<EncounterEnd>(r.end == Encounter::never ? how.integer(0, 0)
                                                              : how.integer(1, encounter_end_count - 1));
  const Node phases = node.at("phases");
  expect_length(phases, phase_count, "times");
  for (std::size_t k = 0; k < phase_count; ++k) r.phase_begin[k] = time_or_never(phases.at(k), r.begin, latest);
}

const Interaction& interaction_between(const Scene& scene, const Present& present, const Encounter& r) {
  const std::size_t a = scene.sphere(present[r.i]).material;
  const std::size_t b =
      r.j < present.size() ? scene.sphere(present[r.j]).material : scene.setup.walls[r.j - present.size()].material;
  return scene.setup.interactions.at(std::minmax(a, b));
}

void read_springs(const Node& node, bool compliant, ContactState& c) {
  const Node elongation = node.at("elongation");
  elongation.allow({"slide", "twist", "roll"});
  c.elongation = {elongation.at("slide").vector(), elongation.at("twist").number(), elongation.at("roll").vector()};
  c.strained = node.at("strained").not_negative();
  if (compliant) return;
  if (c.elongation != Elongation{}) elongation.reject("zero where friction is rigid");
  if (c.strained != 0) node.at("strained").reject("0 where friction is rigid");
}

ContactMemory read_memory(const Node& node, const NormalLaw& law) {
  const std::string name(law.name());
  if (node.at("law").text() != name) node.at("law").reject(fmt::format("\"{}\", as in the scene", name));
  const Node memory = node.at("memory");
  expect_length(memory, law.memory_size(), fmt::format("numbers, the memory of the law \"{}\"", name));
  ContactMemory read{name, {}};
  for (std::size_t k = 0; k < law.memory_size(); ++k) read.values.push_back(memory.at(k).number());
  return read;
}

// Deeper than that the run would have ended.
double deepest(const Scene& scene, const Present& present, const Encounter& r) {
  double radius = scene.sphere(present[r.i]).radius;
  if (r.j < present.size()) radius = std::min(radius, scene.sphere(present[r.j]).radius);
  return StateBounds::overlap(radius);
}

ContactState read_contact(const Node& node, const Scene& scene, const Present& present, const StateBounds& bounds) {
  node.allow({"pair",    "begin",  "end",         "how",         "phases",     "law",     "memory",
              "overlap", "rate",   "force",       "lag",         "impulse",    "sliding", "torsion",
              "rolling", "stored", "impact_rate", "speed_scale", "elongation", "strained"});
  ContactState c;
  read_pair(node.at("pair"), scene, present.size(), c.record);
  read_record(node, bounds.latest(), c.record);
  c.approach = {no_greater(node.at("overlap"), deepest(scene, present, c.record), "m"), node.at("rate").number()};
  c.force = node.at("force").number();
  c.lag = node.at("lag").positive();
  if (c.lag > scene.options.step) node.at("lag").reject("at most the step");
  c.normal_impulse = node.at("impulse").number();
  c.friction = {node.at("sliding").vector(), node.at("torsion").number(), node.at("rolling").vector()};
  c.stored = node.at("stored").number();
  c.impact_rate = node.at("impact_rate").number();
  c.speed_scale = node.at("speed_scale").not_negative();
  return c;
}

void read_contacts(const Node& node, const Scene& scene, const Present& present, const StateBounds& bounds,
                   ClusterState& state) {
  for (std::size_t k = 0; k < node.size(); ++k) {
    const Node one = node.at(k);
    state.contacts.push_back(read_contact(one, scene, present, bounds));
    const Encounter& now = state.contacts[k].record;
    if (k > 0) {
      const Encounter& last = state.contacts[k - 1].record;
      if (std::pair(last.i, last.j) >= std::pair(now.i, now.j))
        one.at("pair").reject("after that of the contact before");
    }
    const Interaction& interaction = interaction_between(scene, present, now);
    state.memories.push_back(read_memory(one, interaction.law));
    read_springs(one, compliant(interaction.tangential), state.contacts[k]);
  }
}

// Spheres of the scene, each once; those of the start stay in their order, but nothing depends on that.
Present read_present(const Node& node, const Scene& scene) {
  Present present;
  std::vector<bool> there(scene.sphere_count());
  for (std::size_t k = 0; k < node.size(); ++k) {
    const auto number = node.at(k).integer(0, scene.sphere_count() - 1);
    if (there[number]) node.at(k).reject("a sphere that is there once");
    there[number] = true;
    present.push_back(static_cast<std::uint32_t>(number));
  }
  return present;
}

std::vector<std::uint64_t> read_brought(const Node& node, const Scene& scene) {
  expect_length(node, scene.pours.size(), "numbers, one a pour");
  std::vector<std::uint64_t> brought;
  brought.reserve(scene.pours.size());
  for (std::size_t p = 0; p < scene.pours.size(); ++p) brought.push_back(node.at(p).integer(0, scene.pours[p].count));
  return brought;
}

// Nobody is there before being poured, and nobody leaves but through an outlet.
void check_present(const Node& node, const Scene& scene, const Checkpoint& c) {
  std::size_t all = scene.setup.spheres.size();
  for (std::size_t p = 0; p < scene.pours.size(); ++p) all += c.brought[p];
  for (std::size_t k = 0; k < c.present.size(); ++k)
    for (std::size_t p = 0; p < scene.pours.size(); ++p) {
      const std::size_t first = scene.setup.spheres.size() + scene.pours[p].first;
      if (c.present[k] >= first + c.brought[p] && c.present[k] < first + scene.pours[p].count)
        node.at(k).reject("a sphere that has been poured");
    }
  if (scene.outlets.empty() && c.present.size() != all)
    node.complain(fmt::format("{} spheres; must be {}, as none can leave", c.present.size(), all));
}

ClusterState read_state(const Node& root, const Scene& scene, const Present& present) {
  ClusterState s;
  const std::size_t bodies = present.size() + scene.setup.walls.size();
  s.steps = root.at("steps").integer(0, scene.steps);
  const StateBounds bounds(scene, s.steps);
  const auto vectors = [&](const char* key, auto&& most, const char* unit) {
    return read_vectors(root.at(key), scene, present, most, unit);
  };
  const auto spin = [](const Sphere& sphere) { return StateBounds::spin(sphere); };
  s.half_positions = vectors(
      "half_positions", [&](const Sphere& one) { return bounds.distance(one); }, "m");
  s.velocities = vectors(
      "velocities", [&](const Sphere& one) { return bounds.speed(one); }, "m/s");
  s.spins = vectors("spins", spin, "1/s");
  s.velocity_gains = vectors(
      "velocity_gains", [&](const Sphere& one) { return 2 * bounds.speed(one); }, "m/s");
  s.spin_gains = vectors("spin_gains", spin, "1/s");
  s.velocities.resize(bodies);
  s.spins.resize(bodies);
  read_contacts(root.at("contacts"), scene, present, bounds, s);
  s.lost_normal = root.at("lost_normal").number();
  s.lost_friction = root.at("lost_friction").number();
  s.long_range_work = root.at("long_range_work").number();
  s.wall_work = root.at("wall_work").number();
  s.brought = root.at("brought").number();
  const Node solver = root.at("solver");
  solver.allow({"unconverged_steps", "largest_change"});
  s.unconverged = solver.at("unconverged_steps").integer(0, s.steps);
  s.worst_change = solver.at("largest_change").not_negative();
  return s;
}

// What tells another file, another version, another scene and one that was changed from a state with wrong values.
void check_kind(const std::string& file, const Json& json, const Scene& scene) {
  const auto text_of = [&](const char* key) {
    return json.is_object() && json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
  };
  const std::string written = text_of("schema"), family = "ricochet/state/";
  if (written.compare(0, family.size(), family) != 0)
    throw console::BadInput(file + ": must be a state that simulate saved; start again without --resume");
  if (written != schema)
    throw console::BadInput(
        fmt::format("{}: /schema = {}: must be \"{}\", as this version of simulate saves; start "
                    "again without --resume",
                    file, json["schema"].dump(), schema));
  if (text_of("scene") != scene.fingerprint)
    throw console::BadInput(file + ": of another scene; must be of the one given");
  if (const std::string found = checksum(json); text_of("checksum") != found)
    throw console::BadInput(
        fmt::format("{}: changed since simulate saved it: the checksum of what it says is {}; must be as it was, or "
                    "start again without --resume",
                    file, found));
}

Json parse_state(const std::string& file, const std::string& text) {
  try {
    return console::parse_json(file, text, "docs/scenes.md");
  } catch (const console::BadInput& error) {
    throw console::BadInput(fmt::format("{}; the state is damaged, start again without --resume", error.what()));
  }
}

}  // namespace

std::string checksum(Json state) {
  if (state.is_object()) state.erase("checksum");
  return fingerprint(state.dump());
}

std::string write_checkpoint(const Scene& scene, const Checkpoint& c) {
  const ClusterState& s = c.state;
  Json contacts = Json::array();
  for (std::size_t k = 0; k < s.contacts.size(); ++k) contacts.push_back(json(s.contacts[k], s.memories[k]));
  const std::size_t spheres = s.half_positions.size();  // walls follow from the time
  Json j = {{"schema", schema},
            {"scene", scene.fingerprint},
            {"lengths", c.lengths},
            {"complete", c.complete},
            {"format", c.format == Format::vtk ? "vtk" : "xyz"},
            {"present", c.present},
            {"poured", c.brought},
            {"steps", s.steps},
            {"half_positions", json(s.half_positions)},
            {"velocities", json(std::span(s.velocities).first(spheres))},
            {"spins", json(std::span(s.spins).first(spheres))},
            {"velocity_gains", json(s.velocity_gains)},
            {"spin_gains", json(s.spin_gains)},
            {"contacts", contacts},
            {"lost_normal", s.lost_normal},
            {"lost_friction", s.lost_friction},
            {"long_range_work", s.long_range_work},
            {"wall_work", s.wall_work},
            {"brought", s.brought},
            {"solver", {{"unconverged_steps", s.unconverged}, {"largest_change", s.worst_change}}}};
  j["checksum"] = checksum(j);
  return j.dump() + "\n";
}

Checkpoint read_checkpoint(const std::string& file, const std::string& text, const Scene& scene) {
  const Json json = parse_state(file, text);
  check_kind(file, json, scene);
  const Node root(file, text, json);
  root.allow({"schema",          "scene",  "checksum",  "lengths",        "complete",   "steps",       "half_positions",
              "velocities",      "spins",  "contacts",  "velocity_gains", "spin_gains", "lost_normal", "lost_friction",
              "long_range_work", "solver", "wall_work", "brought",        "format",     "present",     "poured"});
  Checkpoint c;
  expect_length(root.at("lengths"), c.lengths.size(), "lengths");
  for (std::size_t k = 0; k < c.lengths.size(); ++k) c.lengths[k] = root.at("lengths").at(k).integer(1, any_integer);
  c.complete = root.at("complete").yes_or_no();
  c.format = root.at("format").one_of({"xyz", "vtk"}) == "vtk" ? Format::vtk : Format::xyz;
  c.present = read_present(root.at("present"), scene);
  c.brought = read_brought(root.at("poured"), scene);
  check_present(root.at("present"), scene, c);
  c.state = read_state(root, scene, c.present);
  if (c.complete && c.state.steps != scene.steps) root.at("complete").reject("false before the last step");
  return c;
}

}  // namespace ricochet::simulate
