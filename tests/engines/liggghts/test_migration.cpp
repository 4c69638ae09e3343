#include "../runs/scenes.hpp"
#include "liggghts_run.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>

using namespace engines;
using namespace engines::crossing;

namespace {

std::string physics(const Model& model, const std::string& walls = "") {
  return "neighbor 0.0005 bin\nneigh_modify every 1 delay 0 check no\n" + pair_property("collisionTime", tcol) +
         pair_property("coefficientRestitution", en) + model.properties + "pair_style gran model " + model.name +
         "\npair_coeff * *\n" + walls + "fix move all nve/sphere\ntimestep " + number(dt) + "\n";
}

std::vector<Frame> run_pair(const Model& model, const std::string& name, const std::vector<Grain>& grains, int ranks) {
  const Workplace place(model.name + "_" + name + "_" + std::to_string(ranks));
  const std::string deck = preamble(box, ranks == 2 ? "2 1 1" : "1 1 1") + place.create(grains, box) + physics(model) +
                           dump_command("dump") + "run " + std::to_string(steps) + "\n";
  REQUIRE(place.run(deck, ranks) == 0);
  return place.frames("dump");
}

void check_crossings(const Model& model) {
  for (int axis : {0, 1})
    for (double drift : {30., -30.}) {
      const auto grains = crossing::pair(axis, drift);
      const std::string name =
          std::string("crossing_") + (axis == 0 ? "along" : "across") + (drift > 0 ? "_right" : "_left");
      const auto one = run_pair(model, name, grains, 1), two = run_pair(model, name, grains, 2);
      const int crossed = crossings_in_contact(two, 0) + crossings_in_contact(two, 1);
      const double difference = largest_difference(one, two);
      const Vector va = two.back().velocity[0], vb = two.back().velocity[1];
      const double restitution = (vb[axis] - va[axis]) / speed;
      std::printf("%s, %s: %d crossings in contact, en = %.6f, 2 ranks differ from 1 by %.1e\n", model.name.c_str(),
                  name.c_str(), crossed, restitution, difference);
      CHECK(crossed >= (axis == 0 ? 1 : 2));
      CHECK(restitution == Approx(en).epsilon(1e-3));
      CHECK(difference <= 1e-10);
    }
}

void check_restarts(const Model& model) {
  // A pair that crosses between ranks, one grain on a primitive wall and one on a mesh wall, all in contact at the cut.
  std::vector<Grain> grains = crossing::pair(1, 30);
  const double wall_start = radius + 10 * dt * speed;
  grains.push_back({.position = {-0.01, 0.005, -0.01 + wall_start}, .velocity = {0, 0, -speed}});
  grains.push_back({.position = {0.0145 - wall_start, -0.005, 0.003}, .velocity = {speed, 0, 0}});
  const std::string walls = "fix floor all wall/gran model " + model.name +
                            " primitive type 1 zplane -0.01\n"
                            "fix square all mesh/surface file square.stl type 1 move 0.0145 0. 0.\n"
                            "fix side all wall/gran model " +
                            model.name + " mesh n_meshes 1 meshes square\n";
  for (int ranks : {1, 2}) {
    const Workplace place(model.name + "_restart_" + std::to_string(ranks));
    write_square(place.file("square.stl"), -0.0095, 0.0095);
    const std::string start = preamble(box, ranks == 2 ? "2 1 1" : "1 1 1");
    const int cut = 10 + 20;  // 0.4 t_col into the contacts
    REQUIRE(place.run(start + place.create(grains, box) + physics(model, walls) + dump_command("whole") + "run " +
                          std::to_string(steps) + "\n",
                      ranks) == 0);
    REQUIRE(place.run(start + place.create(grains, box) + physics(model, walls) + "run " + std::to_string(cut) +
                          "\nwrite_restart cut.restart\n",
                      ranks) == 0);
    REQUIRE(place.run(start + "read_restart cut.restart\n" + physics(model, walls) + dump_command("rest") + "run " +
                          std::to_string(steps - cut) + "\n",
                      ranks) == 0);
    auto whole = place.frames("whole");
    const auto rest = place.frames("rest");
    for (int i = 0; i < 4; ++i) {
      const Vector& f = whole[cut].force[i];
      CHECK(std::hypot(f[0], f[1], f[2]) > 0);
    }
    REQUIRE(rest.front().step == cut);
    whole.erase(whole.begin(), whole.begin() + cut);
    const double difference = largest_difference(whole, rest);
    std::printf("%s, restart on %d rank(s): differs from the whole run by %.1e\n", model.name.c_str(), ranks,
                difference);
    CHECK(difference <= 1e-10);
  }
}

}  // namespace

TEST_CASE("a pair that crosses from rank to rank in contact moves as on one rank") {
  for (const Model& model : our_models()) check_crossings(model);
}

TEST_CASE("a run restarted in the middle of contacts goes on as the whole one") {
  for (const Model& model : our_models()) check_restarts(model);
}
