#include "liggghts_run.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <sstream>

using namespace engines;

namespace {

constexpr double tcol = 4e-4, dt = tcol / 50, radius = 1.5e-3, gravity = 9.81;
constexpr int side = 10, steps = 30000, every = 1000;

struct Energy {
  double kinetic, potential, stored, dissipated;  // [J]
  double height;                                  // of the centre of mass [m]
  double total() const { return kinetic + potential + stored + dissipated; }
};

// A loose lattice, disturbed so that it does not fall as one, over the floor of a box.
std::vector<Grain> loose_lattice(double spacing) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-1e-4, 1e-4);
  std::vector<Grain> grains;
  for (int i = 0; i < side * side * side; ++i)
    grains.push_back({.radius = radius,
                      .position = {(i % side + 0.5) * spacing + shift(random),
                                   (i / side % side + 0.5) * spacing + shift(random),
                                   (i / (side * side) + 0.5) * spacing}});
  return grains;
}

// Frictionless, so that normal contacts are the only place where energy is held or lost.
std::vector<Energy> pour(int ranks) {
  constexpr double spacing = 3.4e-3, width = side * spacing;
  const Box box{{0, 0, 0}, {width, width, 0.06}};
  const auto grains = loose_lattice(spacing);
  const Workplace place("pouring_" + std::to_string(ranks));
  std::string walls;
  const char* planes[] = {"zplane 0", "xplane 0", "yplane 0", "xplane 0.034", "yplane 0.034"};
  for (int i = 0; i < 5; ++i)
    walls += "fix wall" + std::to_string(i) + " all wall/gran model fractional primitive type 1 " + planes[i] +
             " trackEnergy on\n";
  const std::string deck =
      preamble(box, ranks == 2 ? "2 1 1" : "1 1 1") + place.create(grains, box) +
      "neighbor 0.0006 bin\nneigh_modify delay 0\n" + pair_property("collisionTime", tcol) +
      pair_property("coefficientRestitution", 0.5) +
      "pair_style gran model fractional trackEnergy on\npair_coeff * *\n" + walls +
      "fix weight all gravity 9.81 vector 0 0 -1\nfix move all nve/sphere\ntimestep " + number(dt) +
      "\ncompute kinetic all ke\nvariable mz atom mass*z\ncompute mz all reduce sum v_mz\n"
      "compute stored all reduce sum f_fractionalStored\ncompute lost all reduce sum f_fractionalDissipated\n"
      "thermo_style custom step c_kinetic c_mz c_stored c_lost\nthermo_modify norm no format float %.15g\nthermo " +
      std::to_string(every) + "\nrun " + std::to_string(steps) + "\n";
  REQUIRE(place.run(deck, ranks) == 0);

  std::istringstream lines(place.output());
  std::vector<Energy> energies;
  const double mass = grains.front().mass() * static_cast<double>(grains.size());
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    double step = 0, mz = 0;
    Energy e{};
    if (words >> step >> e.kinetic >> mz >> e.stored >> e.dissipated && step == every * double(energies.size())) {
      e.potential = gravity * mz;
      e.height = mz / mass;
      energies.push_back(e);
    }
  }
  REQUIRE(energies.size() == steps / every + 1);
  return energies;
}

}  // namespace

TEST_CASE("a poured box of 1000 grains settles and keeps its energy balance, on two ranks as on one") {
  std::vector<Energy> last;
  for (int ranks : {1, 2}) {
    const auto energies = pour(ranks);
    const Energy &first = energies.front(), &end = energies.back();
    const double fallen = first.potential - end.potential;
    double off = 0, fastest = 0;
    for (const Energy& e : energies) {
      off = std::max(off, std::fabs(e.total() - first.total()) / fallen);
      fastest = std::max(fastest, e.kinetic);
    }
    std::printf("pouring on %d rank(s): centre of mass %.5f mm, kinetic energy %.1e of its peak, balance off by %.1e of "
                "what was lost\n", ranks, 1e3 * end.height, end.kinetic / fastest, off);
    CHECK(end.kinetic <= 1e-4 * fastest);
    CHECK(off <= 1e-2);
    CHECK(end.dissipated == Approx(fallen).epsilon(0.05));
    last.push_back(end);
  }
  CHECK(last[1].height == Approx(last[0].height).epsilon(5e-3));
  CHECK(last[1].dissipated == Approx(last[0].dissipated).epsilon(5e-3));
}
