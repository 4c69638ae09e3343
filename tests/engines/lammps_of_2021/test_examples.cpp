#include "../runs/deck_run.hpp"
#include "../runs/examples.hpp"

#include <catch2/catch.hpp>

using namespace engines;

namespace {
const std::string folder = "examples/lammps/debian12/";
}

TEST_CASE("the examples run and print what they promise") {
  CHECK(number_after(output_of(folder + "two_grains.lammps"), "restitution ") == Approx(0.5).epsilon(1e-3));
  CHECK(number_after(output_of(folder + "five_spheres.lammps"), "vz of sphere 1: ") == Approx(-4.3911).epsilon(1e-4));
  check_box_of_grains(output_of(folder + "box_of_grains.lammps"));
}

TEST_CASE("decks for the LAMMPS of Debian 13 are said to be") {
  for (const char* name : {"two_grains", "box_of_grains", "rotating_drum"}) {
    INFO(name);
    const std::string said = output_of(std::string("examples/lammps/debian13/") + name + ".lammps", 1);
    CHECK(said.find("is for the LAMMPS of Debian 13 (4 Feb 2025)") != std::string::npos);
    CHECK(said.find("see examples/lammps/debian12") != std::string::npos);
  }
  // By each word that this version does not know, wherever it stands.
  const Workplace place("words_of_2025");
  CHECK(place.run("units si\ncompute energy all fractional/energy\n") != 0);
  CHECK(place.output().find("lammps-ricochet: fractional/energy: is for the LAMMPS of Debian 13") != std::string::npos);
}
