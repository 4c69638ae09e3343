#include "state_file.hpp"

#include <console/exit.hpp>
#include <console/json.hpp>

#include <cmath>
#include <span>

namespace ricochet::simulate {
namespace {

using console::Json;

Json json(double value) { return console::number_or_null(value); }  // only `never` is infinite
double number(const Json& j) { return j.is_null() ? Encounter::never : j.get<double>(); }

Json json(std::span<const double> values) {
  Json j = Json::array();
  for (double v : values) j.push_back(json(v));
  return j;
}

void read(const Json& j, std::span<double> values) {
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = number(j.at(k));
}

Json json(Vec3 v) { return {v.x, v.y, v.z}; }
Vec3 vector(const Json& j) { return {j.at(0).get<double>(), j.at(1).get<double>(), j.at(2).get<double>()}; }

Json json(const std::vector<Vec3>& vectors) {
  Json j = Json::array();
  for (Vec3 v : vectors) j.push_back(json(v));
  return j;
}

std::vector<Vec3> vectors(const Json& j) {
  std::vector<Vec3> all;
  for (const Json& v : j) all.push_back(vector(v));
  return all;
}

// A law's memory is told by the length of its array.
Json json(const LawMemory& memory) {
  if (const auto* m = std::get_if<FractionalArms::Memory>(&memory)) return json(std::span<const double>(m->elongation));
  if (const auto* m = std::get_if<Hysteretic::Memory>(&memory)) return json(std::span(&m->max_overlap, 1));
  return Json::array();
}

LawMemory memory(const Json& j) {
  if (j.empty()) return NoMemory{};
  if (j.size() == 1) return Hysteretic::Memory{number(j.at(0))};
  FractionalArms::Memory m;
  read(j, m.elongation);
  return m;
}

Json json(const ContactState& c) {
  const Encounter& r = c.record;
  return {{"pair", {r.i, r.j}},
          {"model", c.model},
          {"fresh", c.fresh},
          {"times", {json(r.begin), json(r.end), json(r.separation)}},
          {"how", static_cast<int>(r.how)},
          {"phases", json(r.phase_begin)},
          {"memory", json(c.memory)},
          {"approach", {c.approach.overlap, c.approach.rate, c.force, c.lag}},
          {"impulses", {c.normal_impulse, c.friction.torsion}},
          {"sliding", json(c.friction.sliding)},
          {"rolling", json(c.friction.rolling)},
          {"stored", c.stored},
          {"speed_scale", c.speed_scale}};
}

ContactState contact(const Json& j) {
  ContactState c;
  c.record.i = j.at("pair").at(0), c.record.j = j.at("pair").at(1);
  c.model = j.at("model");
  c.fresh = j.at("fresh");
  c.record.begin = number(j.at("times").at(0));
  c.record.end = number(j.at("times").at(1));
  c.record.separation = number(j.at("times").at(2));
  c.record.how = static_cast<EncounterEnd>(j.at("how").get<int>());
  read(j.at("phases"), c.record.phase_begin);
  c.memory = memory(j.at("memory"));
  std::array<double, 4> approach{};
  read(j.at("approach"), approach);
  c.approach = {approach[0], approach[1]}, c.force = approach[2], c.lag = approach[3];
  c.normal_impulse = number(j.at("impulses").at(0));
  c.friction = {vector(j.at("sliding")), number(j.at("impulses").at(1)), vector(j.at("rolling"))};
  c.stored = number(j.at("stored"));
  c.speed_scale = number(j.at("speed_scale"));
  return c;
}

constexpr const char* schema = "ricochet/state/1";

}  // namespace

std::string write_checkpoint(const Checkpoint& c) {
  Json contacts = Json::array();
  for (const ContactState& contact : c.state.contacts) contacts.push_back(json(contact));
  const ClusterState& s = c.state;
  const Json j = {{"schema", schema},
                  {"scene", c.fingerprint},
                  {"lengths", c.lengths},
                  {"complete", c.complete},
                  {"steps", s.steps},
                  {"half_positions", json(s.half_positions)},
                  {"velocities", json(s.velocities)},
                  {"spins", json(s.spins)},
                  {"contacts", contacts},
                  {"work", {s.lost_normal, s.lost_friction, s.long_range_work}},
                  {"solver", {{"unconverged_steps", s.unconverged}, {"largest_change", s.worst_change}}}};
  return j.dump() + "\n";
}

Checkpoint read_checkpoint(const std::string& file, const std::string& text) {
  try {
    const Json j = Json::parse(text);
    if (j.at("schema") != schema) throw console::BadInput(file + ": must be of the schema " + std::string(schema));
    Checkpoint c{j.at("scene"), j.at("lengths").get<std::array<std::uint64_t, 3>>(), j.at("complete"), {}};
    c.state.steps = j.at("steps");
    c.state.half_positions = vectors(j.at("half_positions"));
    c.state.velocities = vectors(j.at("velocities"));
    c.state.spins = vectors(j.at("spins"));
    for (const Json& one : j.at("contacts")) c.state.contacts.push_back(contact(one));
    c.state.lost_normal = j.at("work").at(0), c.state.lost_friction = j.at("work").at(1);
    c.state.long_range_work = j.at("work").at(2);
    c.state.unconverged = j.at("solver").at("unconverged_steps");
    c.state.worst_change = j.at("solver").at("largest_change");
    return c;
  } catch (const Json::exception&) {
    throw console::BadInput(file + ": must be a state that simulate saved; start again without --resume");
  }
}

}  // namespace ricochet::simulate
