// What `verify benchmarks` measures with, on errors that are known.
#include "../../verify/studies/benchmarks/impact.hpp"
#include "../../verify/studies/benchmarks/row.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <variant>

using namespace ricochet;
using namespace ricochet::verify;
using namespace ricochet::verify::benchmarks;

namespace {

/// A number whose error is (step/t_col)² of its scale, a tenth of it to either side.
Row second_order() {
  constexpr double tcol = 2e-3;
  const Asked asked{.test = "test", .quantity = "number", .unit = "m", .exact = 3, .scale = 5, .published = 3.5};
  return measure({asked}, tcol, [&](double step) { return std::vector{3 + 5 * std::pow(step / tcol, 2)}; }).front();
}

}  // namespace

TEST_CASE("the order and the errors of a benchmark are those of a power law, taken to one step") {
  const Row row = second_order();
  CHECK(row.order() == Approx(2).epsilon(1e-9));
  CHECK(row.noise < 1e-6);
  for (int level = 0; level < 3; ++level)
    CHECK(row.errors.at(static_cast<std::size_t>(level)) == Approx(std::pow(coarsest << level, -2.0)).epsilon(1e-9));
}

TEST_CASE("a benchmark's line has what is published, what is exact and ours, in this order") {
  const Row row = second_order();
  const auto shown = table({row});
  const auto& cells = shown.rows().at(0);
  CHECK(shown.columns().at(3).name == "published");
  CHECK(std::get<double>(cells.at(3)) == 3.5);
  CHECK(shown.columns().at(4).name == "exact");
  CHECK(std::get<double>(cells.at(4)) == 3);
  CHECK(shown.columns().at(5).name == "ours");
  CHECK(std::get<double>(cells.at(5)) > 3);
  CHECK(std::get<double>(cells.at(5)) < 3 + 5 * std::pow(400, -2.0));
  CHECK(to_json(row)["ours"].get<double>() == std::get<double>(cells.at(5)));
  CHECK(to_json(row)["published"] == 3.5);
}

TEST_CASE("the greatest overlap and force between two steps are those of the spring") {
  // m y'' = −ky: v√(m/k) and v√(mk) after a quarter of a period, t_col half of one. A leapfrog's half swing is off by
  // (ωh)²/24, a parabola through its three highest steps by less; without the parabola it would be (ωh/2)²/2.
  const Sphere sphere{0.01, 2500, {}, {0, 0, -0.5}};
  const double k = 1e5, w = std::sqrt(k / sphere.mass()), tcol = std::numbers::pi / w;
  for (int mesh = 0; mesh < 16; ++mesh) {
    const double step = tcol / (100 + 3.1 * mesh), bound = std::pow(w * step, 2) / 12;
    const Meeting m = meet(against_wall(sphere, {Linear(k, 0)}), step);
    CAPTURE(mesh);
    CHECK(m.greatest_overlap == Approx(0.5 / w).epsilon(bound));
    CHECK(m.greatest_force == Approx(0.5 * sphere.mass() * w).epsilon(bound));
    CHECK(m.tcol == Approx(tcol).epsilon(bound));
  }
}
