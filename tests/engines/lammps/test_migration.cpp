#include "../runs/scenes.hpp"
#include "deck.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>
#include <string>

using namespace engines;
using namespace engines::crossing;

namespace {

std::string on_ranks(int ranks) { return preamble(box, ranks == 2 ? "2 1 1" : "1 1 1"); }

// The list is made anew at every step: each step may move a grain to the other rank.
std::string physics() {
  return neighbours("0.0005", "every 1 delay 0 check no") + one_law(target(tcol, en)) + move(dt);
}

std::vector<Frame> run_pair(const std::string& name, const std::vector<Grain>& grains, int ranks) {
  const Workplace place(name + "_" + std::to_string(ranks));
  REQUIRE(place.run(on_ranks(ranks) + place.create(grains, box) + physics() + dump("dump") + run(steps), ranks) == 0);
  return place.frames("dump");
}

}  // namespace

TEST_CASE("a pair that crosses from rank to rank in contact moves as on one rank") {
  for (int axis : {0, 1})
    for (double drift : {30., -30.}) {
      const auto grains = crossing::pair(axis, drift);
      const std::string name =
          std::string("crossing_") + (axis == 0 ? "along" : "across") + (drift > 0 ? "_right" : "_left");
      const auto one = run_pair(name, grains, 1), two = run_pair(name, grains, 2);
      const int crossed = crossings_in_contact(two, 0) + crossings_in_contact(two, 1);
      const double difference = largest_difference(one, two);
      const Vector va = two.back().velocity[0], vb = two.back().velocity[1];
      const double restitution = (vb[axis] - va[axis]) / speed;
      std::printf("%s: %d crossings in contact, en = %.6f, 2 ranks differ from 1 by %.1e\n", name.c_str(), crossed,
                  restitution, difference);
      CHECK(crossed >= (axis == 0 ? 1 : 2));
      CHECK(restitution == Approx(en).epsilon(1e-3));
      CHECK(difference == 0);
    }
}

namespace {

// A pair that crosses between ranks, a triple of two types and a grain on a plane, all in contact at the cut.
std::vector<Grain> grains_in_contact() {
  std::vector<Grain> grains = crossing::pair(1, 30);
  const double start = radius + 10 * dt * speed;
  grains.push_back({.position = {-0.01, 0.005, -0.01 + start}, .velocity = {0, 0, -speed}});
  for (int i = 0; i < 3; ++i)
    grains.push_back({.type = 1 + i % 2,
                      .position = {0.01, -0.005, (i - 1) * (2 * radius + 10 * dt * speed)},
                      .velocity = {0, 0, (1 - i) * (1 + 0.1 * i) * speed}});
  return grains;
}

const std::string plane = planes("zplane", "-0.01", "NULL", target(tcol, en));

/// The steps from the cut on, of a run on `before` ranks that goes on, from its restart file, on `after` ranks.
std::vector<Frame> run_with_cut(int before, int after, int cut, const std::string& restated) {
  Box two_types = box;
  two_types.types = 2;
  const Workplace place("restart_" + std::to_string(before) + "_" + std::to_string(after));
  REQUIRE(place.run(on_ranks(before) + place.create(grains_in_contact(), two_types) + physics() + plane + run(cut) +
                        "write_restart cut.restart\n",
                    before) == 0);
  REQUIRE(place.run(on_ranks(after) + "read_restart cut.restart\n" + restated + plane + dump("rest") + run(steps - cut),
                    after) == 0);
  return place.frames("rest");
}

std::vector<Frame> run_whole(int cut) {
  Box two_types = box;
  two_types.types = 2;
  const Workplace place("restart_whole");
  REQUIRE(place.run(on_ranks(1) + place.create(grains_in_contact(), two_types) + physics() + plane + dump("whole") +
                    run(steps)) == 0);
  auto frames = place.frames("whole");
  frames.erase(frames.begin(), frames.begin() + cut);
  return frames;
}

}  // namespace

TEST_CASE("a run restarted in the middle of contacts goes on as the whole one, on as many ranks or others") {
  const int cut = 10 + 20;  // 0.4 t_col into the contacts
  const auto whole = run_whole(cut);
  for (const Vector& f : whole.front().force) CHECK(std::hypot(f[0], f[1], f[2]) > 0);
  for (const auto& [before, after] : {std::pair{1, 1}, {1, 2}, {2, 1}, {2, 2}}) {
    const auto rest = run_with_cut(before, after, cut, physics());
    REQUIRE(rest.front().step == cut);
    const double difference = largest_difference(whole, rest);
    std::printf("restart %d to %d ranks: differs from the whole run by %.1e\n", before, after, difference);
    CHECK(difference == 0);
  }
}

TEST_CASE("a restart file brings the laws and their kernel along") {
  const auto rest = run_with_cut(
      1, 1, 30, neighbours("0.0005", "every 1 delay 0 check no") + after_restart(one_law(target(tcol, en))) + move(dt));
  CHECK(largest_difference(run_whole(30), rest) == 0);
}
