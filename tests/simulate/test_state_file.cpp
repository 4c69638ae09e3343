#include "../../simulate/src/state_file.hpp"
#include "open_contacts.hpp"

#include <catch2/catch.hpp>
#include <console/exit.hpp>
#include <console/json.hpp>

#include <cstdint>
#include <regex>

using namespace ricochet;
using namespace ricochet::simulate;
using console::Json;

namespace {

const Scene& scene() {
  static const Scene read = test::open_contacts();
  return read;
}

/// After 300 steps, with contacts of every law; no two of its numbers are the same.
const Checkpoint& saved() {
  static const Checkpoint made = [] {
    Cluster cluster(scene().setup, scene().options);
    REQUIRE(cluster.advance(300));
    Checkpoint c{{1, 2, 3}, false, Format::vtk, {0, 1, 2, 3, 4, 5}, {}, cluster.state()};
    c.state.wall_work = 0.625, c.state.brought = 0.875;
    c.state.unconverged = 7;
    c.state.worst_change = 0.125;
    c.state.long_range_work = 0.375;
    c.state.contacts.at(1).record.end = 5e-4;
    c.state.contacts.at(1).record.how = EncounterEnd::dynamic_contact;
    return c;
  }();
  return made;
}

std::string complaint_of(const std::string& text) {
  try {
    read_checkpoint("d/state.json", text, scene());
  } catch (const console::BadInput& error) {
    CHECK(std::string(error.what()).find('\n') == std::string::npos);
    return std::regex_replace(std::string(error.what()), std::regex(":\\d+:\\d+: "), ": ");
  }
  return "accepted";
}

/// As somebody would write it who knows of the checksum.
std::string complaint(Json state) {
  if (state.is_object()) state["checksum"] = checksum(state);
  return complaint_of(state.dump());
}

/// What is said where the value at a JSON pointer is another.
std::string with(const std::string& place, const Json& value) {
  Json state = Json::parse(write_checkpoint(scene(), saved()));
  state.at(Json::json_pointer(place)) = value;
  return complaint(state);
}

const std::string start = "d/state.json: ";

}  // namespace

TEST_CASE("a state reads back to the last bit, every number in its own place") {
  const std::string text = write_checkpoint(scene(), saved());
  const Checkpoint back = read_checkpoint("d/state.json", text, scene());
  const ClusterState &a = saved().state, &b = back.state;
  CHECK(back.lengths == saved().lengths);
  CHECK(back.complete == saved().complete);
  CHECK(b.steps == a.steps);
  CHECK(b.half_positions == a.half_positions);
  CHECK(b.velocities == a.velocities);
  CHECK(b.spins == a.spins);
  CHECK(b.velocity_gains == a.velocity_gains);
  CHECK(b.spin_gains == a.spin_gains);
  CHECK(b.lost_normal == a.lost_normal);
  CHECK(b.lost_friction == a.lost_friction);
  CHECK(b.long_range_work == a.long_range_work);
  CHECK(b.wall_work == a.wall_work);
  CHECK(b.brought == a.brought);
  CHECK(back.format == Format::vtk);
  CHECK(back.present == saved().present);
  CHECK(b.unconverged == a.unconverged);
  CHECK(b.worst_change == a.worst_change);
  REQUIRE(b.contacts.size() == a.contacts.size());
  REQUIRE(b.memories.size() == a.memories.size());
  REQUIRE(a.contacts.size() >= 7);
  for (std::size_t k = 0; k < a.contacts.size(); ++k) {
    const ContactState &c = a.contacts[k], &d = b.contacts[k];
    CAPTURE(k);
    CHECK(d.record == c.record);
    CHECK(b.memories[k].law == a.memories[k].law);
    CHECK(b.memories[k].values == a.memories[k].values);
    CHECK(d.approach.overlap == c.approach.overlap);
    CHECK(d.approach.rate == c.approach.rate);
    CHECK(d.force == c.force);
    CHECK(d.lag == c.lag);
    CHECK(d.fresh == c.fresh);
    CHECK(d.normal_impulse == c.normal_impulse);
    CHECK(d.friction.sliding == c.friction.sliding);
    CHECK(d.friction.torsion == c.friction.torsion);
    CHECK(d.friction.rolling == c.friction.rolling);
    CHECK(d.stored == c.stored);
    CHECK(d.impact_rate == c.impact_rate);
    CHECK(d.speed_scale == c.speed_scale);
    CHECK(d.elongation == c.elongation);
    CHECK(d.strained == c.strained);
  }
}

TEST_CASE("the file says by name what it holds") {
  const Json state = Json::parse(write_checkpoint(scene(), saved()));
  const ClusterState& s = saved().state;
  CHECK(state.at("schema") == "ricochet/state/6");
  CHECK(state.at("lost_normal") == s.lost_normal);
  CHECK(state.at("lost_friction") == s.lost_friction);
  CHECK(state.at("contacts").at(0).at("memory") == s.memories[0].values);
  const Json& contact = state.at("contacts").at(1);
  CHECK(contact.at("law") == "linear");
  CHECK(contact.at("memory").empty());
  CHECK(contact.at("sliding").at(1) == s.contacts[1].friction.sliding.y);
  CHECK(contact.at("rolling").at(0) == s.contacts[1].friction.rolling.x);
  CHECK(contact.at("torsion") == s.contacts[1].friction.torsion);
  CHECK(contact.at("lag") == scene().options.step);
}

TEST_CASE("every value of a state is checked before it is used, and named where it is wrong") {
  CHECK(with("/steps", 300) == "accepted");
  CHECK(with("/steps", -1) == start + "/steps = -1: must be an integer from 0 to 3000");
  CHECK(with("/steps", 1.5) == start + "/steps = 1.5: must be an integer from 0 to 3000");
  CHECK(with("/steps", 1e300) == start + "/steps = 1e+300: must be an integer from 0 to 3000");
  CHECK(with("/steps", 3001) == start + "/steps = 3001: must be an integer from 0 to 3000");
  CHECK(with("/complete", 1) == start + "/complete = 1: must be true or false");
  CHECK(with("/complete", true) == start + "/complete = true: must be false before the last step");
  CHECK(with("/lengths", {1, 2}) == start + "/lengths = [1,2]: must be an array of 3 lengths");
  CHECK(with("/lengths/1", -2) == start + "/lengths/1 = -2: must be an integer from 1 to 9223372036854775807");
  CHECK(with("/lengths/0", 0) == start + "/lengths/0 = 0: must be an integer from 1 to 9223372036854775807");
  CHECK(with("/velocities", Json::array()) == start + "/velocities = []: must be an array of 6 vectors, one a sphere");
  CHECK(with("/half_positions/2/0", nullptr) == start + "/half_positions/2/0 = null: must be a finite number");
  CHECK(with("/spins/5", {1, 2}) == start + "/spins/5 = [1,2]: must be three numbers [x, y, z]");
  CHECK(with("/lost_friction", "much") == start + "/lost_friction = \"much\": must be a finite number");
  CHECK(with("/solver/unconverged_steps", 301) ==
        start + "/solver/unconverged_steps = 301: must be an integer from 0 to 300");
  CHECK(with("/present/5", 6) == start + "/present/5 = 6: must be an integer from 0 to 5");
  CHECK(with("/present/5", 1) == start + "/present/5 = 1: must be a sphere that is there once");
  CHECK(with("/present", {0, 1}) == start + "/present: 2 spheres; must be 6, as none can leave");
  CHECK(with("/poured", {1}) == start + "/poured = [1]: must be an array of 0 numbers, one a pour");
  CHECK(with("/format", "ply") == start + "/format = \"ply\": must be xyz or vtk");
  CHECK(with("/wall_work", nullptr) == start + "/wall_work = null: must be a finite number");
  CHECK(with("/contacts", 3) == start + "/contacts = 3: must be an array");
}

TEST_CASE("a contact of a state is checked against the scene") {
  const std::string first = "/contacts/0/";
  CHECK(with(first + "how", -1) == start + first + "how = -1: must be an integer from 0 to 0");
  CHECK(with(first + "how", 99) == start + first + "how = 99: must be an integer from 0 to 0");
  CHECK(with("/contacts/1/how", 0) == start + "/contacts/1/how = 0: must be an integer from 1 to 6");
  CHECK(with("/contacts/1/how", 7) == start + "/contacts/1/how = 7: must be an integer from 1 to 6");
  CHECK(with("/contacts/1/end", -1) == start + "/contacts/1/end = -1: must be a number >= 0");
  CHECK(with("/contacts/1/end", 1).find("end = 1.0: must be a time from 0 to 0.0006") == std::string::npos);
  CHECK(with(first + "begin", 1).rfind(start + first + "begin = 1: must be a time from 0 to 0.0006", 0) == 0);
  CHECK(with(first + "pair/0", 6) == start + first + "pair/0 = 6: must be an integer from 0 to 5");
  CHECK(with(first + "pair/1", 7) == start + first + "pair/1 = 7: must be an integer from 1 to 6");
  CHECK(with(first + "pair", {1, 0}) == start + first + "pair/1 = 0: must be an integer from 2 to 6");
  CHECK(with(first + "pair", {3, 6}).rfind(start + first + "law = \"fractional\": must be \"hysteretic\"", 0) == 0);
  CHECK(with("/contacts/1/pair", {0, 1}).find("must be after that of the contact before") != std::string::npos);
  CHECK(with(first + "law", "tsuji") == start + first + "law = \"tsuji\": must be \"fractional\", as in the scene");
  CHECK(with(first + "memory", {1}) ==
        start + first + "memory = [1]: must be an array of 24 numbers, the memory of the law \"fractional\"");
  CHECK(with("/contacts/1/memory", {1}) ==
        start + "/contacts/1/memory = [1]: must be an array of 0 numbers, the memory of the law \"linear\"");
  CHECK(with(first + "memory/3", "a") == start + first + "memory/3 = \"a\": must be a finite number");
  CHECK(with(first + "lag", 0) == start + first + "lag = 0: must be a number > 0");
  CHECK(with(first + "lag", 1) == start + first + "lag = 1: must be at most the step");
  CHECK(with(first + "phases", Json::array()) == start + first + "phases = []: must be an array of 6 times");
  CHECK(with(first + "sliding", 1) == start + first + "sliding = 1: must be three numbers [x, y, z]");
  const auto place_of = [](bool springs) {
    const auto& all = saved().state.contacts;
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& c) { return (c.strained > 0) == springs; });
    REQUIRE(found != all.end());
    return "/contacts/" + std::to_string(found - all.begin()) + "/";
  };
  const std::string sprung = place_of(true), rigid = place_of(false);
  CHECK(with(sprung + "elongation/slide", {1e-6, 0}) ==
        start + sprung + "elongation/slide = [1e-06,0]: must be three numbers [x, y, z]");
  CHECK(with(sprung + "elongation/twist", nullptr) ==
        start + sprung + "elongation/twist = null: must be a finite number");
  CHECK(with(sprung + "elongation", {{"bent", 1}}).find("bent") != std::string::npos);
  CHECK(with(sprung + "strained", -1) == start + sprung + "strained = -1: must be a number >= 0");
  CHECK(with(rigid + "strained", 1) == start + rigid + "strained = 1: must be 0 where friction is rigid");
  CHECK(with(rigid + "elongation/twist", 1).find("must be zero where friction is rigid") != std::string::npos);
  Json state = Json::parse(write_checkpoint(scene(), saved()));
  state["contacts"][0].erase("force");
  CHECK(complaint(state) == start + "/contacts/0: \"force\" is missing; it must be given");
}

TEST_CASE("what no run of the scene comes to is not taken up") {
  // After 300 steps of 2 us: a grain of 0.01 m gets no faster than 0.01 m a step, none farther than 301 radii from
  // where the farthest began.
  const double farthest = norm(scene().setup.spheres[5].position) + 0.01 * 301;
  const double step = scene().options.step;
  CHECK(with("/velocities/2", {0.999 * 0.01 / step, 0, 0}) == "accepted");
  CHECK(with("/velocities/2", {0, 1.001 * 0.01 / step, 0}) ==
        start +
            "/velocities/2 = [0,5005.0,0]: must be a vector of at most 5e+03 m/s, as the scene lets it become "
            "by then");
  CHECK(with("/velocity_gains/2/1", 2.01 * 0.01 / step).find("/velocity_gains/2 = ") != std::string::npos);
  CHECK(with("/velocity_gains/2/1", 1e300).find("velocity_gains/2 = ") != std::string::npos);
  CHECK(with("/half_positions/3/1", 0.9 * farthest) == "accepted");
  CHECK(with("/half_positions/3/1", 1.05 * farthest).find("/half_positions/3 = ") != std::string::npos);
  CHECK(with("/half_positions/3/1", 1e300).find("m, as the scene lets it become by then") != std::string::npos);
  CHECK(with("/spins/0/2", 1e150) == "accepted");
  CHECK(with("/spins/0/2", 1e155).find("/spins/0 = ") != std::string::npos);
  CHECK(with("/spin_gains/0/2", 1e155).find("/spin_gains/0 = ") != std::string::npos);
  const std::string first = "/contacts/0/";
  CHECK(with(first + "overlap", 0.0149) == "accepted");
  CHECK(with(first + "overlap", -0.0151) == start + first + "overlap = -0.0151: must be at most 0.015 m in size");
  CHECK(with(first + "phases/0", 1).rfind(start + first + "phases/0 = 1: must be a time from ", 0) == 0);
}

TEST_CASE("every state that a run saves lies within the bounds") {
  Cluster cluster(scene().setup, scene().options);
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    const Checkpoint c{{1, 2, 3}, false, Format::xyz, {0, 1, 2, 3, 4, 5}, {}, cluster.state()};
    REQUIRE(complaint_of(write_checkpoint(scene(), c)) == "accepted");
    REQUIRE(cluster.advance(29));
  }
}

TEST_CASE("who is there has come and has not left") {
  const auto pouring = [](const std::string& outlets) {
    return read_scene("s.json", R"({"duration": 0.1, "step": 1e-4, "materials": {"g": {"density": 2000}},
      "interactions": [{"between": ["g", "g"], "law": {"name": "linear", "k": 100, "c": 0}}],
      "spheres": [{"radius": 0.01, "material": "g", "position": [0, 0, 0]}],
      "pour": [{"number": 3, "radius": 0.01, "material": "g", "rate": 100, "seed": 1,
                "region": {"low": [1, 1, 1], "high": [2, 2, 2]}}])" +
                                    outlets + "}");
  };
  const auto said = [](const Scene& scene, std::vector<std::uint32_t> present, std::uint64_t poured) {
    ClusterState s;
    s.half_positions.resize(present.size()), s.velocities.resize(present.size()), s.spins.resize(present.size());
    s.velocity_gains.resize(present.size()), s.spin_gains.resize(present.size());
    try {
      read_checkpoint("s", write_checkpoint(scene, {{1, 1, 1}, false, Format::xyz, present, {poured}, s}), scene);
    } catch (const console::BadInput& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  const Scene closed = pouring(""), open = pouring(R"(, "outlets": [{"point": [0, 0, -1], "inward": [0, 0, 1]}])");
  CHECK(said(closed, {0}, 0) == "accepted");
  CHECK(said(closed, {0, 1, 2}, 2) == "accepted");
  CHECK(said(closed, {0, 1}, 2).find("/present: 2 spheres; must be 3, as none can leave") != std::string::npos);
  CHECK(said(closed, {0, 3}, 1).find("/present/1 = 3: must be a sphere that has been poured") != std::string::npos);
  CHECK(said(open, {1}, 2) == "accepted");
  CHECK(said(open, {0, 3}, 2).find("/present/1 = 3: must be a sphere that has been poured") != std::string::npos);
}

TEST_CASE("a state that was changed since it was saved says so, whatever was changed") {
  const std::string text = write_checkpoint(scene(), saved());
  CHECK(complaint_of(text) == "accepted");
  Json state = Json::parse(text);
  const std::string sum = state.at("checksum");
  // FNV-1a of what stands before the checksum, as its authors define it.
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : text.substr(0, text.find(R"(,"checksum")")) + "}")
    hash ^= static_cast<unsigned char>(c), hash *= 1099511628211u;
  CHECK(sum == std::to_string(hash));
  state.at("lost_normal") = 2 * saved().state.lost_normal;
  CHECK(complaint_of(state.dump())
            .rfind(start + "changed since simulate saved it: the checksum of what it says is ", 0) == 0);
  state = Json::parse(text);
  state.erase("checksum");
  CHECK(complaint_of(state.dump()).find("changed since simulate saved it") != std::string::npos);
  // Blanks say nothing.
  CHECK(complaint_of(Json::parse(text).dump(2)) == "accepted");
}

TEST_CASE("a state that is no whole JSON is damaged") {
  const std::string text = write_checkpoint(scene(), saved());
  const std::string damaged =
      start +
      "no JSON: must be one object as docs/scenes.md describes; the state is damaged, start again without "
      "--resume";
  CHECK(complaint_of(text.substr(0, text.size() / 2)) == damaged);
  CHECK(complaint_of("") == damaged);
  CHECK(complaint_of(R"({"schema": )" + std::string(1'000'000, '[')).find("brackets in more than 64 brackets") !=
        std::string::npos);
}

TEST_CASE("what is no state of this scene and version is told apart") {
  CHECK(complaint(Json::object()) == start + "must be a state that simulate saved; start again without --resume");
  CHECK(with("/schema", "ricochet/scene/1") == complaint(Json::object()));
  CHECK(with("/schema", "ricochet/state/1") ==
        start +
            "/schema = \"ricochet/state/1\": must be \"ricochet/state/6\", as this version of simulate saves; "
            "start again without --resume");
  CHECK(with("/scene", "1") == start + "of another scene; must be of the one given");
  CHECK(complaint_of("7") == complaint(Json::object()));
}
