#include "../runs/scenes.hpp"
#include "deck.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

using namespace engines;

namespace {

constexpr double tcol = 4e-4, dt = tcol / 50;
constexpr int steps = 10000, every = 1000;

struct Energy {
  double kinetic, potential, stored, lost;  // [J]
  double total() const { return kinetic + potential + stored + lost; }
};

// A thousand grains of two types, denser and more elastic the one, fall into a box.
std::vector<Grain> two_types() {
  auto grains = pouring::loose_lattice();
  for (std::size_t i = 0; i < grains.size(); i += 2) grains[i].type = 2, grains[i].density = 2500;
  return grains;
}

std::string laws() {
  std::string text = pair_style(tallied());
  for (const auto& [types, en] : {std::pair{"1 1", 0.5}, {"2 2", 0.8}, {"1 2", 0.6}})
    text += pair_coeff(types, target(tcol, en), tallied());
  return text;
}

std::string box_walls() {
  const std::string law = target(tcol, 0.5), width = number(pouring::width);
  return planes("xplane", "0", width, law, tallied()) + planes("yplane", "0", width, law, tallied()) +
         planes("zplane", "0", "NULL", law, tallied());
}

std::string sums() {
  return "variable mgz atom mass*9.81*z\ncompute heights all reduce sum v_mgz\ncompute kinetic all ke\n" + energies() +
         "thermo_style custom step c_kinetic c_heights v_stored v_lost\n"
         "thermo_modify norm no format float %.15g\nthermo " +
         std::to_string(every) + "\n";
}

std::vector<Energy> energies_of(const std::string& output) {
  std::istringstream lines(output);
  std::vector<Energy> energies;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    double step = 0;
    Energy e{};
    if (words >> step >> e.kinetic >> e.potential >> e.stored >> e.lost && step == every * double(energies.size()))
      energies.push_back(e);
  }
  return energies;
}

std::vector<Energy> pour(int ranks, const std::string& processors) {
  const Box box{{0, 0, 0}, {pouring::width, pouring::width, 0.06}, "f f f", 2};
  const Workplace place("pouring_" + std::to_string(ranks) + processors.substr(0, 1));
  REQUIRE(place.run(preamble(box, processors) + place.create(two_types(), box) + neighbours("0.0006") + laws() +
                        box_walls() + "fix weight all gravity 9.81 vector 0 0 -1\n" + move(dt) + sums() + run(steps),
                    ranks) == 0);
  auto energies = energies_of(place.output());
  REQUIRE(energies.size() == steps / every + 1);
  return energies;
}

}  // namespace

TEST_CASE("1000 poured grains of two types keep their energy balance, on two ranks as on one") {
  std::vector<double> lost;
  for (const auto& [ranks, processors] : {std::pair{1, "1 1 1"}, {2, "2 1 1"}}) {
    const auto energies = pour(ranks, processors);
    const Energy &first = energies.front(), &last = energies.back();
    const double available = first.total() - last.potential;
    double off = 0;
    for (const Energy& e : energies) off = std::max(off, std::fabs(e.total() - first.total()) / available);
    std::printf("two types poured on %d rank(s): lost %.5g J of %.5g J, balance off by %.1e\n", ranks, last.lost,
                available, off);
    CHECK(off <= 2e-3);
    CHECK(last.lost >= 0.9 * available);
    lost.push_back(last.lost);
  }
  CHECK(lost[1] == Approx(lost[0]).epsilon(5e-3));
  // Sums in another order: grains in a box part from one another by rounding.
  CHECK(lost[1] != lost[0]);
}
