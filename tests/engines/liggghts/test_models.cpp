#include "liggghts_run.hpp"

#include <ricochet/collision/fractional_contact.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace engines;

namespace {

constexpr double tcol = 1e-4, en = 0.5, dt = tcol / 50, speed = 0.5, slip = 2, friction = 0.1;

const Box box{{0, -0.01, -0.01}, {0.02, 0.01, 0.01}};

// A grain that strikes the wall x = 0 at a slant.
const Grain striker{.position = {1.5e-3 + 5 * dt * speed, 0, 0}, .velocity = {-speed, slip, 0}};

std::string target() { return pair_property("collisionTime", tcol) + pair_property("coefficientRestitution", en); }

std::string strike(const Workplace& place, const std::string& properties, const std::string& models) {
  return preamble(box) + place.create({striker}, box) + "neighbor 0.0005 bin\n" + properties +
         pair_property("coefficientFriction", friction) + pair_property("coefficientRollingFriction", 0.1) +
         "pair_style gran model fractional " + models + "\npair_coeff * *\nfix wall all wall/gran model fractional " +
         models + " primitive type 1 xplane 0\nfix move all nve/sphere\ntimestep " + number(dt) + "\n" +
         dump_command("dump") + "run 100\n";
}

Vector velocity_after(const std::string& name, const std::string& properties, const std::string& models) {
  const Workplace place(name);
  REQUIRE(place.run(strike(place, properties, models)) == 0);
  return place.frames("dump").back().velocity[0];
}

std::string complaint(const std::string& name, const std::string& properties) {
  const Workplace place(name);
  CHECK(place.run(strike(place, properties, "")) != 0);
  return place.output();
}

}  // namespace

TEST_CASE("k, c and α give the contact that the target gives") {
  const double alpha = ricochet::conversion_degree(en);
  const double coefficient = striker.mass() * ricochet::fractional_contact(alpha).z_star / std::pow(tcol, 2 - alpha);
  const double k = 4000, c = std::pow(coefficient / std::pow(k, 1 - alpha), 1 / alpha);
  const auto by_target = velocity_after("by_target", target(), "");
  const auto by_parameters = velocity_after(
      "by_parameters",
      pair_property("fractionalK", k) + pair_property("fractionalC", c) + pair_property("fractionalAlpha", alpha), "");
  CHECK(by_parameters[0] == Approx(by_target[0]).epsilon(1e-10));
  CHECK(by_target[0] == Approx(en * speed).epsilon(1e-3));
}

TEST_CASE("a grain that slips all through a collision loses μ(1 + en) of its normal speed along the wall") {
  // Its limit μ R is summed by the same kicks as R itself; until the tangential spring slips it takes a little less.
  const auto v = velocity_after("slip", target(), "tangential history");
  CHECK(slip - v[1] == Approx(friction * (speed + v[0])).epsilon(2e-2));
}

TEST_CASE("the normal law combines with LIGGGHTS's tangential, rolling and cohesion models") {
  const std::string cohesion = pair_property("cohesionEnergyDensity", 10);
  for (const std::string tangential : {"", "tangential no_history", "tangential history"})
    for (const std::string rolling : {"", "rolling_friction cdt", "rolling_friction epsd2"})
      for (const std::string cohesive : {"", "cohesion sjkr", "cohesion sjkr2"}) {
        if (tangential.empty() && !rolling.empty()) continue;
        INFO(tangential << ' ' << cohesive << ' ' << rolling);
        const auto v = velocity_after("combination", target() + (cohesive.empty() ? "" : cohesion),
                                      tangential + ' ' + cohesive + ' ' + rolling);
        CHECK(v[0] == Approx(en * speed).epsilon(cohesive.empty() ? 1e-3 : 2e-2));
        CHECK((v[1] < slip) == !tangential.empty());
      }
}

TEST_CASE("misuse of the model is refused with the name and the value") {
  CHECK(complaint("neither", "").find("fractionalK") != std::string::npos);
  CHECK(complaint("both", target() + pair_property("fractionalK", 1)).find("not both") != std::string::npos);
  CHECK(complaint("restitution", pair_property("collisionTime", tcol) + pair_property("coefficientRestitution", 1.2))
            .find("coefficientRestitution = 1.2") != std::string::npos);
  CHECK(complaint("time", pair_property("collisionTime", -1) + pair_property("coefficientRestitution", en))
            .find("collisionTime = -1") != std::string::npos);
  CHECK(complaint("degree", pair_property("fractionalK", 1) + pair_property("fractionalC", 1) +
                                pair_property("fractionalAlpha", 1))
            .find("alpha = 1") != std::string::npos);
}
