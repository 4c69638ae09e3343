#include <pair_law.hpp>

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/contact/power_law.hpp>
#include <ricochet/collision/collision.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <map>

using namespace ricochet;
using namespace ricochet::liggghts;

namespace {

struct Contacts {
  std::map<double, HalfStepContact> made;
  const HalfStepContact& operator()(double alpha) { return made.try_emplace(alpha, alpha, 1e-6, 1e-3).first->second; }
};

}  // namespace

TEST_CASE("A pair law made for a target meets it at every mass") {
  Contacts contacts;
  for (double en : {0.2, 0.5, 0.95}) {
    const PairLaw law = PairLaw::from_target(1e-4, en, std::ref(contacts));
    CHECK(law.en() == Approx(en).epsilon(1e-12));
    for (double mass : {1e-6, 3e-3}) {
      CHECK(law.tcol(mass) == 1e-4);
      // The coefficient's own collision time: C t^{2−α}/m = z*.
      const double alpha = law.contact().alpha();
      const double time = std::pow(fractional_contact(alpha).z_star * mass / law.coefficient(mass), 1 / (2 - alpha));
      CHECK(time == Approx(1e-4).epsilon(1e-12));
      // The same coefficient given as k and c makes the same law.
      const double c = law.coefficient(mass);
      const PairLaw same = PairLaw::from_parameters(c, c, alpha, std::ref(contacts));
      CHECK(same.coefficient(mass) == Approx(c).epsilon(1e-14));
      CHECK(same.tcol(mass) == Approx(1e-4).epsilon(1e-12));
    }
  }
  CHECK(contacts.made.size() == 3);  // all pairs of one restitution share a contact
}

TEST_CASE("A pair law of k, c and alpha has one coefficient, and a collision time that grows with the mass") {
  Contacts contacts;
  const PairLaw law = PairLaw::from_parameters(5225, 0.2964394, 0.3196786, std::ref(contacts));  // Table II
  const double mass = 7.06858e-6;
  CHECK(law.coefficient(1) == Approx(std::pow(0.2964394, 0.3196786) * std::pow(5225, 1 - 0.3196786)).epsilon(1e-14));
  CHECK(law.en() == Approx(0.5).epsilon(1e-6));
  CHECK(law.tcol(mass) == Approx(1e-4).epsilon(1e-6));
  CHECK(law.tcol(2 * mass) / law.tcol(mass) == Approx(std::pow(2, 1 / (2 - 0.3196786))).epsilon(1e-12));
}

TEST_CASE("The linear equivalent has the same collision time and restitution") {
  Contacts contacts;
  const double mass = 2e-5;
  CollideOptions overlap;
  overlap.end = ContactEnd::overlap;
  for (const PairLaw& law : {PairLaw::from_target(1e-4, 0.4, std::ref(contacts)),
                             PairLaw::from_parameters(4000, 0.1, 0.2, std::ref(contacts))}) {
    const LinearEquivalent linear = law.linear_equivalent(mass);
    const Collision out = collide(Linear(linear.stiffness, linear.damping), {1, mass}, overlap);
    CHECK(out.tcol == Approx(law.tcol(mass)).epsilon(1e-12));
    CHECK(out.en == Approx(law.en()).epsilon(1e-12));
  }
}

TEST_CASE("A target that no contact meets is named") {
  Contacts contacts;
  CHECK_THROWS_WITH(PairLaw::from_target(0, 0.5, std::ref(contacts)), Catch::Contains("collisionTime = 0"));
  CHECK_THROWS_WITH(PairLaw::from_target(1e-4, 1.5, std::ref(contacts)),
                    Catch::Contains("coefficientRestitution = 1.5"));
  CHECK_THROWS_WITH(PairLaw::from_parameters(-1, 0.1, 0.2, std::ref(contacts)), Catch::Contains("k = -1"));
}
