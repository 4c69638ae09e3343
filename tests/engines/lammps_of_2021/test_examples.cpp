#include "../lammps/deck.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

using namespace engines;

namespace {

std::string output_of(const std::string& example) {
  std::stringstream deck;
  deck << std::ifstream(RICOCHET_SOURCE_DIR "/examples/lammps/debian12/" + example).rdbuf();
  const Workplace place("example_" + example);
  REQUIRE(place.run(deck.str()) == 0);
  return place.output();
}

double number_after(const std::string& text, const std::string& words) {
  const auto at = text.rfind(words);
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + words.size()));
}

}  // namespace

TEST_CASE("the examples run and print what they promise") {
  CHECK(number_after(output_of("two_grains.lammps"), "restitution ") == Approx(0.5).epsilon(1e-3));
  CHECK(number_after(output_of("five_spheres.lammps"), "vz of sphere 1: ") == Approx(-4.3911).epsilon(1e-4));
  const std::string box = output_of("box_of_grains.lammps");
  CHECK(box.find("Created 1000 atoms") != std::string::npos);
  double first = 0, last = 0, kinetic = 0, potential = 0, stored = 0, lost = 0;
  std::istringstream lines(box);
  for (std::string line; std::getline(lines, line);) {
    double step = 0, total = 0;
    if (!(std::istringstream(line) >> step >> kinetic >> potential >> stored >> lost >> total)) continue;
    if (step == 0) first = total;
    if (step == 10000) last = total;
  }
  CHECK(first > 0);
  CHECK(last == Approx(first).epsilon(1e-3));
}
