#include "liggghts_run.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace engines;

namespace {

constexpr double tcol = 1e-4, en = 0.8, dt = tcol / 50, speed = 0.5, radius = 1.5e-3, room = 2e-4;
constexpr int bounces = 5;

// A grain that flies to and fro between two obstacles a free path `room` apart. Without gravity its speed after n
// bounces is en^n times the first. The neighbour list's skin is wider than the whole path: it is never rebuilt, so the
// engine itself never forgets a contact.
struct Setting {
  const char* name;
  const char* walls;
  bool grains;  // fixed grains as the obstacles
};

const Setting settings[] = {
    {"primitive",
     "fix left all wall/gran model fractional primitive type 1 xplane 0\n"
     "fix right all wall/gran model fractional primitive type 1 xplane 0.0032\n",
     false},
    {"mesh",
     "fix a all mesh/surface file square.stl type 1\nfix b all mesh/surface file square.stl type 1 move 0.0032 0. 0.\n"
     "fix walls all wall/gran model fractional mesh n_meshes 2 meshes a b\n",
     false},
    {"grains", "group fixed id 2 3\nfix hold fixed freeze\n", true},
};

std::vector<Frame> run_bounces(const Setting& setting, int ranks) {
  // The ranks share the path: they meet at x = 0.0016, where the grain's centre passes at each flight.
  const Box box{{-0.0048, -0.01, -0.01}, {0.008, 0.01, 0.01}};
  const Workplace place(std::string("bounces_") + setting.name + "_" + std::to_string(ranks));
  write_square(place.file("square.stl"), -0.0095, 0.0095);
  std::vector<Grain> grains{{.position = {radius + room, 1e-3, 0}, .velocity = {-speed, 0, 0}}};
  if (setting.grains) {
    grains.push_back({.position = {-radius, 1e-3, 0}});
    grains.push_back({.position = {3 * radius + room, 1e-3, 0}});
  }
  const double duration = room / speed * (1 - std::pow(1 / en, bounces)) / (1 - 1 / en) + (bounces + 0.7) * tcol;
  const std::string deck =
      preamble(box, ranks == 2 ? "2 1 1" : "1 1 1") + place.create(grains, box) +
      "neighbor 0.001 bin\nneigh_modify delay 0\n" + pair_property("collisionTime", tcol) +
      pair_property("coefficientRestitution", en) + "pair_style gran model fractional\npair_coeff * *\n" +
      setting.walls +
      (setting.grains ? "group free subtract all fixed\nfix move free nve/sphere\n" : "fix move all nve/sphere\n") +
      "timestep " + number(dt) + "\n" + dump_command("dump") + "run " +
      std::to_string(static_cast<int>(duration / dt)) + "\n";
  REQUIRE(place.run(deck, ranks) == 0);
  CHECK(place.output().find("Neighbor list builds = 0") != std::string::npos);
  return place.frames("dump");
}

int bounces_in(const std::vector<Frame>& frames) {
  int count = 0;
  for (std::size_t n = 1; n < frames.size(); ++n)
    count += (frames[n - 1].velocity[0][0] < 0) != (frames[n].velocity[0][0] < 0);
  return count;
}

}  // namespace

TEST_CASE("each of five bounces between neighbour rebuilds starts without memory of the one before") {
  for (const Setting& setting : settings) {
    const auto one = run_bounces(setting, 1), two = run_bounces(setting, 2);
    REQUIRE(bounces_in(one) == bounces);
    const double restitution = std::pow(std::fabs(one.back().velocity[0][0]) / speed, 1. / bounces);
    const double difference = largest_difference(one, two);
    std::printf("%s: en = %.6f a bounce (%g asked), 2 ranks differ from 1 by %.1e\n", setting.name, restitution, en,
                difference);
    CHECK(restitution == Approx(en).epsilon(1e-3));
    CHECK(difference <= 1e-10);
  }
}
