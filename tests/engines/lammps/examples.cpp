#include "examples.hpp"

#include "../runs/deck_run.hpp"

#include <catch2/catch.hpp>

#include <fstream>
#include <sstream>

namespace engines {

std::string output_of(const std::string& example, int code) {
  std::stringstream deck;
  deck << std::ifstream(RICOCHET_SOURCE_DIR "/examples/lammps/" + example).rdbuf();
  const Workplace place("example_" + example.substr(example.find('/') + 1));
  REQUIRE(place.run(deck.str()) == code);
  return place.output();
}

double number_after(const std::string& text, const std::string& words) {
  const auto at = text.rfind(words);
  REQUIRE(at != std::string::npos);
  return std::stod(text.substr(at + words.size()));
}

void check_box_of_grains(const std::string& output) {
  CHECK(output.find("Created 1000 atoms") != std::string::npos);
  double first = 0, last = 0, kinetic = 0, potential = 0, stored = 0, lost = 0;
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);) {
    double step = 0, total = 0;
    if (!(std::istringstream(line) >> step >> kinetic >> potential >> stored >> lost >> total)) continue;
    if (step == 0) first = total;
    if (step == 10000) last = total;
  }
  CHECK(first > 0);
  CHECK(last == Approx(first).epsilon(1e-3));
}

}  // namespace engines
