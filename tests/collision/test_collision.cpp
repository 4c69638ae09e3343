#include <catch2/catch.hpp>
#include <ricochet/ricochet.hpp>

#include <cmath>
#include <utility>
#include <vector>

using namespace ricochet;

namespace {

constexpr Impact table_two{0.5, 7.06858e-6};

double relative(double value, double reference) { return std::abs(value / reference - 1); }

/// The two paths share nothing but the law, so their difference bounds the error of both.
template <class Law>
void check_paths_agree(const Law& law, ContactEnd end, double bound = 1e-11) {
  const auto closed = collide(law, table_two, {end, CollideMethod::closed_form});
  const auto numerical = collide(law, table_two, {end, CollideMethod::numerical});
  REQUIRE(closed.separated());
  REQUIRE(numerical.status == closed.status);
  CHECK(closed.evaluations == 0);
  CHECK(numerical.evaluations > 0);
  CHECK(relative(numerical.tcol, closed.tcol) < bound);
  CHECK(relative(numerical.en, closed.en) < bound);
  CHECK(relative(numerical.max_overlap, closed.max_overlap) < 1e-11);
  CHECK(relative(numerical.max_force, closed.max_force) < 1e-11);
  // An extreme's place is where a derivative vanishes: half the digits would be expected of a search for the greatest
  // value, all of them of a search for the derivative's zero.
  CHECK(relative(numerical.time_max_overlap, closed.time_max_overlap) < bound);
  CHECK(std::abs(numerical.time_max_force - closed.time_max_force) < 1e-11 * closed.tcol);
  CHECK(std::abs(numerical.overlap_end - closed.overlap_end) < 1e-11 * closed.max_overlap);
}

}  // namespace

TEST_CASE("linear: closed form and integration agree in every damping regime, across the critical one") {
  const double k = 5000, critical = 2 * std::sqrt(k * table_two.mass_eff);
  for (const double ratio :
       {0.0, 1e-9, 0.01, 0.2, 0.5, 0.9, 1 - 1e-9, 1.0, 1 + 1e-9, 1.1, 2.5, 5.0, 1e4, 1e5, 1e6, 1e20, 1e90}) {
    CAPTURE(ratio);
    check_paths_agree(Linear(k, ratio * critical), ContactEnd::force);
  }
  for (const double ratio : {0.0, 1e-9, 0.5, 0.85, 0.9, 0.99, 0.999, 0.9999}) {
    CAPTURE(ratio);
    const double loss = std::acos(-1.0) * ratio / std::sqrt((1 - ratio) * (1 + ratio));
    check_paths_agree(Linear(k, ratio * critical), ContactEnd::overlap, 1e-11 + 1e-16 * loss * loss * loss);
  }
}

TEST_CASE("linear: both ends lose the same share of the velocity as exp(-c tcol / 2m)") {
  const Linear law(5000, 0.1);
  for (const auto end : {ContactEnd::force, ContactEnd::overlap}) {
    const auto out = collide(law, table_two, {end});
    CHECK(relative(out.en, std::exp(-law.c() * out.tcol / (2 * table_two.mass_eff))) < 1e-14);
  }
}

TEST_CASE("linear, tsuji: an overdamped overlap never returns to zero, and every path says so at once") {
  const auto check = [](const AnyLaw& law, CollideMethod method) {
    const auto out = collide(law, {1, 1}, {ContactEnd::overlap, method});
    CHECK(out.status == CollisionStatus::no_separation);
    CHECK(out.tcol == 0);
    CHECK(out.en == 0);
    CHECK(out.max_overlap > 0);
    CHECK(out.evaluations < 20'000);
  };
  for (const double ratio : {1.0, 1.01, 2.0, 39.0, 60.0, 1e5})
    for (const auto method : {CollideMethod::automatic, CollideMethod::numerical}) {
      CAPTURE(ratio);
      check(Linear(1, 2 * ratio), method);
      check(Tsuji(1, std::sqrt(5.0) * ratio * (1 + 1e-15)), method);
    }
}

TEST_CASE("past the range of a double a collision is out of range, not wrong") {
  const auto status = [](const AnyLaw& law, ContactEnd end, CollideMethod method) {
    return collide(law, {1, 1}, {end, method}).status;
  };
  const auto numerical = CollideMethod::numerical;
  CHECK(status(Linear(1, 1e140), ContactEnd::force, numerical) == CollisionStatus::out_of_range);
  CHECK(status(Linear(1, 2 * (1 - 1e-10)), ContactEnd::overlap, CollideMethod::automatic) ==
        CollisionStatus::out_of_range);
  for (const double ratio : {1 - 1e-5, 1 - 1e-8, 1 - 1e-12}) {
    CHECK(status(Linear(1, 2 * ratio), ContactEnd::overlap, numerical) == CollisionStatus::out_of_range);
    CHECK(status(Tsuji(1, std::sqrt(5.0) * ratio), ContactEnd::overlap, numerical) == CollisionStatus::out_of_range);
  }
  for (const double alpha : {1 - 1e-12, 1 - 1e-15})
    CHECK(status(Fractional(1, 1, alpha), ContactEnd::force, numerical) == CollisionStatus::out_of_range);
}

TEST_CASE("hysteretic: closed form and integration agree, at both ends") {
  for (const double stiffening : {1.0, 1.2, 1.9}) {
    CAPTURE(stiffening);
    check_paths_agree(Hysteretic(3924, 3924 * stiffening), ContactEnd::force);
    check_paths_agree(Hysteretic(3924, 3924 * stiffening), ContactEnd::overlap);
  }
  check_paths_agree(Hysteretic(3924, 4 * 3924), ContactEnd::force);
  for (const double stiffening : {1e4, 5e8, 1e9, 1e10, 1e30, 1e200})
    check_paths_agree(Hysteretic(3924, stiffening * 3924), ContactEnd::force);
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

TEST_CASE("fractional: close to where no contact ends, both paths agree as far as their bounds say") {
  for (const double gap : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-9, 1e-10}) {
    CAPTURE(gap);
    const double en = fractional_contact(1 - gap).en;
    check_paths_agree(Fractional(5000, 0.1, 1 - gap), ContactEnd::force, 1e-11 + 1e-16 / gap + 1e-14 / en);
  }
  for (const double gap : {1e-3, 1e-5, 1e-7, 1e-9}) {
    CAPTURE(gap);
    const double en = fractional_contact(overlap_limit - gap, ContactEnd::overlap).en;
    check_paths_agree(Fractional(5000, 0.1, overlap_limit - gap), ContactEnd::overlap, 1e-11 + 1e-15 / (en * en));
  }
}

TEST_CASE("fractional: what never separates is a status on both paths") {
  for (const auto method : {CollideMethod::closed_form, CollideMethod::numerical}) {
    for (const double alpha : {1 - 1.2e-16, 1.0, 1.5})
      for (const auto end : {ContactEnd::force, ContactEnd::overlap}) {
        const auto out = collide(Fractional(5000, 0.1, alpha), table_two, {end, method});
        CHECK(out.status == CollisionStatus::permanent_contact);
        CHECK_FALSE(out.separated());
        CHECK(out.en == 0);
      }
    CHECK(collide(Fractional(5000, 0.1, 0.401), table_two, {ContactEnd::overlap, method}).status ==
          CollisionStatus::no_separation);
  }
}

TEST_CASE("fractional: below alpha = 0 the overlap ends the collision, sooner and faster the smaller alpha") {
  double last = collide(Fractional(5000, 0.1, 0), table_two).tcol;
  for (const double alpha : {-1e-6, -0.1, -0.25, -0.5, -0.75, -1.0}) {
    CAPTURE(alpha);
    const Fractional law(5000, 0.1, alpha);
    for (const auto end : {ContactEnd::force, ContactEnd::overlap}) {
      check_paths_agree(law, end);
      const Collision out = collide(law, table_two, {end});
      CHECK(out.status == CollisionStatus::ended_by_overlap);
      CHECK(out.en > 1);
      CHECK(out.overlap_end == 0);
      if (end == ContactEnd::force) CHECK(out.tcol < std::exchange(last, out.tcol));
    }
  }
  CHECK_THROWS_WITH(collide(Fractional(5000, 0.1, -1.5), table_two),
                    "alpha = -1.5: must be in [-1, 2) for a collision");
}

TEST_CASE("fractional: a dashpot comes to rest where 1 % of its speed is left") {
  const double c = 0.1, time = table_two.mass_eff / c;
  const Collision out = collide(Fractional(5000, c, 1), table_two);
  CHECK(relative(out.tcol, time * std::log(100)) < 1e-12);
  CHECK(relative(out.overlap_end, 0.99 * table_two.velocity * time) < 1e-12);
  CHECK(out.max_overlap == out.overlap_end);
  CHECK(relative(out.max_force, c * table_two.velocity) < 1e-14);
  CHECK(out.time_max_force == 0);
  // As if nobody knew the law: by the steps of its one dashpot.
  const FractionalArms arms(Fractional(5000, c, 1), memory_kernel(1, 1e-7, 1e-3, 1e-6), 1e-7);
  const Collision generic = collide<FractionalArms>(arms, table_two);
  CHECK(generic.status == CollisionStatus::permanent_contact);
  CHECK(relative(generic.tcol, out.tcol) < 1e-3);
  CHECK(relative(generic.overlap_end, out.overlap_end) < 1e-3);
}

TEST_CASE("fractional: past alpha = 1 the motion comes to rest as its Volterra equation says") {
  // v = v₀ − A I^a v, a = 2 − α, by the product trapezoid over the whole collision.
  const auto out = [](double alpha) { return collide(Fractional(1, 1, alpha), {1, 1}); };
  {
    // a = 1/2: v = exp(t) erfc(√t), far out by its asymptotic series.
    const double t = out(1.5).tcol;
    CHECK((1 - 1 / (2 * t) + 3 / (4 * t * t) - 15 / (8 * t * t * t)) / std::sqrt(std::acos(-1.0) * t) ==
          Approx(0.01).epsilon(1e-12));
  }
  const Collision rest = out(1.2);
  constexpr std::size_t steps = 4000;
  const double h = rest.tcol / steps;
  const ConvolutionRule rule = trapezoid_integral(0.8, h, steps);
  std::vector<double> v{1};
  double overlap = 0;
  for (std::size_t n = 1; n <= steps; ++n) {
    v.push_back(0);
    v.back() = (1 - rule.last(v)) / (1 + rule.weights()[0]);
    overlap += 0.5 * h * (v[n - 1] + v[n]);
  }
  // The rate starts like 1 − t^a, so the first steps err by h^a; what is left of that at the end is of order h^{1+a}.
  CHECK(v.back() == Approx(0.01).epsilon(2 * std::pow(h, 1.8)));
  CHECK(overlap == Approx(rest.overlap_end).epsilon(2 * std::pow(h, 1.8)));
  CHECK(rest.max_force == 0);  // it begins infinite
}

TEST_CASE("what the contact can take up decides between permanent contact and breakage") {
  const double energy = 0.5 * table_two.mass_eff * table_two.velocity * table_two.velocity;
  const auto status = [&](double alpha, double share) {
    return collide(Fractional(5000, 0.1, alpha), table_two, {.breakage_energy = share * energy}).status;
  };
  for (const double alpha : {1.0, 1.6}) {
    CHECK(status(alpha, 1 - 1.01e-4) == CollisionStatus::breakage);  // 1e-4 of it is still motion
    CHECK(status(alpha, 1 - 0.99e-4) == CollisionStatus::permanent_contact);
  }
  CHECK(status(0.5, 0) == CollisionStatus::ended_by_force);  // bodies that part do not break
  CHECK_THROWS_WITH(status(1, -1), Catch::EndsWith("must be >= 0"));
}

TEST_CASE("any law collides as the law it holds") {
  const AnyLaw any = Tsuji(1e6, 10);
  CHECK(collide(any, table_two).tcol == collide(Tsuji(1e6, 10), table_two).tcol);
}
