#include "../lammps/deck.hpp"
#include "../runs/scenes.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

using namespace engines;
using namespace engines::crossing;

namespace {

constexpr double friction = 0.1, slip = 2;
const std::string law = target(tcol, en);

// A grain that strikes the wall x = 0 at a slant.
const Box room{{-0.001, -0.01, -0.01}, {0.02, 0.01, 0.01}};
const Grain striker{.position = {radius + 5 * dt * speed, 0, 0}, .velocity = {-speed, slip, 0}};

Vector velocity_after(const std::string& name, const std::string& parts) {
  const Workplace place(name);
  REQUIRE(place.run(preamble(room) + place.create({striker}, room) + neighbours() + one_law(law, parts) +
                    planes("xplane", "0", "NULL", law, parts) + move(dt) + dump("dump", 100) + run(100)) == 0);
  return place.frames("dump").back().velocity[0];
}

// Two grains that collide while they cross from rank to rank, slip and turn on each other.
std::vector<Grain> slipping_pair(int axis, double drift) {
  auto grains = crossing::pair(axis, drift);
  grains[0].velocity[2] += 0.6;
  grains[1].velocity[2] -= 0.4;
  grains[1].velocity[1 - axis] += 0.2;
  return grains;
}

const std::string frictional =
    "damping fractional tangential linear_history 3000 1 0.4 rolling sds 500 0.05 0.3 twisting marshall";

struct Run {
  std::string name, pairs;
  int ranks = 1;
  std::string newton = "off";
};

std::string start(const Run& run) {
  std::string text = preamble(box, run.ranks == 2 ? "2 1 1" : "1 1 1");
  text.replace(text.find("newton off"), 10, "newton " + run.newton);
  return text;
}

std::string physics(const std::string& pairs) {
  return neighbours("0.0005", "every 1 delay 0 check no") + pairs + move(dt);
}

std::vector<Frame> frames_of(const Run& run, const std::vector<Grain>& grains) {
  Box types = box;
  types.types = 2;
  const Workplace place(run.name + "_" + std::to_string(run.ranks) + run.newton);
  REQUIRE(place.run(start(run) + place.create(grains, types) + physics(run.pairs) + dump("dump") + engines::run(steps),
                    run.ranks) == 0);
  return place.frames("dump");
}

}  // namespace

TEST_CASE("the normal law combines with LAMMPS's tangential, rolling and twisting models") {
  for (const std::string tangential :
       {"linear_nohistory 1 0.1", "linear_history 3000 1 0.1", "linear_history_classic 3e6 1 0.1", "mindlin 3e6 0 0.1",
        "mindlin/force 3e6 0 0.1", "mindlin_rescale 3e6 0 0.1"})
    for (const std::string turning :
         {"", "rolling sds 500 0.05 0.3", "twisting sds 1 1e-3 0.3", "rolling sds 500 0.05 0.3 twisting marshall"}) {
      INFO(tangential << ' ' << turning);
      const auto v = velocity_after("combination", "tangential " + tangential + " " + turning);
      CHECK(v[0] == Approx(en * speed).epsilon(1e-3));
      CHECK(v[1] < slip);
    }
}

TEST_CASE("a grain that slips all through a collision loses μ(1 + en) of its normal speed along the wall") {
  // Its limit μ R is summed by the same kicks as R itself; until the tangential spring slips it takes a little less.
  const auto v = velocity_after("slip", "tangential linear_history 3000 1 0.1");
  CHECK(slip - v[1] == Approx(friction * (speed + v[0])).epsilon(2e-2));
}

TEST_CASE("heat flows through the normal contact") {
  const Workplace place("heat");
  const std::string parts = "tangential linear_nohistory 0 0 heat radius 1e4";
  REQUIRE(place.run(preamble(box) + "fix hot all property/atom temperature heatflow\n" +
                    place.create(crossing::pair(1, 0), box) +
                    "set atom 1 temperature 400\nset atom 2 temperature 300\n" + physics(one_law(law, parts)) +
                    "fix warm all heat/flow constant 1000\n" +
                    "compute each all property/atom temperature\ncompute least all reduce min c_each\n"
                    "compute most all reduce max c_each\n"
                    "thermo_style custom step c_least c_most\n" +
                    engines::run(steps)) == 0);
  std::istringstream lines(place.output());
  double step = 0, least = 0, most = 0;
  for (std::string line; step != steps && std::getline(lines, line);) std::istringstream(line) >> step >> least >> most;
  CHECK(least > 301);
  CHECK(least + most == Approx(700).epsilon(1e-6));  // what the one loses the other gains
}

TEST_CASE("friction, rolling and twisting stay with a pair that crosses from rank to rank, newton on or off") {
  const std::string pairs = one_law(law, frictional);
  for (int axis : {0, 1})
    for (double drift : {30., -30.}) {
      const auto grains = slipping_pair(axis, drift);
      const std::string name =
          std::string("frictional_") + (axis == 0 ? "along" : "across") + (drift > 0 ? "_r" : "_l");
      const auto one = frames_of({name, pairs}, grains);
      for (const char* newton : {"off", "on"}) {
        const auto two = frames_of({name, pairs, 2, newton}, grains);
        CHECK(crossings_in_contact(two, 0) + crossings_in_contact(two, 1) >= (axis == 0 ? 1 : 2));
        CHECK(largest_difference(one, two) == 0);
      }
      CHECK(std::fabs(one.back().velocity[0][2] - grains[0].velocity[2]) > 0.01);  // they did rub
    }
}

TEST_CASE("a run restarted in the middle of contacts keeps friction too") {
  // Without dashpots of LAMMPS's own: these take other velocities when a run is set up.
  const std::string pairs =
      one_law(law, "damping fractional tangential linear_history 3000 0 0.4 rolling sds 500 0 0.3 twisting marshall");
  const auto grains = slipping_pair(1, 30);
  auto whole = frames_of({"frictional_whole", pairs}, grains);
  const int cut = 30;
  whole.erase(whole.begin(), whole.begin() + cut);
  for (const auto& [before, after] : {std::pair{1, 1}, {1, 2}, {2, 1}, {2, 2}}) {
    const Run first{"frictional_restart", pairs, before}, second{"", pairs, after};
    Box types = box;
    types.types = 2;
    const Workplace place(first.name + std::to_string(before) + std::to_string(after));
    REQUIRE(place.run(start(first) + place.create(grains, types) + physics(pairs) + engines::run(cut) +
                          "write_restart cut.restart\n",
                      before) == 0);
    REQUIRE(place.run(start(second) + "read_restart cut.restart\n" + physics(pairs) + dump("rest") +
                          engines::run(steps - cut),
                      after) == 0);
    CHECK(largest_difference(whole, place.frames("rest")) == 0);
  }
}

TEST_CASE("types with other normal models keep their friction when a pair changes ranks") {
  // The stock library copies the first few of a pair's numbers, wherever they lie.
  const std::string pairs =
      pair_style() + pair_coeff("1 1", "hooke 7000 0.3", "damping velocity tangential linear_history 3000 1 0.4") +
      pair_coeff("1*2 2", law, frictional);
  for (int axis : {0, 1})
    for (double drift : {30., -30.}) {
      const auto grains = slipping_pair(axis, drift);
      const auto one = frames_of({"mixed", pairs}, grains), two = frames_of({"mixed", pairs, 2}, grains);
      CHECK(crossings_in_contact(two, 0) + crossings_in_contact(two, 1) >= (axis == 0 ? 1 : 2));
      CHECK(std::fabs(one.back().velocity[0][2] - grains[0].velocity[2]) > 0.01);
      CHECK(largest_difference(one, two) == 0);
    }
}
