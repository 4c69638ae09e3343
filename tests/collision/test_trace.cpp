#include "../../docs/examples/standard_solid.hpp"

#include <ricochet/collision/trace.hpp>

#include <catch2/catch.hpp>

using namespace ricochet;

TEST_CASE("A trace ends where the collision does, to second order") {
  const Impact impact{.velocity = 0.5, .mass_eff = 7.06858e-6};
  const auto check = [&](const auto& law) {
    const Collision exact = collide(law, impact);
    const auto points = trace(law, impact, exact.tcol, 2000);
    CHECK(points.size() == 2001);
    CHECK(-points.back().rate / impact.velocity == Approx(exact.en).epsilon(1e-4));
    CHECK(points.back().overlap == Approx(exact.overlap_end).margin(1e-4 * exact.max_overlap));
    CHECK(points.back().force == Approx(0).margin(1e-2 * exact.max_force));
  };
  check(Linear(5225, 0.0981));
  check(KuwabaraKono(1392000, 33.885));
  check(Hysteretic(3924, 15697));
  check(StandardSolid(7000, 7000, 2e-5));
}

TEST_CASE("A trace of nothing is refused by name") {
  const Linear law(5225, 0.0981);
  const Impact impact{.velocity = 0.5, .mass_eff = 7.06858e-6};
  CHECK_THROWS_WITH(trace(law, impact, 1e-4, 0), "steps = 0: must be at least 1");
  CHECK_THROWS_WITH(trace(law, impact, -1e-4, 10), "duration = -1e-04: must be finite and > 0");
  CHECK_THROWS_WITH(trace(law, {.velocity = 0.5, .mass_eff = -1}, 1e-4, 10), "mass_eff = -1: must be finite and > 0");
  CHECK_THROWS_WITH(trace(law, {.velocity = 0, .mass_eff = 1}, 1e-4, 10), "velocity = 0: must be finite and > 0");
}
