#include "../lammps/examples.hpp"

#include <catch2/catch.hpp>

using namespace engines;

TEST_CASE("the examples run and print what they promise") {
  const std::string two = output_of("debian13/two_grains.lammps");
  CHECK(number_after(two, "restitution ") == Approx(0.5).epsilon(1e-3));
  // The points of contact slip at 0.15 m/s: a seventh where they end at rest, twice that where the tangential spring
  // gives all of it back, and a little of the normal velocity, as the pair turns meanwhile.
  const double aside = number_after(two, "aside "), at_rest = 0.15 / 7;
  CHECK(aside > at_rest);
  CHECK(aside < 2.04 * at_rest);
  check_box_of_grains(output_of("debian13/box_of_grains.lammps"));
}
