#include "examples.hpp"

#include "deck_run.hpp"

#include <catch2/catch.hpp>

#include <cstdio>
#include <fstream>
#include <sstream>

namespace engines {

std::string output_of(const std::string& example, int code, const std::string& last) {
  std::stringstream text;
  text << std::ifstream(RICOCHET_SOURCE_DIR "/" + example).rdbuf();
  std::string deck = text.str();
  if (!last.empty()) {
    const auto at = deck.rfind("\nrun ") + 1;
    REQUIRE(at > 0);
    deck.replace(at, deck.find('\n', at) + 1 - at, last);
  }
  const Workplace place("example_" + example.substr(example.rfind('/') + 1));
  REQUIRE(place.run(deck) == code);
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

void check_rotating_drum(const std::string& example, int grains) {
  const std::string output = output_of(example, 0,
                                       "variable spin atom mass*(x*vy-y*vx)\ncompute spin all reduce sum v_spin\n"
                                       "variable spun equal c_spin\nvariable grains equal atoms\n"
                                       "thermo_style custom step atoms ke c_spin\n"
                                       "run 0\nprint \"began with ${spun}\"\n"
                                       "run 10000\nprint \"kept ${grains} grains, spun ${spun}\"\n");
  CHECK(number_after(output, "\nkept ") == grains);
  const double before = number_after(output, "\nbegan with "), after = number_after(output, "grains, spun ");
  std::printf("%s: angular momentum from %.3g to %.3g kg m2/s\n", example.c_str(), before, after);
  CHECK(after > before);
}

}  // namespace engines
