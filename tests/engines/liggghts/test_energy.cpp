#include "liggghts_run.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>
#include <vector>

using namespace engines;

namespace {

constexpr double tcol = 1e-4, en = 0.5, speed = 0.5;
constexpr int steps = 50;  // a collision

struct Energy {
  double kinetic = 0, stored = 0, lost = 0;  // [J]
  double total() const { return kinetic + stored + lost; }
};

/// At every step of one collision with the plane x = 0, or of two grains.
std::vector<Energy> followed(const Model& model, bool wall) {
  constexpr double dt = tcol / steps, gap = 5.3 * dt * speed;
  const Box box{{wall ? 0 : -0.01, -0.01, -0.01}, {0.02, 0.01, 0.01}};
  Grain first;
  first.position = {first.radius + (wall ? gap : gap / 2), 0, 0};
  first.velocity = {wall ? -speed : -speed / 2, 0, 0};
  std::vector<Grain> grains{first};
  if (!wall) grains.push_back({.position = {-first.position[0], 0, 0}, .velocity = {speed / 2, 0, 0}});
  const Workplace place("energy_" + model.name + (wall ? "_wall" : "_pair"));
  const std::string kind = " model " + model.name + " ";
  const std::string deck =
      preamble(box) + place.create(grains, box) + "neighbor 0.0005 bin\n" + pair_property("collisionTime", tcol) +
      pair_property("coefficientRestitution", en) + model.properties + "pair_style gran" + kind +
      "trackEnergy on\npair_coeff * *\n" +
      (wall ? "fix wall all wall/gran" + kind + "primitive type 1 xplane 0 trackEnergy on\n" : "") +
      "fix move all nve/sphere\ntimestep " + number(dt) +
      "\ncompute kinetic all ke\ncompute stored all reduce sum f_fractionalStored\n"
      "compute lost all reduce sum f_fractionalDissipated\nthermo_style custom step c_kinetic c_stored c_lost\n"
      "thermo_modify norm no format float %.15g\nthermo 1\nrun " +
      std::to_string(steps + 20) + "\n";
  REQUIRE(place.run(deck) == 0);
  std::istringstream lines(place.output());
  std::vector<Energy> all;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    double step = 0;
    Energy e;
    if (words >> step >> e.kinetic >> e.stored >> e.lost && step == static_cast<double>(all.size())) all.push_back(e);
  }
  REQUIRE(all.size() == steps + 21);
  return all;
}

}  // namespace

TEST_CASE("what a collision takes of the energy is told, all of it at a wall and half at either grain") {
  // The scheme is of order 2: what it leaves open is (π/steps)² of the energy or less.
  const double bound = std::pow(std::numbers::pi / steps, 2);
  for (const Model& model : our_models())
    for (const bool wall : {true, false}) {
      CAPTURE(model.name, wall);
      const auto energies = followed(model, wall);
      const double mass_eff = wall ? Grain{}.mass() : Grain{}.mass() / 2, before = 0.5 * mass_eff * speed * speed;
      CHECK(energies.front().total() == Approx(before).epsilon(1e-12));
      CHECK(energies.back().stored == 0);
      CHECK(energies.back().lost == Approx((1 - en * en) * before).epsilon(bound));
      double off = 0, stored = 0;
      for (const Energy& e : energies) {
        off = std::max(off, std::abs(e.total() / before - 1));
        stored = std::max(stored, e.stored);
      }
      CHECK(off <= bound);
      CHECK(stored > 0.2 * before);
    }
}
