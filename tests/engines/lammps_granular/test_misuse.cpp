#include "../lammps/meeting.hpp"

#include <catch2/catch.hpp>

using namespace engines;
using namespace engines::meeting;

namespace {

std::string complaint(const std::string& name, const std::string& styles, double step = dt,
                      const std::string& last = run(100)) {
  return said(name, styles, last, 1, step);
}

std::string complaint_of(const std::string& name, const std::string& law) { return complaint(name, one_law(law)); }

const std::string law = target(tcol, en), good = one_law(law);

}  // namespace

TEST_CASE("misuse of the sub-models is refused with the name and the value") {
  CHECK(contains(complaint_of("en", "fractional/target 1e-4 1.2"), "fractional/target: EN = 1.2: must be 0 < en <= 1"));
  CHECK(contains(complaint_of("tcol", "fractional/target -2 0.5"), "TCOL = -2: must be finite and > 0"));
  CHECK(contains(complaint_of("alpha", "fractional 1 1 1"), "alpha = 1: must be 0 <= alpha < 1"));
  CHECK(contains(complaint_of("reach", "fractional/kelvin_voigt/target 1e-4 0.2 NULL"),
                 "EN = 0.2: must be one that the law reaches with this ALPHA"));
  CHECK(contains(complaint_of("speed", "fractional/hertz 1e7 1e4 0.5 0"), "VELOCITY = 0: must be finite and > 0"));
  CHECK(contains(complaint_of("few", "fractional 1 1"), "floating point parameter instead of 'damping'"));
  CHECK(contains(complaint("memory", one_law(target(tcol, en), "damping fractional/memory 0")),
                 "damping fractional/memory: TIME = 0: must be finite and > 0"));
}

TEST_CASE("the normal and the damping model ask for each other") {
  const std::string tail = " tangential linear_nohistory 0 0\n", start = pair_style() + "pair_coeff * * ";
  CHECK(contains(complaint("no_damping", start + target(tcol, en) + tail),
                 "fractional/target takes damping fractional, or fractional/memory TIME, and finds viscoelastic"));
  CHECK(contains(complaint("hooke", start + "hooke 7000 0.3 damping fractional" + tail),
                 "damping fractional goes with the granular models fractional alone, not with hooke"));
}

TEST_CASE("tangential models that take Young's modulus from the normal one are refused") {
  for (const char* mindlin : {"mindlin", "mindlin/force", "mindlin_rescale"})
    CHECK(contains(complaint("modulus", one_law(law, std::string("tangential ") + mindlin + " NULL 0 0.1")),
                   "Must either specify tangential stiffness or material properties"));
}

TEST_CASE("a step too coarse for the collisions is warned of, and refused") {
  const auto output = [](const std::string& name, double steps) { return said(name, good, run(60), 0, tcol / steps); };
  CHECK_FALSE(contains(output("steps_20", 20.01), "WARNING: granular model"));
  CHECK(contains(output("steps_19", 19),
                 "WARNING: granular model fractional/target: timestep = 5.26316e-06 leaves 19 steps"));
  CHECK(contains(complaint("steps_3", good, tcol / 3.99),
                 "timestep = 2.50627e-05: must be at most 1/4 of the shortest collision time, 0.0001"));
}

TEST_CASE("a later run with another time step keeps the kernel and says so") {
  const std::string words = "timestep = 1e-06: the memory kernel stays the one chosen for timestep = 2e-06";
  CHECK(contains(said("same_steps", good, run(70) + "reset_timestep 0\ntimestep 1e-6\n" + run(70)), words));
  const Workplace place("step");
  REQUIRE(place.run(with(place, good) + run(70) + "timestep 1e-6\n" + dump("dump", 160) + run(160)) == 0);
  CHECK(contains(place.output(), words));
  const auto v = place.frames("dump").back().velocity;
  CHECK((v[1][0] - v[0][0]) / speed == Approx(en).epsilon(2e-3));
}

TEST_CASE("after `clear` the sub-models and the compute are there again") {
  const Workplace place("clear");
  const std::string deck = with(place, good + energies());
  REQUIRE(place.run(deck + run(1) + "clear\n" + deck + run(1)) == 0);
}
