#include "../lammps/deck.hpp"
#include "../runs/scenes.hpp"

#include <catch2/catch.hpp>

using namespace engines;
using namespace engines::crossing;

namespace {

constexpr int steps = 80;

const Box long_box{{-0.02, -0.01, -0.01}, {0.2, 0.01, 0.01}};

/// Two grains that collide on the last of four ranks. Five others fly past them from the left, so that `fix balance`,
/// at step 30, in the middle of the contact, gives one of the two to the first rank and one to the second. It carries
/// grains over several ranks itself, before the pair style's fix has its turn.
std::vector<Frame> run_balanced(int ranks) {
  auto grains = crossing::pair(0, 0);
  for (Grain& grain : grains) grain.position[0] += 0.003;
  grains.push_back({.position = {-0.018, 0, 0}});
  for (int i = 0; i < 5; ++i)
    grains.push_back({.position = {-0.0005 - 0.0035 * i, 0.005, 0}, .velocity = {1000, 0, 0}});
  const Workplace place("balance_" + std::to_string(ranks));
  REQUIRE(place.run(preamble(long_box, ranks == 4 ? "4 1 1" : "1 1 1") + place.create(grains, long_box) + neighbours() +
                        "fix cut all balance 30 1.05 shift x 40 1.0\n" + one_law(target(tcol, en)) + move(dt) +
                        dump("dump") + run(steps),
                    ranks) == 0);
  return place.frames("dump");
}

}  // namespace

TEST_CASE("a contact goes on where `fix balance` moves one of its grains to another rank") {
  const auto one = run_balanced(1), four = run_balanced(4);
  CHECK((one.back().velocity[1][0] - one.back().velocity[0][0]) / speed == Approx(en).epsilon(1e-3));
  // To move the cut LAMMPS turns positions into fractions of the box and back.
  CHECK(largest_difference(one, four) <= 1e-10);
}
