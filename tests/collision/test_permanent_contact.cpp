#include <catch2/catch.hpp>

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/solvers/permanent_contact.hpp>

#include <cmath>

using namespace ricochet;

TEST_CASE("Steps follow a permanent contact with the order that its start leaves, and graded with 2") {
  const Impact impact{.velocity = 0.5, .mass_eff = 7e-6};
  for (const double alpha : {1.0, 1.3, 1.6})
    for (const bool graded : {false, true}) {
      const Fractional law(5000, 0.1, alpha);
      const FractionalTrajectory exact(law.coefficient(), alpha, impact.mass_eff, impact.velocity);
      const auto error = [&](int steps) {
        const Instant end = follow_permanent_contact(law, impact, 5e-4, steps, graded).back();
        CHECK(end.time == Approx(5e-4));
        CHECK(end.overlap == Approx(exact.overlap(5e-4)).epsilon(1e-2));
        return std::abs(end.rate - exact.rate(5e-4));
      };
      CHECK(std::log2(error(64) / error(128)) == Approx(graded ? 2 : 3 - alpha).margin(0.1));
    }
}

TEST_CASE("What steps through a permanent contact do not take") {
  const Impact impact{.velocity = 0.5, .mass_eff = 7e-6};
  CHECK_THROWS_WITH(follow_permanent_contact({1, 1, 0.9}, impact, 1, 8, true), "alpha = 0.9: must be in [1, 2)");
  CHECK_THROWS_WITH(follow_permanent_contact({1, 1, 1.5}, impact, 0, 8, true), "until = 0: must be finite and > 0");
  CHECK_THROWS_WITH(follow_permanent_contact({1, 1, 1.5}, impact, 1, 0, true), "steps = 0: must be in [1, 10000]");
}
