#include "deck.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>

using namespace engines;

namespace {

constexpr double tcol = 1e-4, en = 0.8, dt = tcol / 50, speed = 0.5, radius = 1.5e-3, room = 2e-4;
constexpr int bounces = 5;

// A grain that flies to and fro between two obstacles a free path `room` apart. Without gravity its speed after n
// bounces is en^n times the first. The neighbour list's skin is wider than the whole path: it is never rebuilt, so that
// nothing that the grains remember is dropped.
std::vector<Frame> run_bounces(bool between_grains, int ranks) {
  // The ranks share the path: they meet at x = 0.0016, where the grain's centre passes at each flight.
  const Box box{{-0.0048, -0.01, -0.01}, {0.008, 0.01, 0.01}};
  const Workplace place(std::string("bounces_") + (between_grains ? "grains_" : "planes_") + std::to_string(ranks));
  std::vector<Grain> grains{{.position = {radius + room, 1e-3, 0}, .velocity = {-speed, 0, 0}}};
  if (between_grains) {
    grains.push_back({.position = {-radius, 1e-3, 0}});
    grains.push_back({.position = {3 * radius + room, 1e-3, 0}});
  }
  const double duration = room / speed * (1 - std::pow(1 / en, bounces)) / (1 - 1 / en) + (bounces + 0.7) * tcol;
  const std::string obstacles = between_grains ? "group fixed id 2 3\nfix hold fixed freeze\n"
                                               : planes("xplane", "0", "0.0032", target(tcol, en));
  REQUIRE(place.run(preamble(box, ranks == 2 ? "2 1 1" : "1 1 1") + place.create(grains, box) + neighbours("0.001") +
                        one_law(target(tcol, en)) + obstacles + move(dt) + dump("dump") +
                        run(static_cast<int>(duration / dt)),
                    ranks) == 0);
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
  for (bool between_grains : {true, false}) {
    const auto one = run_bounces(between_grains, 1), two = run_bounces(between_grains, 2);
    REQUIRE(bounces_in(one) == bounces);
    const double restitution = std::pow(std::fabs(one.back().velocity[0][0]) / speed, 1. / bounces);
    const double difference = largest_difference(one, two);
    std::printf("between %s: en = %.6f a bounce (%g asked), 2 ranks differ from 1 by %.1e\n",
                between_grains ? "grains" : "planes", restitution, en, difference);
    CHECK(restitution == Approx(en).epsilon(1e-3));
    CHECK(difference == 0);
  }
}
