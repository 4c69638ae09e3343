#include "../../core/src/collision/oblique/normal_path.hpp"

#include <ricochet/collision/oblique.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace ricochet;

namespace {

/// Rate and slope against central differences of overlap and force along the path, whose error is of order h².
template <class Law>
void check_derivatives(const Law& law) {
  const Impact impact{0.4, 3e-6};
  const Collision by_force = collide(law, impact);
  REQUIRE(by_force.separated());
  const auto path = collision::normal_path(law, impact, by_force);
  const double h = 1e-5 * path->length();
  for (const double share : {0.2, 0.5, 0.8}) {
    const bool loading = share * path->length() < path->turn();
    const auto at = [&](double away) { return path->at(share * path->length() + away, loading); };
    const collision::NormalInstant here = at(0), before = at(-h), after = at(h);
    CAPTURE(Law::name, share);
    CHECK((after.overlap - before.overlap) / (2 * h * here.pace) == Approx(here.rate).epsilon(1e-6).margin(1e-6));
    CHECK((after.force - before.force) / (2 * h * here.pace) == Approx(here.slope).epsilon(1e-5));
  }
}

}  // namespace

TEST_CASE("along every path the rate is that of the overlap, and the slope that of the force") {
  check_derivatives(Linear(5000, 0.05));
  check_derivatives(KuwabaraKono(1e6, 20));
  check_derivatives(Tsuji(1e6, 1));
  check_derivatives(Fractional(5000, 0.3, 0.3));
  check_derivatives(FractionalKelvinVoigt(2000, 20, 0.5));
  check_derivatives(FractionalHertz(5e5, 5000, 0.5));
  check_derivatives(FractionalZener(2000, 5000, 1e-5, 0.5));
}

TEST_CASE("the last overlap of a rebound is that of its spring") {
  // (v/w) sin(w rest), w = √(k/m), with the rest of the time 0.08⁴ π/(2w).
  const Hysteretic law(5000, 5000);
  const Impact impact{0.4, 3e-6};
  const auto path = collision::normal_path(law, impact, collide(law, impact));
  const collision::NormalInstant late = path->at(2 - 0.08, false);
  const double w = std::sqrt(5000 / 3e-6), rest = std::pow(0.08, 4) * std::acos(0.0) / w;
  CHECK(late.overlap == Approx(0.4 / w * std::sin(w * rest)).epsilon(1e-6));
  CHECK(late.rate == Approx(-0.4).epsilon(1e-8));
}
