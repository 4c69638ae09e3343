#include "../lammps/meeting.hpp"

#include <catch2/catch.hpp>

using namespace engines;
using namespace engines::meeting;

namespace {

std::string with_law(const std::string& law) { return "pair_style fractional\npair_coeff * * " + law + "\n"; }

/// `setting` is put in the place of the preamble's own.
std::string complaint(const std::string& name, const std::string& styles, double step = dt,
                      const std::string& setting = "") {
  const Workplace place(name);
  std::string deck = with(place, styles, step);
  if (!setting.empty()) {
    const auto at = deck.find(setting.substr(0, setting.find(' ')));
    deck.replace(at, deck.find('\n', at) + 1 - at, setting);
  }
  CHECK(place.run(deck + run(10)) == 1);
  return place.output();
}

}  // namespace

TEST_CASE("misuse of the styles is refused with the name and the value") {
  CHECK(contains(complaint("few", with_law("1 2")), "must be I J K C ALPHA or I J target T_COL E_N"));
  CHECK(contains(complaint("en", with_law("target 1e-4 1.2")), "e_n = 1.2: must be 0 < en <= 1"));
  CHECK(contains(complaint("tcol", with_law("target -1 0.5")), "t_col = -1: must be finite and > 0"));
  CHECK(contains(complaint("alpha", with_law("1 1 1")), "alpha = 1: must be 0 <= alpha < 1"));
  CHECK(contains(complaint("word", "pair_style fractional friction 0.5\n"), "friction 0.5: must be memory TIME or"));
  CHECK(contains(complaint("memory", "pair_style fractional memory 0\n"), "memory = 0: must be > 0"));
  const std::string good = with_law(target(tcol, en)), fix = "fix wall all wall/fractional ";
  CHECK(contains(complaint("axis", good + fix + "plane 0 NULL " + target(tcol, en) + "\n"),
                 "plane: must be xplane, yplane or zplane"));
  CHECK(contains(complaint("wall", good + fix + "xplane 0 NULL 1 2\n"), "fix wall/fractional: must be xplane"));
  const std::string law = " " + target(tcol, en) + "\n";
  CHECK(contains(complaint("no_place", good + fix + "xplane NULL NULL" + law),
                 "NULL NULL: at least one of LO and HI must be a place"));
  CHECK(contains(complaint("crossed", good + fix + "xplane 0.01 -0.01" + law), "0.01 -0.01: must be LO < HI"));
  CHECK(contains(complaint("no_room", good + fix + "xplane 0 0" + law), "0 0: must be LO < HI"));
  CHECK(contains(complaint("periodic", good + fix + "yplane -0.01 NULL" + law, dt, "boundary f p f\n"),
                 "yplane: the box must not be periodic in y"));
  CHECK(contains(complaint("newton", good, dt, "newton on\n"), "newton = on: must be newton off"));
  CHECK(contains(complaint("units", good, dt, "units real\n"), "units = real: must be si, cgs, lj, micro or nano"));
  CHECK(contains(complaint("velocities", "comm_modify vel no\n" + good), "needs comm_modify vel yes"));
  CHECK(contains(complaint("rigid", good + "fix clump all rigid single\n"), "rigid bodies are not known"));
}

TEST_CASE("the style stands alone") {
  const std::string law = " fractional " + target(tcol, en) + "\n";
  CHECK(contains(complaint("hybrid", "pair_style hybrid fractional\npair_coeff * *" + law),
                 "pair_style hybrid is not known to it: must be the only pair style"));
}

TEST_CASE("laws of two types are not mixed") {
  Box two = box;
  two.types = 2;
  const Workplace place("mixed");
  CHECK(place.run(preamble(two) + place.create(grains, two) + neighbours() + "pair_style fractional\npair_coeff 1 1 " +
                  target(tcol, en) + "\npair_coeff 2 2 " + target(tcol, en) + "\n" + move(dt) + run(1)) == 1);
  CHECK(contains(place.output(), "pair_coeff 1 2 is missing"));
}

TEST_CASE("what the style has not is said at its start") {
  const Workplace place("start");
  REQUIRE(place.run(with(place, with_law(target(tcol, en))) + run(1)) == 0);
  CHECK(contains(place.output(), "pair fractional: frictionless normal contacts"));
}

TEST_CASE("a step too coarse for the collisions is warned of, and refused") {
  const auto output = [](const std::string& name, double steps) {
    return said(name, with_law(target(tcol, en)), run(10), 0, tcol / steps);
  };
  CHECK_FALSE(contains(output("steps_20", 20.01), "WARNING: pair fractional"));
  CHECK(contains(output("steps_19", 19), "WARNING: pair fractional: timestep = 5.26316e-06 leaves 19 steps"));
  CHECK(contains(complaint("steps_3", with_law(target(tcol, en)), tcol / 3.99), "must be at most 1/4"));
}

TEST_CASE("before a run the lightest pairs and the lightest grain of a wall's group are looked at") {
  // By k, c and alpha two grains of 3 mm take 1e-4 s, one of them on a wall half as long again.
  const std::string law = with_law(parameters(5225, 0.297, 0.3197));
  const auto of_run = [](const std::string& name, const std::string& styles, double step) {
    const Workplace place(name);
    const bool ran = place.run(with(place, styles, step) + run(0)) == 0;
    return std::pair(ran, place.output());
  };
  const auto coarse = of_run("lightest_pair", law, tcol / 3.9);
  CHECK_FALSE(coarse.first);
  CHECK(contains(coarse.second, "pair fractional: timestep = 2.5641e-05: must be at most 1/4"));
  CHECK(of_run("light_enough", law, tcol / 4.1).first);
  // The wall's group has a grain that is twenty-seven times as heavy.
  const std::string heavy = "set atom 2 diameter 0.009 density 1000\ngroup heavy id 2\n" + law;
  const auto wall = [](const std::string& group) {
    return "fix wall " + group + " wall/fractional xplane -0.01 NULL " + parameters(5225, 0.297, 0.3197) + "\n";
  };
  const double step = 1.5e-4 / 15;  // warned of by the light grain alone, on a wall as in a pair
  const std::string warned = "WARNING: fix wall/fractional: timestep";
  CHECK(contains(of_run("wall_of_all", heavy + wall("all"), step).second, warned));
  CHECK_FALSE(contains(of_run("wall_of_heavy", heavy + wall("heavy"), step).second, warned));
}

TEST_CASE("a later run with another time step keeps the kernel and says so") {
  const std::string words = "the memory kernel stays the one chosen for timestep = 2e-06";
  for (double later : {dt, dt / 2}) {
    const Workplace place("later");
    REQUIRE(place.run(with(place, with_law(target(tcol, en))) + run(30) + "timestep " + number(later) + "\n" +
                      dump("dump", 400) + run(400)) == 0);
    CHECK(contains(place.output(), words) == (later != dt));
    const auto v = place.frames("dump").back().velocity;
    CHECK((v[1][0] - v[0][0]) / speed == Approx(en).epsilon(1e-3));
  }
}

TEST_CASE("after `clear` the styles are there again") {
  const Workplace place("clear");
  const std::string deck = with(place, with_law(target(tcol, en)) + planes("xplane", "NULL", "0.01", target(tcol, en)));
  REQUIRE(place.run(deck + run(1) + "clear\n" + deck + run(1)) == 0);
}
