#include <calibrate/oblique_fit.hpp>
#include <ricochet/collision/reduction.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <random>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

constexpr double degree = std::numbers::pi / 180, tcol = 1e-5, en = 0.9, mass = 2.6e-4, radius = 2.5e-3;

ObliqueFitRequest request(TangentialForm form = TangentialForm::undamped) {
  return {.form = form,
          .normal = at_impact(unit_law(kind_of<Linear>, en, ContactEnd::force)->law, tcol, {3.9, mass}).value(),
          .tcol = tcol,
          .mass_eff = mass,
          .radius = radius};
}

/// What slides throughout, in closed form: v_t' = v_t − μ(1+e_n)v_n, ω r = (5/2) μ(1+e_n)v_n.
std::vector<ObliqueMeasurement> sliding(double mu, double noise = 0, double sigma = 0) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0, 1);
  std::vector<ObliqueMeasurement> all;
  for (const double angle : {50.0, 60.0, 70.0, 75.0, 80.0}) {
    const double vn = 3.9 * std::cos(angle * degree), vt = 3.9 * std::sin(angle * degree), dv = mu * (1 + en) * vn;
    all.push_back({.normal_velocity = vn,
                   .tangential_velocity = vt,
                   .et = Observed{1 - dv / vt + noise * normal(random), sigma},
                   .spin = Observed{2.5 * dv / radius * (1 + noise * normal(random)), 1e3 * sigma}});
  }
  return all;
}

/// With what is sought, from 2° to 80°, by the collision itself.
std::vector<ObliqueMeasurement> made(const ObliqueFitRequest& of, double mu, double beta0, double sigma,
                                     unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, sigma);
  const auto found = std::get<TangentialCalibration>(
      calibrate_tangential({.form = of.form, .beta0 = beta0}, of.normal, of.end, {of.tcol, en, {3.9, mass}}));
  std::vector<ObliqueMeasurement> all;
  for (const double angle : {2.0, 5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0}) {
    const double vn = 3.9 * std::cos(angle * degree);
    const std::array angles{angle * degree};
    const auto r = rebounds(found.law, mu, of.normal, of.end, {vn, mass}, angles)[0];
    ObliqueMeasurement m{.normal_velocity = vn, .tangential_velocity = vn * std::tan(angle * degree)};
    if (all.size() % 2)
      m.rebound_angle = Observed{r.rebound_angle + normal(random), sigma};
    else
      m.et = Observed{r.et + normal(random), sigma};
    all.push_back(m);
  }
  return all;
}

}  // namespace

TEST_CASE("oblique data give back the mu and beta0 that made them, in any mix of quantities", "[oblique-fit]") {
  for (const auto form : {TangentialForm::linear, TangentialForm::undamped}) {
    const auto of = request(form);
    const double beta0 = form == TangentialForm::linear ? 0.6 : -0.26;
    const ObliqueFit fit = fit_oblique(of, made(of, 0.1, beta0, 0, 1));
    CHECK(fit.mu == Approx(0.1).epsilon(1e-6));
    CHECK(fit.beta0 == Approx(beta0).margin(1e-5));
    CHECK(fit.parameters.size() == 2);
  }
}

TEST_CASE("the measured grains of Kharaz, Gorham and Salman: mu and k_t near what Di Renzo and Di Maio took",
          "[oblique-fit]") {
  // e_t at 5 mm, 3.9 m/s; their k_t/k_n = 0.86 and mu = 0.092 give 0.806, 0.593, 0.781 at 5, 20, 40 degrees.
  ObliqueFitRequest of = request();
  of.normal = Linear(of.mass_eff * std::pow(std::numbers::pi / tcol, 2), 0);
  std::vector<ObliqueMeasurement> data;
  for (const auto& [angle, et] : {std::pair(1.84, 0.79344),
                                  {3.703, 0.74533},
                                  {9.496, 0.67257},
                                  {20.012, 0.59691},
                                  {30.127, 0.68756},
                                  {39.382, 0.77148},
                                  {49.694, 0.84761},
                                  {60.02, 0.90142}})
    data.push_back({.normal_velocity = 3.9 * std::cos(angle * degree),
                    .tangential_velocity = 3.9 * std::sin(angle * degree),
                    .et = Observed{et}});
  const ObliqueFit fit = fit_oblique(of, data);
  CHECK(fit.mu == Approx(0.092).margin(0.01));
  CHECK(fit.turn.value() > std::numbers::pi);
  CHECK(fit.parameters[0].error < 0.01);
}

TEST_CASE("the stated errors hold the truth about as often as they say", "[oblique-fit]") {
  const auto of = request();
  int held_mu = 0, held_beta = 0;
  constexpr int times = 6;
  for (unsigned seed = 0; seed < times; ++seed) {
    const ObliqueFit fit = fit_oblique(of, made(of, 0.1, -0.2, 0.005, seed));
    held_mu += std::abs(fit.parameters[0].value - 0.1) < 2 * fit.parameters[0].error;
    held_beta += std::abs(fit.parameters[1].value - std::acos(0.2)) < 2 * fit.parameters[1].error;
  }
  // 95.4 % of 6, and 3 or fewer come once in seven hundred.
  CHECK(held_mu >= 4);
  CHECK(held_beta >= 4);
}

TEST_CASE("impacts that all slide tell mu, by its closed form, and say that beta0 is not told", "[oblique-fit]") {
  const ObliqueFit exact = fit_oblique(request(), sliding(0.092));
  // The spring holds at the first touch, where the damped linear law begins with R = c v_n: thousandths of the impulse.
  CHECK(exact.mu == Approx(0.092).epsilon(2e-3));
  REQUIRE(exact.parameters.size() == 1);
  CHECK(exact.parameters[0].name == "mu");
  CHECK(exact.findings.front().starts_with("every impact slides throughout"));
  const ObliqueFit noisy = fit_oblique(request(), sliding(0.092, 0.003));
  CHECK(std::abs(noisy.mu - 0.092) < 4 * noisy.parameters[0].error);
  CHECK(noisy.parameters[0].error > 0);
}

TEST_CASE("oblique data that are none", "[oblique-fit]") {
  auto of = request();
  auto data = sliding(0.1);
  data.front().et->sigma = 0.1;
  CHECK_THROWS_WITH(fit_oblique(of, data), Catch::Contains("for every number or for none"));
  of.radius = 0;
  CHECK_THROWS_WITH(fit_oblique(of, sliding(0.1)), Catch::Contains("radius"));
  CHECK_THROWS_WITH(fit_oblique(request(), {{.normal_velocity = 1, .tangential_velocity = 1, .et = Observed{0.5}}}),
                    Catch::Contains("observations"));
  of = request(TangentialForm::mindlin);
  CHECK_THROWS_AS(fit_oblique(of, sliding(0.1)), std::invalid_argument);
}
