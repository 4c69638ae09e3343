// What LAMMPS asks of a pair style beside its force: who may meet, against whom, and what is told of a contact.

#include "../lammps/meeting.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <sstream>

using namespace engines;
using namespace engines::meeting;

namespace {

double distance(const Vector& a, const Vector& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

}  // namespace

TEST_CASE("a grain that `fix freeze` holds is met as a wall, whichever of the two LAMMPS names first") {
  for (const int held : {1, 2}) {
    const Workplace place("frozen_" + std::to_string(held));
    REQUIRE(place.run(with(place, one_law(target(tcol, en)) + "group held id " + std::to_string(held) +
                                      "\nvelocity held set 0 0 0\nfix hold held freeze\n") +
                      dump("dump") + run(200)) == 0);
    const std::size_t free = held == 1 ? 1 : 0;
    // As long as the law says for a pair of the free grain's mass; of that of two free ones it would be 75 steps.
    int touching = 0;
    for (const Frame& frame : place.frames("dump")) touching += frame.force[free][0] != 0;
    CHECK(touching >= tcol / dt - 2);
    CHECK(touching <= tcol / dt + 2);
    CHECK(std::abs(place.frames("dump").back().velocity[free][0]) == Approx(en * speed / 2).epsilon(1e-3));
  }
}

TEST_CASE("grains that are poured in later meet each other") {
  const Workplace place("poured");
  const Box shaft{{0, 0, 0}, {0.008, 0.008, 0.05}};
  const std::string law = target(4 * tcol, en), map = "atom_modify map array\n";
  std::string start = preamble(shaft);
  start.erase(start.find(map), map.size());  // with it LAMMPS's own fix pour ends in SIGSEGV where no grain is yet
  REQUIRE(
      place.run(start + "region box block 0 0.008 0 0.008 0 0.05\ncreate_box 1 box\n" + neighbours() + one_law(law) +
                planes("xplane", "0", "0.008", law) + planes("yplane", "0", "0.008", law) +
                planes("zplane", "0", "NULL", law) +
                "fix weight all gravity 9.81 vector 0 0 -1\nregion above block 0.002 0.006 0.002 0.006 0.004 0.045\n"
                "fix pour all pour 12 1 4711 vol 0.3 1000 diam one 0.003 dens 1000 1000 region above\n" +
                move(8e-6) + dump("dump", 20000) + run(20000)) == 0);
  const Frame last = place.frames("dump").back();
  REQUIRE(last.position.size() == 12);
  for (std::size_t i = 0; i < last.position.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) CHECK(distance(last.position[i], last.position[j]) > 0.95 * 0.003);
}

TEST_CASE("compute pair/local and the pressure know the pair's force") {
  const Workplace place("told");
  REQUIRE(place.run(with(place, one_law(target(tcol, en))) +
                    "compute each all pair/local force\ncompute sum all reduce sum c_each\n"
                    "compute stress all pressure NULL pair\n"
                    "thermo_style custom step c_sum c_stress[1] c_stress[2]\nthermo_modify norm no format float %.15g\n"
                    "thermo 1\n" +
                    dump("dump") + run(110)) == 0);
  const auto frames = place.frames("dump");
  std::istringstream lines(place.output());
  int seen = 0;
  for (std::string line; std::getline(lines, line);) {
    double step = 0, force = 0, along = 0, across = 0;
    if (!(std::istringstream(line) >> step >> force >> along >> across) || step == 0) continue;
    const Frame& frame = frames.at(static_cast<std::size_t>(step));
    const double pressing = frame.force[1][0], volume = 0.02 * 0.02 * 0.02;
    if (pressing == 0) continue;
    CHECK(force == Approx(pressing).epsilon(1e-12));
    CHECK(along * volume == Approx(pressing * (frame.position[1][0] - frame.position[0][0])).epsilon(1e-12));
    CHECK(across == 0);
    ++seen;
  }
  CHECK(seen > 20);
}
