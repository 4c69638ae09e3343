#include "../../verify/studies/paper.hpp"
#include "../../verify/studies/table1/rows.hpp"
#include "../../verify/studies/table1/variants.hpp"

#include <ricochet/collision/fractional_contact.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

using namespace ricochet;
using namespace ricochet::verify;
using namespace ricochet::verify::table1;

namespace {

const Fractional steel_law(paper::steel.k, paper::steel.c, paper::steel.alpha);
const Impact impact = paper::steel.impact(paper::steel.density);

double last_velocity(Variant variant, int steps) {
  return end_of(variant, steel_law, impact, paper::steel.tcol, steps).rate;
}

}  // namespace

TEST_CASE("one step of each variant of (59) is the stages' formula") {
  constexpr double h = 1e-6;
  const double alpha = steel_law.alpha(), v0 = impact.velocity;
  const double a1 = steel_law.coefficient() / impact.mass_eff / std::tgamma(2 - alpha);
  const double whole = a1 * std::pow(h, 1 - alpha), half = a1 * std::pow(h / 2, 1 - alpha);
  const auto end = [&](Held held, Stepper stepper) { return end_of({held, stepper}, steel_law, impact, h, 1); };

  // Heun predicts v₀, whatever is held, as there is no force yet.
  for (const Held held : {Held::left, Held::mean, Held::chord})
    CHECK(end(held, Stepper::heun).rate == Approx(v0 * (1 - h / 2 * whole)).epsilon(1e-14));
  CHECK(end(Held::left, Stepper::heun).overlap == Approx(h * v0).epsilon(1e-14));

  const double slope2 = -half * v0, middle = v0 + h / 2 * slope2;
  const double mean3 = -half * (v0 + middle) / 2, mean4 = -whole * (v0 + v0 + h * mean3) / 2;
  CHECK(end(Held::mean, Stepper::rk4).rate == Approx(v0 + h / 6 * (2 * slope2 + 2 * mean3 + mean4)).epsilon(1e-14));
  // The chord to the second and third stage is v₀, to the fourth the third's rate, `middle`.
  CHECK(end(Held::chord, Stepper::rk4).rate == Approx(v0 + h / 6 * (4 * slope2 - whole * middle)).epsilon(1e-14));
  CHECK(end(Held::left, Stepper::rk4).rate == Approx(v0 + h / 6 * (4 * -half * v0 - whole * v0)).epsilon(1e-14));

  // The force at the end is that of the whole step's held rate.
  const Instant mean = end(Held::mean, Stepper::heun);
  CHECK(mean.force == Approx(impact.mass_eff * whole * (v0 + mean.rate) / 2).epsilon(1e-14));
  CHECK(mean.time == Approx(h).epsilon(1e-14));
}

TEST_CASE("the last velocities of Table I by each variant are those of a program in another language") {
  const auto same = [](Variant variant, double at_5, double at_20, double at_40) {
    CHECK(last_velocity(variant, 5) == Approx(at_5).margin(0.5e-5));
    CHECK(last_velocity(variant, 20) == Approx(at_20).margin(0.5e-5));
    CHECK(last_velocity(variant, 40) == Approx(at_40).margin(0.5e-5));
  };
  same({Held::left, Stepper::heun}, -1.12593, -0.75276, -0.70585);
  same({Held::left, Stepper::rk4}, -1.07981, -0.75016, -0.70516);
  same({Held::mean, Stepper::heun}, -0.66423, -0.66576, -0.66399);
  same({Held::mean, Stepper::rk4}, -0.67422, -0.66425, -0.66346);
  same({Held::chord, Stepper::heun}, -0.74346, -0.66616, -0.66388);
  same({Held::chord, Stepper::rk4}, -0.67056, -0.66382, -0.66333);
}

TEST_CASE("the rows of Table I end where the force has fallen to zero, or at the printed time") {
  for (const Row& row : rows_of(printed_lines())) {
    CAPTURE(row.density, row.line.steps);
    // The force falls by 0.1 N in 0.03 us there: 1e-9 N are 3e-16 s.
    if (!row.rounded_end) CHECK(std::abs(row.exact.force) < 1e-9);
    if (row.rounded_end) CHECK(row.time == paper::steel.tcol);
    CHECK(row.exact.time == row.time);
    if (row.line.steps == 40) CHECK(row.left.rate / row.exact.rate == Approx(1).epsilon(0.1));
  }
}

TEST_CASE("the table of Table I shows the printed line as it is printed, beside the closed form") {
  const auto lines = printed_lines();
  const auto rows = table_of(rows_of(lines)).rows();
  const auto first = std::find_if(rows.begin(), rows.end(), [](const auto& r) {
    return std::get<std::string>(r[3]) == "paper" && std::get<std::string>(r[2]) == "limit";
  });
  REQUIRE(first != rows.end());
  const Instant& printed =
      std::find_if(lines.begin(), lines.end(), [](const Line& l) { return l.steps == 0; })->printed;
  CHECK(std::get<double>((*first)[4]) == Approx(1e6 * printed.overlap));
  CHECK(std::get<double>((*first)[5]) == printed.rate);
  CHECK(std::get<double>((*first)[6]) == printed.force);
  // What follows is the closed form at the time at which its force is 0: e_n of α = 0.2, at 1 m/s.
  const auto& exact = *(first + 1);
  CHECK(std::get<std::string>(exact[3]) == "exact");
  CHECK(std::get<double>(exact[5]) == Approx(-fractional_contact(0.2).en).epsilon(1e-9));
  CHECK(std::abs(std::get<double>(exact[6])) < 1e-9);
}
