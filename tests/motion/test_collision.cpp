#include <catch2/catch.hpp>
#include <ricochet/ricochet.hpp>

#include <cmath>
#include <vector>

using namespace ricochet;

namespace {

constexpr Impact table_two{0.5, 7.06858e-6};

double relative(double value, double reference) { return std::abs(value / reference - 1); }

/// The two paths share nothing but the law, so their difference bounds the error of both.
template <class Law>
void check_paths_agree(const Law& law, ContactEnd end) {
  const auto closed = collide(law, table_two, {end, CollideMethod::closed_form});
  const auto numerical = collide(law, table_two, {end, CollideMethod::numerical});
  REQUIRE(closed.separated());
  REQUIRE(numerical.status == closed.status);
  CHECK(closed.evaluations == 0);
  CHECK(numerical.evaluations > 0);
  CHECK(relative(numerical.tcol, closed.tcol) < 1e-11);
  CHECK(relative(numerical.en, closed.en) < 1e-11);
  CHECK(relative(numerical.max_overlap, closed.max_overlap) < 1e-11);
  CHECK(relative(numerical.max_force, closed.max_force) < 1e-11);
  // An extreme's place is where a derivative vanishes: half the digits would be expected of a search for the greatest
  // value, all of them of a search for the derivative's zero.
  CHECK(relative(numerical.time_max_overlap, closed.time_max_overlap) < 1e-11);
  CHECK(std::abs(numerical.time_max_force - closed.time_max_force) < 1e-11 * closed.tcol);
  CHECK(std::abs(numerical.overlap_end - closed.overlap_end) < 1e-11 * closed.max_overlap);
}

}  // namespace

TEST_CASE("linear: closed form and integration agree in every damping regime, across the critical one") {
  const double k = 5000, critical = 2 * std::sqrt(k * table_two.mass_eff);
  for (const double ratio : {0.0, 1e-9, 0.01, 0.2, 0.5, 0.9, 1 - 1e-9, 1.0, 1 + 1e-9, 1.1, 2.5, 5.0}) {
    CAPTURE(ratio);
    const Linear law(k, ratio * critical);
    check_paths_agree(law, ContactEnd::force);
    if (ratio < 0.85) check_paths_agree(law, ContactEnd::overlap);
  }
}

TEST_CASE("linear: both ends lose the same share of the velocity as exp(-c tcol / 2m)") {
  const Linear law(5000, 0.1);
  for (const auto end : {ContactEnd::force, ContactEnd::overlap}) {
    const auto out = collide(law, table_two, {end});
    CHECK(relative(out.en, std::exp(-law.c() * out.tcol / (2 * table_two.mass_eff))) < 1e-14);
  }
}

TEST_CASE("linear: an overdamped overlap never returns to zero, and both paths say so") {
  const Linear law(5000, 1.01 * 2 * std::sqrt(5000 * table_two.mass_eff));
  for (const auto method : {CollideMethod::closed_form, CollideMethod::numerical}) {
    const auto out = collide(law, table_two, {ContactEnd::overlap, method});
    CHECK(out.status == CollisionStatus::no_separation);
    CHECK(out.tcol == 0);
    CHECK(out.en == 0);
    CHECK(out.max_overlap > 0);
  }
}

TEST_CASE("hysteretic: closed form and integration agree, at both ends") {
  for (const double stiffening : {1.0, 1.2, 1.9}) {
    CAPTURE(stiffening);
    check_paths_agree(Hysteretic(3924, 3924 * stiffening), ContactEnd::force);
    check_paths_agree(Hysteretic(3924, 3924 * stiffening), ContactEnd::overlap);
  }
  check_paths_agree(Hysteretic(3924, 4 * 3924), ContactEnd::force);
  check_paths_agree(Hysteretic(3924, 1e4 * 3924), ContactEnd::force);
}

TEST_CASE("hysteretic: an overlap that swings about a positive rest never ends by overlap") {
  for (const auto method : {CollideMethod::closed_form, CollideMethod::numerical})
    CHECK(collide(Hysteretic(1000, 2500), table_two, {ContactEnd::overlap, method}).status ==
          CollisionStatus::no_separation);
}

TEST_CASE("fractional: Mittag-Leffler closed form and collocation agree, at both ends") {
  for (const double alpha : {0.0, 1e-6, 0.02, 0.2, 0.32, 0.4, 0.6, 0.9, 0.97}) {
    CAPTURE(alpha);
    const Fractional law(5000, 0.1, alpha);
    check_paths_agree(law, ContactEnd::force);
    if (alpha < 0.4) check_paths_agree(law, ContactEnd::overlap);
  }
}

TEST_CASE("fractional: what never separates is a status on both paths") {
  for (const auto method : {CollideMethod::closed_form, CollideMethod::numerical}) {
    for (const double alpha : {1.0, 1.5})
      CHECK(collide(Fractional(5000, 0.1, alpha), table_two, {ContactEnd::force, method}).status ==
            CollisionStatus::no_separation);
    CHECK(collide(Fractional(5000, 0.1, 0.401), table_two, {ContactEnd::overlap, method}).status ==
          CollisionStatus::no_separation);
  }
}

TEST_CASE("fractional: below alpha = 0 the collision gains speed") {
  CHECK(collide(Fractional(5000, 0.1, -0.1), table_two).en > 1);
  CHECK_THROWS_WITH(collide(Fractional(5000, 0.1, -0.1), table_two, {ContactEnd::force, CollideMethod::closed_form}),
                    "alpha = -0.1: must be >= 0 for the closed form");
}

TEST_CASE("any law collides as the law it holds") {
  const AnyLaw any = Tsuji(1e6, 10);
  CHECK(collide(any, table_two).tcol == collide(Tsuji(1e6, 10), table_two).tcol);
}
