#include "../runs/scenes.hpp"
#include "liggghts_run.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

using namespace engines;

namespace {

constexpr double tcol = 4e-4, dt = tcol / 50, gravity = 9.81;
constexpr int every = 1000;

struct Energy {
  double kinetic, potential, stored, dissipated;  // [J]
  double height;                                  // of the centre of mass [m]
  double total() const { return kinetic + potential + stored + dissipated; }
};

struct Pouring {
  std::string name;
  std::string models;  // beside the normal one
  int steps;
};

// How the box is cut: into two along x and along y the grains are other neighbours in another order.
struct Cut {
  int ranks;
  const char *processors, *name;
};
constexpr Cut cuts[] = {{1, "1 1 1", "one rank"}, {2, "2 1 1", "two ranks along x"}, {2, "1 2 1", "two along y"}};

std::vector<Energy> pour(const Pouring& pouring, const Cut& cut) {
  const Box box{{0, 0, 0}, {pouring::width, pouring::width, 0.06}};
  const auto grains = pouring::loose_lattice();
  const Workplace place("pouring_" + pouring.name + "_" + cut.name);
  std::string walls;
  const char* planes[] = {"zplane 0", "xplane 0", "yplane 0", "xplane 0.034", "yplane 0.034"};
  for (int i = 0; i < 5; ++i)
    walls += "fix wall" + std::to_string(i) + " all wall/gran model fractional " + pouring.models +
             " primitive type 1 " + planes[i] + " trackEnergy on\n";
  const std::string deck =
      preamble(box, cut.processors) + place.create(grains, box) + "neighbor 0.0006 bin\nneigh_modify delay 0\n" +
      pair_property("collisionTime", tcol) + pair_property("coefficientRestitution", 0.5) +
      pair_property("coefficientFriction", 0.5) + pair_property("coefficientRollingFriction", 0.1) +
      "pair_style gran model fractional " + pouring.models + " trackEnergy on\npair_coeff * *\n" + walls +
      "fix weight all gravity 9.81 vector 0 0 -1\nfix move all nve/sphere\ntimestep " + number(dt) +
      "\ncompute kinetic all ke\nvariable mz atom mass*z\ncompute mz all reduce sum v_mz\n"
      "compute stored all reduce sum f_fractionalStored\ncompute lost all reduce sum f_fractionalDissipated\n"
      "thermo_style custom step c_kinetic c_mz c_stored c_lost\nthermo_modify norm no format float %.15g\nthermo " +
      std::to_string(every) + "\nrun " + std::to_string(pouring.steps) + "\n";
  REQUIRE(place.run(deck, cut.ranks) == 0);

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
  REQUIRE(energies.size() == static_cast<std::size_t>(pouring.steps / every + 1));
  return energies;
}

}  // namespace

TEST_CASE("1000 poured grains keep their energy balance, on two ranks as on one") {
  // Frictionless, so that normal contacts are the only place where energy is held or lost.
  const Pouring frictionless{"frictionless", "", 10000};
  std::vector<Energy> last;
  for (const Cut& cut : cuts) {
    const auto energies = pour(frictionless, cut);
    const Energy& first = energies.front();
    const double available = first.total() - energies.back().potential;
    double off = 0;
    for (const Energy& e : energies) off = std::max(off, std::fabs(e.total() - first.total()) / available);
    last.push_back(energies.back());
    std::printf("pouring without friction on %s: lost %.5g J of %.5g J, balance off by %.1e\n", cut.name,
                last.back().dissipated, available, off);
    CHECK(off <= 2e-3);
    CHECK(last.back().dissipated >= 0.9 * available);
  }
  for (const Energy& two : {last[1], last[2]}) {
    CHECK(two.height == Approx(last[0].height).epsilon(5e-3));
    CHECK(two.dissipated == Approx(last[0].dissipated).epsilon(5e-3));
  }
  // Sums in another order: grains in a box part from one another by rounding, and not a bit of it would be suspicious.
  CHECK(last[1].dissipated != last[0].dissipated);
  CHECK(last[2].dissipated != last[0].dissipated);
  CHECK(last[2].dissipated != last[1].dissipated);
}

TEST_CASE("1000 poured grains with friction and rolling resistance settle, on two ranks as on one") {
  const Pouring frictional{"frictional", "tangential history rolling_friction epsd2", 20000};
  std::vector<Energy> last;
  for (const Cut& cut : cuts) {
    const auto energies = pour(frictional, cut);
    double fastest = 0;
    for (const Energy& e : energies) fastest = std::max(fastest, e.kinetic);
    last.push_back(energies.back());
    std::printf("pouring with friction on %s: centre of mass at %.4f mm, kinetic energy %.1e of its peak\n", cut.name,
                1e3 * last.back().height, last.back().kinetic / fastest);
    CHECK(last.back().kinetic <= 1e-4 * fastest);
  }
  for (const Energy& two : {last[1], last[2]}) CHECK(two.height == Approx(last[0].height).epsilon(5e-3));
}
