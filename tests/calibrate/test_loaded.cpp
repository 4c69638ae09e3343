#include <catch2/catch.hpp>

#include <calibrate/loaded.hpp>
#include <ricochet/collision/loaded.hpp>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

constexpr Impact impact{0.5, 7e-6};

}  // namespace

TEST_CASE("Every law is found under a load, in two ways, and does there what was asked") {
  for (const LawKind law : LawKind::all()) {
    const Outcome outcome = calibrate_under_load({law, ContactEnd::force, {1e-4, 0.6, impact}}, 3e-3);
    REQUIRE(std::holds_alternative<Calibration>(outcome));
    const auto& found = std::get<Calibration>(outcome);
    INFO(law.name());
    CHECK(found.achieved.tcol == Approx(1e-4).epsilon(1e-7));
    CHECK(found.achieved.en == Approx(0.6).epsilon(1e-7));
    CHECK(found.cross_difference < 1e-6);
    REQUIRE(found.under_load);
    CHECK(found.under_load->load == 3e-3);
    CHECK(found.under_load->clears);
    // The load makes a contact longer and takes from en: without it the same law is quicker and keeps more.
    const Collision free = collide(found.law, impact);
    CHECK(free.tcol < 1e-4);
    CHECK(free.en >= 0.6 * (1 - 1e-7));
  }
}

TEST_CASE("A load that is too great for the target is out of reach") {
  const Outcome outcome = calibrate_under_load({kind_of<Linear>, ContactEnd::force, {1e-4, 0.001, impact}}, 1000);
  REQUIRE(std::holds_alternative<Infeasible>(outcome));
  CHECK_THAT(std::get<Infeasible>(outcome).reason, Catch::Contains("under a load of 2.86e+04 m v/tcol"));
}

TEST_CASE("What given parameters do under a load, and from which speed on") {
  const Linear law(5000, 0.05);
  const Outcome fast = answer_under_load(law, impact, 1e-3);
  REQUIRE(std::holds_alternative<Calibration>(fast));
  CHECK(std::get<Calibration>(fast).achieved.en == Approx(collide_under_load(law, impact, 1e-3).en));
  const double least = std::get<Calibration>(fast).under_load->least_velocity;
  const Outcome slow = answer_under_load(law, {0.9 * least, impact.mass_eff}, 1e-3);
  REQUIRE(std::holds_alternative<Infeasible>(slow));
  CHECK(std::get<Infeasible>(slow).quantity == "velocity");
  CHECK(std::get<Infeasible>(slow).lowest == Approx(least));
  CHECK_THROWS_WITH(answer_under_load(law, impact, -1), "load = -1: must be finite and > 0");
}
