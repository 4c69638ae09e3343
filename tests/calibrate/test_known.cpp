#include <calibrate/known.hpp>
#include <catch2/catch.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <cmath>
#include <numbers>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

Calibration calibrated(LawKind law, ContactEnd end, const Known& known) {
  const auto outcome = calibrate(law, end, known);
  REQUIRE(std::holds_alternative<Calibration>(outcome));
  return std::get<Calibration>(outcome);
}

double sphere(double radius, double density) { return 4 * std::numbers::pi / 3 * radius * radius * radius * density; }

}  // namespace

TEST_CASE("two equal spheres of known moduli under Tsuji's law ended by overlap") {
  // k = (4/3) E* √R, c = β √(5 m k) with β = L/√(π² + L²), L = −ln 0.3, by hand to the digits given.
  const Impact impact{0.5, sphere(2.5e-3, 890) / 2};
  const scale::Moduli moduli{{1e7, 0.33}, {1e7, 0.33}, 1.25e-3};
  const auto found = calibrated(kind_of<Tsuji>, ContactEnd::overlap, {moduli, loss::Restitution{0.3}, impact});
  CHECK(values(found.law)[0] == Approx(264507.08).epsilon(0).margin(5e-3));
  CHECK(values(found.law)[1] == Approx(2.2209954).epsilon(0).margin(5e-8));
}

TEST_CASE("a stiffness is that law's own, and the fractional law holds it") {
  const Impact impact{0.5, 7.06858e-6};
  for (const LawKind law : LawKind::all()) {
    CAPTURE(law.name());
    const auto found = calibrated(law, ContactEnd::force, {scale::Stiffness{4000}, loss::Restitution{0.6}, impact});
    CHECK(values(found.law)[0] == Approx(4000).epsilon(1e-10));
    CHECK(found.achieved.en == Approx(0.6).epsilon(std::max(1e-10, numerical_error(law, ContactEnd::force, 0.6))));
  }
  // Not what its t_col and e_n give again, which rounding changes: the number itself.
  const Known known{scale::Stiffness{4000}, loss::Restitution{0.6}, impact};
  const auto held = std::get<Request>(request_of(kind_of<Fractional>, ContactEnd::force, known)).stiffness;
  CHECK(held.value() == 4000);
  // Linear and fractional have the same t_col then.
  const auto time = [&](LawKind law) {
    return std::get<Request>(request_of(law, ContactEnd::force, known)).target.tcol;
  };
  CHECK(time(kind_of<Linear>) == time(kind_of<Fractional>));
}

TEST_CASE("a greatest overlap is that of the damped collision") {
  const Impact impact{0.5, 7.06858e-6};
  for (const LawKind law : LawKind::all()) {
    const auto found = calibrated(law, ContactEnd::force, {scale::MaxOverlap{1e-5}, loss::Restitution{0.6}, impact});
    // What is achieved is told by the numerical collision.
    CHECK(found.achieved.max_overlap ==
          Approx(1e-5).epsilon(std::max(1e-9, numerical_error(law, ContactEnd::force, 0.6))));
  }
}

TEST_CASE("the loss factor is the fractional law's alpha") {
  const auto found =
      calibrated(kind_of<Fractional>, ContactEnd::force,
                 {scale::CollisionTime{1e-4}, loss::LossFactor{std::tan(0.15 * std::numbers::pi)}, {0.5, 7.06858e-6}});
  CHECK(std::get<Fractional>(found.law).alpha() == Approx(0.3).epsilon(1e-11));
}

TEST_CASE("a loss that a law cannot have is infeasible, with its range") {
  const Impact impact{0.5, 7.06858e-6};
  const auto outcome =
      calibrate(kind_of<Tsuji>, ContactEnd::overlap, {scale::CollisionTime{1e-4}, loss::DampingRatio{1.5}, impact});
  REQUIRE(std::holds_alternative<Infeasible>(outcome));
  const auto& missed = std::get<Infeasible>(outcome);
  CHECK(missed.quantity == "damping_ratio");
  CHECK(missed.asked == 1.5);
  CHECK(missed.highest == 1);
  // So little that no law carries it: the range is of e_n.
  const auto tiny =
      calibrate(kind_of<Linear>, ContactEnd::overlap, {scale::Stiffness{1e3}, loss::Restitution{1e-300}, impact});
  CHECK(std::holds_alternative<Infeasible>(tiny));
}

TEST_CASE("a scale out of all range is named by what was given") {
  CHECK_THROWS_WITH(
      calibrate(kind_of<Linear>, ContactEnd::force, {scale::MaxOverlap{1e40}, loss::Restitution{0.5}, {1e-30, 1}}),
      Catch::StartsWith("max_overlap"));
}

TEST_CASE("the tables give the same requests as the slow way") {
  const DirectCalibrator quick;
  const Impact impact{0.7, 3e-5};
  for (const LawKind law : LawKind::all())
    for (const double en : {0.3, 0.97, 1.0})
      for (const Scale& scale : {Scale(scale::Stiffness{4e4}), Scale(scale::MaxOverlap{1e-5}),
                                 Scale(scale::Moduli{{1e8, 0.3}, {2e9, 0.2}, 1e-3})}) {
        CAPTURE(law.name(), en, name(scale));
        const Known known{scale, loss::Restitution{en}, impact, {.alpha = 0.7, .stiffening = 1000}};  // reach 0.3
        const auto one = std::get<Request>(request_of(law, ContactEnd::force, known));
        const auto other = std::get<Request>(request_of(law, ContactEnd::force, known, quick));
        CHECK(other.target.tcol == Approx(one.target.tcol).epsilon(1e-10));
        CHECK(other.target.en == one.target.en);
        CHECK(other.stiffness == one.stiffness);
      }
}
