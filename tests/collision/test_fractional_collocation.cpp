#include "reference_contacts.hpp"

#include <catch2/catch.hpp>
#include <ricochet/collision/fractional_collocation.hpp>

#include <cmath>

using namespace ricochet;

TEST_CASE("24 collocation nodes reproduce the tabulated fractional contacts to 1e-10") {
  const auto table = reference_contacts();
  CHECK(table.size() == 12);
  for (const FractionalContact& r : table) {
    INFO("alpha = " << r.alpha);
    const FractionalSolution s = collocate_collision(r.alpha, 24);
    REQUIRE(s.separated());
    CHECK(std::abs(s.tcol / r.tau - 1) < 1e-10);
    CHECK(std::abs(s.en / r.en - 1) < 1e-10);
    CHECK(std::abs(s.overlap_end / r.tau - r.overlap_end) < 1e-10 * r.max_overlap);
    CHECK(std::abs(s.time_max_overlap / r.tau / r.t_max_overlap - 1) < 1e-10);
    CHECK(std::abs(s.max_overlap / r.tau / r.max_overlap - 1) < 1e-10);
    CHECK(s.solves == 1);
  }
}

TEST_CASE("collocation knows which collisions do not end") {
  CHECK_FALSE(collocate_collision(1).separated());
  CHECK_FALSE(collocate_collision(1.5).separated());
  CHECK(collocate_collision(0.4008, 40, ContactEnd::overlap).separated());
  CHECK_FALSE(collocate_collision(0.401, 40, ContactEnd::overlap).separated());
  CHECK_THROWS_WITH(collocate_collision(2), "alpha = 2: must be in [-1, 2)");
  CHECK_THROWS_WITH(collocate_collision(0.5, 3), "nodes = 3: must be in 4...120");
}

TEST_CASE("collocation of the elastic spring is the half sine") {
  const FractionalSolution s = collocate_collision(0, 24);
  CHECK(s.tcol == Approx(3.14159265358979323846).epsilon(1e-14));
  CHECK(s.en == Approx(1).epsilon(1e-13));
  CHECK(s.max_force == Approx(1).epsilon(1e-13));
  CHECK(s.max_overlap == Approx(1).epsilon(1e-13));
}
