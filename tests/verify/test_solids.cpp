#include "parsed_selection.hpp"

#include "../../verify/studies/figures/solids.hpp"
#include "../../verify/studies/orders/solids.hpp"

#include <console/exit.hpp>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::verify;

TEST_CASE("the laws of real solids are what they are said to be, in a second way and in a column") {
  const auto all = measure_solids(parsed_selection({"--alpha", "0.75", "--steps", "64,128,256,512,1024"}));
  std::vector<std::string> schemes;
  for (const Convergence& c : all) {
    CAPTURE(c.statement.scheme, c.statement.function, c.errors);
    CHECK(c.pass());
    schemes.push_back(c.statement.scheme);
  }
  auto stated = solid_schemes();
  std::sort(schemes.begin(), schemes.end());
  std::sort(stated.begin(), stated.end());
  CHECK(schemes == stated);
}

TEST_CASE("a degree that no series takes has its other ways, and a column its fewest steps") {
  const auto all = measure_solids(parsed_selection({"--alpha", "0.333", "--scheme", "fractional-zener by series"}));
  CHECK(all.empty());
  CHECK_THROWS_AS(measure_solids(parsed_selection({"--scheme", "fractional-zener in a column", "--steps", "8,16,32"})),
                  console::BadInput);
}

TEST_CASE("the exponents of the loss in the speed are those of the laws, and the figure has every law's colour") {
  CHECK(all_pass(figures::solids_gates()));
  const auto figure = figures::solids_figure();
  REQUIRE(figure.data.size() == 2);
  CHECK(figure.data[0].bytes.starts_with(
      "v0 [m/s],fractional,fractional-kelvin-voigt,fractional-zener,fractional-hertz,kuwabara-kono\n0.001,"));
  CHECK(figure.finding.find("keep that at every speed") != std::string::npos);
}
