#include "../lammps/examples.hpp"

#include <catch2/catch.hpp>

using namespace engines;

TEST_CASE("the examples run and print what they promise") {
  CHECK(number_after(output_of("debian12/two_grains.lammps"), "restitution ") == Approx(0.5).epsilon(1e-3));
  CHECK(number_after(output_of("debian12/five_spheres.lammps"), "vz of sphere 1: ") == Approx(-4.3911).epsilon(1e-4));
  check_box_of_grains(output_of("debian12/box_of_grains.lammps"));
}
