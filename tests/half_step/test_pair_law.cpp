#include <pair_law.hpp>

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/contact/power_law.hpp>
#include <ricochet/collision/collision.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>

using namespace ricochet;
using namespace ricochet::half_step;

namespace {

constexpr TargetNames names{"collisionTime", "coefficientRestitution", "fractionalAlpha"};

template <class Law>
struct Contacts {
  std::map<ParameterValues<Law>, LocatedContact<Law>> made;
  const LocatedContact<Law>& operator()(const Law& law) {
    return made.try_emplace(law.values(), law, 1e-6, 1e-3).first->second;
  }
};

using FractionalPair = PairLaw<Fractional>;

FractionalPair fractional_target(double tcol, double en, Contacts<Fractional>& contacts) {
  return FractionalPair::from_target(tcol, en, {}, 1, std::ref(contacts), names);
}

}  // namespace

TEST_CASE("A pair law made for a target meets it at every mass") {
  Contacts<Fractional> contacts;
  for (double en : {0.2, 0.5, 0.95}) {
    const FractionalPair law = fractional_target(1e-4, en, contacts);
    CHECK(law.en(1e-6) == Approx(en).epsilon(1e-12));
    for (double mass : {1e-6, 3e-3}) {
      CHECK(law.tcol(mass) == Approx(1e-4).epsilon(1e-14));
      // The coefficient's own collision time: C t^{2−α}/m = z*.
      const double alpha = law.contact().law().alpha();
      const double c = law.coefficient(mass) * law.contact().law().coefficient();
      const double time = std::pow(fractional_contact(alpha).z_star * mass / c, 1 / (2 - alpha));
      CHECK(time == Approx(1e-4).epsilon(1e-12));
      // The same coefficient given as k and c makes the same law.
      const FractionalPair same = FractionalPair::from_parameters({c, c, alpha}, 1, std::ref(contacts));
      CHECK(same.coefficient(mass) == 1);
      CHECK(same.tcol(mass) == Approx(1e-4).epsilon(1e-12));
    }
  }
  CHECK(contacts.made.size() == 3 + 6);  // all pairs of one restitution share a contact, of one set of parameters too
}

TEST_CASE("A pair law of k, c and alpha has one coefficient, and a collision time that grows with the mass") {
  Contacts<Fractional> contacts;
  const FractionalPair law =
      FractionalPair::from_parameters({5225, 0.2964394, 0.3196786}, 1, std::ref(contacts));  // Table II
  const double mass = 7.06858e-6;
  CHECK(law.coefficient(1) == 1);
  CHECK(law.en(mass) == Approx(0.5).epsilon(1e-6));
  CHECK(law.tcol(mass) == Approx(1e-4).epsilon(1e-6));
  CHECK(law.tcol(2 * mass) / law.tcol(mass) == Approx(std::pow(2, 1 / (2 - 0.3196786))).epsilon(1e-12));
}

TEST_CASE("The linear equivalent has the same collision time and restitution") {
  Contacts<Fractional> contacts;
  const double mass = 2e-5;
  CollideOptions overlap;
  overlap.end = ContactEnd::overlap;
  for (const FractionalPair& law : {fractional_target(1e-4, 0.4, contacts),
                                    FractionalPair::from_parameters({4000, 0.1, 0.2}, 1, std::ref(contacts))}) {
    const LinearEquivalent linear = law.linear_equivalent(mass);
    const Collision out = collide(Linear(linear.stiffness, linear.damping), {1, mass}, overlap);
    CHECK(out.tcol == Approx(law.tcol(mass)).epsilon(1e-12));
    CHECK(out.en == Approx(law.en(mass)).epsilon(1e-12));
  }
}

TEST_CASE("A target that no contact meets is named") {
  Contacts<Fractional> contacts;
  CHECK_THROWS_WITH(fractional_target(0, 0.5, contacts), Catch::Contains("collisionTime = 0"));
  CHECK_THROWS_WITH(fractional_target(1e-4, 1.5, contacts), Catch::Contains("coefficientRestitution = 1.5"));
  Contacts<FractionalKelvinVoigt> solid;
  CHECK_THROWS_WITH(PairLaw<FractionalKelvinVoigt>::from_target(1e-4, 0.2, {0.5}, 1, std::ref(solid), names),
                    Catch::Contains("coefficientRestitution = 0.2: must be one that"));
}

namespace {

/// In a target's law the coefficients go with the mass; given as parameters, the same law gives the target at that mass
/// and at others what their own collisions are.
template <class Law>
void check_solid(double en, const Held& held, double velocity) {
  Contacts<Law> contacts;
  const PairLaw<Law> law = PairLaw<Law>::from_target(1e-4, en, held, velocity, std::ref(contacts), names);
  const Collision unit = collide(law.contact().law(), {velocity, 1});
  CHECK(unit.tcol == Approx(1e-4).epsilon(1e-9));
  CHECK(unit.en == Approx(en).epsilon(1e-9));
  CHECK(law.coefficient(2e-5) == 2e-5);
  const PairLaw<Law> given = PairLaw<Law>::from_parameters(law.contact().law(), velocity, std::ref(contacts));
  CHECK(contacts.made.size() == 1);
  for (const double mass : {0.93, 1.0, 1.9}) {
    const Collision own = collide(law.contact().law(), {velocity, mass});
    CHECK(given.coefficient(mass) == 1);
    CHECK(given.tcol(mass) == Approx(own.tcol).epsilon(1e-4));
    CHECK(given.en(mass) == Approx(own.en).epsilon(1e-4));
  }
}

}  // namespace

TEST_CASE("The laws of real solids meet a target at every mass, and keep their parameters at every mass") {
  check_solid<FractionalKelvinVoigt>(0.7, {0.4}, 1);
  check_solid<FractionalHertz>(0.7, {0.4}, 0.3);
  check_solid<FractionalZener>(0.8, {0.4, 5}, 1);
}
