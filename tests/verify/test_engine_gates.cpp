// The bounds of `verify engines`, which has no run without engines: made-up outcomes just inside and just outside.
#include "../../verify/studies/engines/engine_run.hpp"
#include "../../verify/studies/engines/oblique.hpp"
#include "../../verify/studies/engines/outcome.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::verify;
using namespace ricochet::verify::engines;

namespace {

/// A restitution of 0.5 in 1e-4 s whose errors at tcol/25, …, tcol/400 are these.
Outcome outcome(const std::vector<double>& errors) {
  Outcome o{.what = {.engine = calibration::Engine::lammps,
                     .name = "linear, force",
                     .snippet = "",
                     .end = ContactEnd::force,
                     .en_asked = 0.5,
                     .en = 0.5,
                     .tcol = 1e-4,
                     .law = {},
                     .who = {}},
            .at = {},
            .limit = {0.5, 1e-4}};
  for (const double error : errors) o.at.push_back({0.5 * (1 + error), 1e-4});
  return o;
}

const std::vector<double> first_order{1.6e-3, 8e-4, 4e-4, 2e-4, 1e-4}, second_order{1e-3, 2.5e-4, 6e-5, 1.6e-5, 4e-6};

/// Names of the gates that fail, without the contact's.
std::vector<std::string> failing(const Outcome& o) {
  std::vector<Gate> gates;
  add_gates(gates, o);
  std::vector<std::string> names;
  for (const Gate& gate : gates)
    if (!gate.pass) names.push_back(gate.name.substr(gate.name.rfind(": ") + 2));
  return names;
}

using Names = std::vector<std::string>;

/// Three angles whose errors, in units of the velocity, fall like the step to the power `order`; the limit is off from
/// the engine's rule by `from_rule` and from ours by `from_ours`.
std::vector<ObliqueOutcome> oblique(bool exact, double order, double from_rule, double from_ours) {
  std::vector<ObliqueOutcome> all;
  for (const double angle : {20.0, 45.0, 70.0}) {
    ObliqueOutcome o{.what = {.what = outcome({}).what, .tangential = "linear, damped", .angle = angle}};
    o.what.exact = exact;
    o.what.rule = {0.4, 0.3}, o.what.ours = o.what.rule;
    o.limit = {0.4, 0.3 + from_rule}, o.what.ours.spin = o.limit.spin + from_ours;
    for (const int n : resolutions) o.at.push_back({0.4, 0.3 + 0.01 * std::pow(n / 25.0, -order)});
    all.push_back(o);
  }
  return all;
}

Names failing(const std::vector<ObliqueOutcome>& outcomes) {
  Names names;
  for (const Gate& gate : oblique_gates(outcomes))
    if (!gate.pass) names.push_back(gate.name.substr(gate.name.rfind(": ") + 2));
  return names;
}

}  // namespace

TEST_CASE("verify engines: unequal grains meet as one of their effective mass and radius") {
  const Encounter wall{.a = {.radius = 2e-3, .density = 3000}};
  CHECK(wall.reach() == 2e-3);
  CHECK(wall.mass_eff() == Approx(3000 * 4 * std::acos(-1.0) / 3 * 8e-9).epsilon(1e-15));
  CHECK(wall.radius_eff() == 2e-3);
  // Of one density, 27 to 8 in mass: 27·8/35.
  Encounter pair = wall;
  pair.b = {.radius = 3e-3, .density = 3000};
  CHECK(pair.reach() == Approx(5e-3).epsilon(1e-15));
  CHECK(pair.mass_eff() == Approx(27 * wall.mass_eff() / 35).epsilon(1e-14));
  CHECK(pair.radius_eff() == Approx(1.2e-3).epsilon(1e-14));
}

TEST_CASE("verify engines: restitution and time in the limit are held to a thousandth") {
  CHECK(failing(outcome(first_order)).empty());
  for (const double sign : {-1.0, 1.0}) {
    Outcome o = outcome(first_order);
    o.limit = {0.5 * (1 + 0.99e-3 * sign), 1e-4 * (1 + 0.99e-3 * sign)};
    CHECK(failing(o).empty());
    o.limit.en = 0.5 * (1 + 1.01e-3 * sign);
    CHECK(failing(o) == Names{"en in the limit, relative error"});
    o.limit = {0.5, 1e-4 * (1 + 1.01e-3 * sign)};
    CHECK(failing(o) == Names{"tcol in the limit, relative error"});
    o.what.tcol = 0;  // not known
    CHECK(failing(o).empty());
  }
}

TEST_CASE("verify engines: errors fall at first order, those of a driver at second") {
  const Names slow{"en error at tcol/400 over that at tcol/25 and tcol/50"};
  // The coarsest error alone may be small by chance, and so may the second.
  for (const std::vector<double>& coarse : {std::vector{8e-4, 1e-5}, {1e-5, 8e-4}}) {
    CHECK(failing(outcome({coarse[0], coarse[1], 4e-4, 2e-4, 1.99e-4})).empty());
    CHECK(failing(outcome({coarse[0], coarse[1], 4e-4, 2e-4, 2.01e-4})) == slow);
  }
  // Where all errors are rounding of the engine's output, no rate is asked for.
  CHECK(failing(outcome({1e-6, 1e-6, 1e-6, 1e-6, 0.99e-5})).empty());
  CHECK(failing(outcome({1e-6, 1e-6, 1e-6, 1e-6, 1.01e-5})) == slow);
  Outcome driver = outcome(second_order);
  driver.what.fractional = true;
  CHECK(failing(driver).empty());
  driver.at[finest].en = 0.5 * (1 + 0.99 * 1e-3 / 32);
  CHECK(failing(driver).empty());
  driver.at[finest].en = 0.5 * (1 + 1.01 * 1e-3 / 32);
  CHECK(failing(driver) == slow);
}

TEST_CASE("verify engines: an error above a thousandth at tcol/200 is to be the engine's own stepping") {
  CHECK(failing(outcome({1.6e-2, 8e-3, 4e-3, 0.99e-3, 5e-4})).empty());
  Outcome o = outcome({1.6e-2, 8e-3, 4e-3, 1.01e-3, 5e-4});
  CHECK(failing(o) == Names{"en error at tcol/200"});
  o.repeated = 0.99e-8;
  CHECK(failing(o).empty());
  o.repeated = 1.01e-8;
  CHECK(failing(o) == Names{"en against its stepping repeated"});
}

TEST_CASE("verify engines: oblique impacts are held to a thousandth and to first order") {
  const Names ours{"e_t and spin in the limit, from ours"}, rule{"e_t and spin in the limit, from its rule"},
      another{"e_t and spin in the limit, from ours, which is another law"}, order{"order in the step"};
  CHECK(failing(oblique(true, 1, 0.99e-3, -0.99e-3)).empty());
  CHECK(failing(oblique(true, 1, 0, 1.01e-3)) == ours);
  CHECK(failing(oblique(true, 1, 1.01e-3, 0)) == rule);
  CHECK(failing(oblique(false, 1, 0, 1.01e-3)).empty());
  CHECK(failing(oblique(false, 1, 0, 0.2)).empty());  // held to its own rule, however far ours is
  CHECK(failing(oblique(false, 1, 0, 0.99e-3)) == another);
  for (const double inside : {0.71, 1.29}) CHECK(failing(oblique(true, inside, 0, 0)).empty());
  for (const double outside : {0.69, 1.31}) CHECK(failing(oblique(true, outside, 0, 0)) == order);
  // e_t counts by the share that the tangential velocity is of all: sin 20° at the first angle.
  auto slight = oblique(true, 1, 0, 0);
  slight[0].limit.et += 2.9e-3;
  CHECK(failing(slight).empty());
  slight[0].limit.et += 0.1e-3;
  CHECK(failing(slight) == Names{ours[0], rule[0]});
}
