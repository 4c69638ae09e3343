#include "liggghts_run.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/reduction.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace engines;
using ricochet::Reduction;

namespace {

constexpr double tcol = 1e-4, en = 0.5, dt = tcol / 50, speed = 0.5, slip = 2, friction = 0.1;

const Box box{{0, -0.01, -0.01}, {0.02, 0.01, 0.01}};

// A grain that strikes the wall x = 0 at a slant.
const Grain striker{.position = {1.5e-3 + 5 * dt * speed, 0, 0}, .velocity = {-speed, slip, 0}};

std::string target() { return pair_property("collisionTime", tcol) + pair_property("coefficientRestitution", en); }

std::string strike(const Workplace& place, const std::string& properties, const std::string& models,
                   const std::string& law = "fractional", double step = dt) {
  return preamble(box) + place.create({striker}, box) + "neighbor 0.0005 bin\n" + properties +
         pair_property("coefficientFriction", friction) + pair_property("coefficientRollingFriction", 0.1) +
         "pair_style gran model " + law + " " + models + "\npair_coeff * *\nfix wall all wall/gran model " + law + " " +
         models + " primitive type 1 xplane 0\nfix move all nve/sphere\ntimestep " + number(step) + "\n" +
         dump_command("dump") + "run 100\n";
}

Vector velocity_after(const std::string& name, const std::string& properties, const std::string& models,
                      const std::string& law = "fractional") {
  const Workplace place(name);
  REQUIRE(place.run(strike(place, properties, models, law)) == 0);
  return place.frames("dump").back().velocity[0];
}

std::string complaint(const std::string& name, const std::string& properties, const std::string& law = "fractional",
                      double step = dt) {
  const Workplace place(name);
  CHECK(place.run(strike(place, properties, "", law, step)) != 0);
  return place.output();
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

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

namespace {

/// The law that the target has at the striker's mass, given by its parameters, strikes as the target does.
template <class Law>
void check_parameters(const Model& model) {
  const Law law =
      *Reduction<Law>::in_si(Reduction<Law>::unit(en, ricochet::ContactEnd::force)->law, tcol, {speed, striker.mass()});
  std::string given;
  for (std::size_t i = 0; i < Law::parameters.size(); ++i) {
    std::string name(Law::parameters[i].name);
    name[0] = static_cast<char>(std::toupper(name[0]));
    given += pair_property("fractional" + name, law.values()[i]);
  }
  const auto by_target = velocity_after(model.name + "_by_target", target() + model.properties, "", model.name);
  const auto by_parameters = velocity_after(model.name + "_by_parameters", given + model.properties, "", model.name);
  CHECK(by_target[0] == Approx(en * speed).epsilon(1e-3));
  CHECK(by_parameters[0] == Approx(by_target[0]).epsilon(1e-10));
  // Friction's stiffness is that of the linear contact with the same t_col and e_n, taken between near masses.
  const auto slipping =
      velocity_after(model.name + "_slip", target() + model.properties, "tangential history", model.name);
  CHECK(velocity_after(model.name + "_slip_by_parameters", given + model.properties, "tangential history",
                       model.name)[1] == Approx(slipping[1]).epsilon(1e-4));
}

}  // namespace

TEST_CASE("a law of a real solid given by its parameters strikes as by its target") {
  const auto models = our_models();
  check_parameters<ricochet::FractionalKelvinVoigt>(models[1]);
  check_parameters<ricochet::FractionalHertz>(models[2]);
  check_parameters<ricochet::FractionalZener>(models[3]);
}

TEST_CASE("a grain that slips all through a collision loses μ(1 + en) of its normal speed along the wall") {
  // Its limit μ R is summed by the same kicks as R itself; until the tangential spring slips it takes a little less.
  const auto v = velocity_after("slip", target(), "tangential history");
  CHECK(slip - v[1] == Approx(friction * (speed + v[0])).epsilon(2e-2));
}

TEST_CASE("kt and gammat_abs of the deck take the place of the linear contact's in the tangent plane") {
  // Those of the linear contact itself, where they change nothing; then others, which do.
  const double per_time = striker.mass() / tcol, loss = -std::log(en), pi = std::acos(-1);
  const double stiffness = per_time * (pi * pi + loss * loss) / tcol, damping = 2 * per_time * loss;
  const auto rub = [](double kt, double gammat) {
    return velocity_after("kt", target() + pair_property("kt", kt) + pair_property("gammat_abs", gammat),
                          "tangential history");
  };
  const Vector linear = velocity_after("kt_linear", target(), "tangential history");
  CHECK(rub(stiffness, damping)[1] == Approx(linear[1]).epsilon(1e-9));
  CHECK(std::abs(rub(1e-3 * stiffness, damping)[1] - linear[1]) > 1e-2);
  // LIGGGHTS limits the spring's force, so that without one the dashpot sticks.
  CHECK(rub(0, 0)[1] == Approx(slip).epsilon(1e-12));
  CHECK(rub(0, damping)[1] < slip - 1e-2);
  const Workplace place("kt_twice");
  std::string deck = strike(place, target() + pair_property("kt", 1), "tangential history");
  deck.insert(deck.find("\npair_coeff"), " ktToKnUser on");
  CHECK(place.run(deck) != 0);
  CHECK(contains(place.output(), "model fractional takes either kt (fix property/global) or ktToKnUser on, not both"));
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
  const std::string neither = complaint("neither", pair_property("coefficientRestitution", en));
  CHECK(contains(neither,
                 "either collisionTime and coefficientRestitution or fractionalK, fractionalC and "
                 "fractionalAlpha"));
  CHECK(contains(neither, "finds neither"));
  CHECK(contains(complaint("speed", target(), "fractional-hertz"), "characteristicVelocity = 0"));
  CHECK(contains(complaint("reach", pair_property("collisionTime", tcol) + pair_property("coefficientRestitution", 0.2),
                           "fractional-kelvin-voigt"),
                 "coefficientRestitution = 0.2"));
  CHECK(complaint("both", target() + pair_property("fractionalK", 1)).find("not both") != std::string::npos);
  CHECK(complaint("restitution", pair_property("collisionTime", tcol) + pair_property("coefficientRestitution", 1.2))
            .find("coefficientRestitution = 1.2") != std::string::npos);
  CHECK(complaint("time", pair_property("collisionTime", -1) + pair_property("coefficientRestitution", en))
            .find("collisionTime = -1") != std::string::npos);
  CHECK(complaint("degree", pair_property("fractionalK", 1) + pair_property("fractionalC", 1) +
                                pair_property("fractionalAlpha", 1))
            .find("alpha = 1") != std::string::npos);
}

TEST_CASE("a step too coarse for the collisions is warned of, and refused") {
  const auto output = [](const std::string& name, double steps) {
    const Workplace place(name);
    REQUIRE(place.run(strike(place, target(), "", "fractional", tcol / steps)) == 0);
    return place.output();
  };
  CHECK_FALSE(contains(output("steps_20", 20.01), "WARNING: model fractional"));
  CHECK(contains(output("steps_19", 19), "WARNING: model fractional: timestep = 5.26316e-06 leaves 19 steps"));
  CHECK(contains(output("steps_4", 4.01), "leaves 4.01 steps"));
  CHECK(contains(complaint("steps_3", target(), "fractional", tcol / 3.99),
                 "timestep = 2.50627e-05: must be at most 1/4 of the shortest collision time, 0.0001"));
  // By parameters the lightest pair counts: here two grains, of which a wall has twice the effective mass.
  const double alpha = ricochet::conversion_degree(en);
  const double coefficient = striker.mass() * ricochet::fractional_contact(alpha).z_star / std::pow(tcol, 2 - alpha);
  const std::string parameters = pair_property("fractionalK", coefficient) + pair_property("fractionalC", coefficient) +
                                 pair_property("fractionalAlpha", alpha);
  CHECK(contains(complaint("steps_of_lightest", parameters, "fractional", tcol / 5), "must be at most 1/4"));
}

TEST_CASE("a later run with another time step keeps the kernel and says so") {
  const Workplace place("later");
  REQUIRE(place.run(strike(place, target(), "") + "timestep 1e-6\nrun 1\n") == 0);
  CHECK(contains(place.output(), "timestep = 1e-06: the memory kernel stays the one chosen for timestep = 2e-06"));
}

TEST_CASE("grains too soft for their load, and contacts that lost their memory, are told of") {
  const Workplace soft("soft");
  const std::string slow = pair_property("collisionTime", 20 * tcol) + pair_property("coefficientRestitution", en);
  REQUIRE(soft.run(strike(soft, slow, "") + "run 500\n") == 0);
  CHECK(contains(soft.output(), "% of the smaller radius"));
  const Workplace hard("hard");
  REQUIRE(hard.run(strike(hard, target(), "")) == 0);
  CHECK_FALSE(contains(hard.output(), "% of the smaller radius"));
  for (const char* reset : {"reset_timestep 0\n", ""}) {
    const Workplace place("reset");
    std::string deck = strike(place, target(), "");
    deck.replace(deck.rfind("run 100\n"), 8, std::string("run 20\n") + "undump dump\n" + reset + "run 80\n");
    REQUIRE(place.run(deck) == 0);
    CHECK(contains(place.output(), "reset_timestep while grains touch") == (*reset != 0));
  }
}
