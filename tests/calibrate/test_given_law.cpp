#include <calibrate/given_law.hpp>
#include <catch2/catch.hpp>
#include <ricochet/collision/reach.hpp>
#include <rapidcheck.h>

#include <cmath>

using namespace ricochet;
using namespace ricochet::calibration;

TEST_CASE("what a calibrated law does is what was asked for", "[property]") {
  CHECK(rc::check("the forward question undoes the inverse one", [] {
    const auto all = LawKind::all();
    const LawKind law = all[*rc::gen::inRange<std::size_t>(0, all.size())];
    const auto end = law.ends().overlap && *rc::gen::arbitrary<bool>() ? ContactEnd::overlap : ContactEnd::force;
    const auto power = [](int low, int high) { return std::pow(10, *rc::gen::inRange(100 * low, 100 * high) / 100.0); };
    const Target target{power(-7, 0), *rc::gen::inRange(20, 1000) / 1000.0, {power(-3, 2), power(-9, 1)}};
    RC_PRE(target.en >= 1.001 * restitution_bound(law, end));
    const auto inverse = std::get<Calibration>(calibrate({law, end, target}, {.method = Method::direct}));
    const auto forward = std::get<Calibration>(answer(inverse.law, end, target.impact));
    RC_ASSERT(std::abs(forward.achieved.tcol / target.tcol - 1) <= 1e-10);
    RC_ASSERT(std::abs(forward.achieved.en / target.en - 1) <= 1e-10);
    RC_ASSERT(forward.request.target.tcol == forward.achieved.tcol);
  }));
}

TEST_CASE("a law whose bodies do not part is infeasible, and misuse is named") {
  const auto stuck = answer(Linear(3, 400), ContactEnd::overlap, {0.5, 1e-5});
  REQUIRE(std::holds_alternative<Infeasible>(stuck));
  CHECK(std::get<Infeasible>(stuck).quantity.empty());
  CHECK(std::holds_alternative<Infeasible>(answer(Fractional(1e3, 1, 1.2), ContactEnd::force, {0.5, 1e-5})));
  CHECK_THROWS_WITH(answer(Linear(3, 4), ContactEnd::force, {-1, 1e-5}), Catch::Contains("velocity = -1"));
  CHECK_THROWS_WITH(answer(Hysteretic(3, 4), ContactEnd::overlap, {1, 1e-5}), Catch::Contains("end = overlap"));
}

TEST_CASE("an elastic Hertzian contact has Hertz's force and depth") {
  // ζ = (5mv²/4k)^{2/5}, R = kζ^{3/2}.
  const auto found = std::get<Calibration>(answer(Tsuji(1e9, 0), ContactEnd::force, {0.5, 1e-5}));
  const double depth = std::pow(1.25 * 1e-5 * 0.25 / 1e9, 0.4);
  CHECK(found.achieved.en == Approx(1).epsilon(1e-11));
  CHECK(found.achieved.max_overlap == Approx(depth).epsilon(1e-11));
  CHECK(found.achieved.max_force == Approx(1e9 * std::pow(depth, 1.5)).epsilon(1e-11));
}
