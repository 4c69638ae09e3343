#include "../runs/examples.hpp"

#include <catch2/catch.hpp>

using namespace engines;

TEST_CASE("the examples run and print what they promise") {
  const std::string two = output_of("examples/lammps/debian13/two_grains.lammps");
  CHECK(number_after(two, "restitution ") == Approx(0.5).epsilon(1e-3));
  // The points of contact slip at 0.15 m/s: a seventh where they end at rest, twice that where the tangential spring
  // gives all of it back, and a little of the normal velocity, as the pair turns meanwhile.
  const double aside = number_after(two, "aside "), at_rest = 0.15 / 7;
  CHECK(aside > at_rest);
  CHECK(aside < 2.04 * at_rest);
  check_box_of_grains(output_of("examples/lammps/debian13/box_of_grains.lammps"));
  check_rotating_drum("examples/lammps/debian13/rotating_drum.lammps", 1740);
}

TEST_CASE("decks for the LAMMPS of Debian 12 are said to be") {
  for (const char* name : {"two_grains", "box_of_grains", "five_spheres"}) {
    INFO(name);
    const std::string said = output_of(std::string("examples/lammps/debian12/") + name + ".lammps", 1);
    CHECK(said.find("is for the LAMMPS of Debian 12 (29 Sep 2021)") != std::string::npos);
    CHECK(said.find("see examples/lammps/debian13") != std::string::npos);
  }
}
