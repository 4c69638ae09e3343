#include <calibrate/oblique_fit.hpp>
#include <ricochet/collision/reduction.hpp>

#include <catch2/catch.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <random>
#include <string_view>
#include <utility>

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

/// Of 5 mm at 3.9 m/s against a wall, without loss.
ObliqueFitRequest elastic() {
  ObliqueFitRequest of = request();
  of.normal = Linear(mass * std::pow(std::numbers::pi / tcol, 2), 0);
  return of;
}

std::vector<ObliqueMeasurement> at_angles(std::initializer_list<std::pair<double, double>> of, double sigma = 0) {
  std::vector<ObliqueMeasurement> all;
  for (const auto& [angle, et] : of)
    all.push_back({.normal_velocity = 3.9 * std::cos(angle * degree),
                   .tangential_velocity = 3.9 * std::sin(angle * degree),
                   .et = Observed{et, sigma}});
  return all;
}

bool told(const ObliqueFit& fit, std::string_view words) {
  return std::any_of(fit.findings.begin(), fit.findings.end(), [&](const auto& f) { return f.starts_with(words); });
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
  const ObliqueFit fit = fit_oblique(elastic(), at_angles({{1.84, 0.79344},
                                                           {3.703, 0.74533},
                                                           {9.496, 0.67257},
                                                           {20.012, 0.59691},
                                                           {30.127, 0.68756},
                                                           {39.382, 0.77148},
                                                           {49.694, 0.84761},
                                                           {60.02, 0.90142}}));
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

TEST_CASE("of springs that turn back once or twice the one that made three angles is found", "[oblique-fit]") {
  // By the collision itself, with en = 1, mu = 0.092, sqrt(k_t/m_t) tcol = 5.452, to six digits. A spring of 2.19 comes
  // within 0.0013.
  const ObliqueFit fit = fit_oblique(elastic(), at_angles({{18, 0.589299}, {20, 0.593122}, {22, 0.601390}}));
  CHECK(fit.mu == Approx(0.092).margin(1e-4));
  CHECK(fit.turn.value() == Approx(5.452).margin(1e-3));
  CHECK(fit.chi2 < 1e-11);
}

TEST_CASE("mu alone is not told where a spring fits far better, and springs that fit alike are all named",
          "[oblique-fit]") {
  // Made by mu = 0.0643, a turn of 4.933; sliding throughout leaves a chi2 of 273.
  const ObliqueFit fit = fit_oblique(elastic(), at_angles({{15, 0.5796}, {25, 0.7232}, {40, 0.8477}}, 0.002));
  CHECK(fit.mu == Approx(0.0643).margin(0.001));
  CHECK(fit.chi2 < 2.75 + 0.01);
  CHECK(fit.parameters.size() == 2);
  REQUIRE(fit.findings.size() == 1);
  CHECK(fit.findings[0].starts_with("another spring fits about as well: k_t/k = "));
  // Two standard errors: chi2 falls by 10 where sigma is 0.0105, by 2.7 where it is 0.02.
  const auto parameters = [](double sigma) {
    return fit_oblique(elastic(), at_angles({{15, 0.5796}, {25, 0.7232}, {40, 0.8477}}, sigma)).parameters.size();
  };
  CHECK(parameters(0.0105) == 2);
  CHECK(parameters(0.02) == 1);
}

TEST_CASE("an undamped contact fitted with a dashpot: beta0 at the end of its range, in words", "[oblique-fit]") {
  auto of = elastic();
  of.form = TangentialForm::linear;
  // Sticking with beta0 = 1: e_t = 1 - (2/7) (1 + 1) at every angle.
  const ObliqueFit fit = fit_oblique(of, at_angles({{10, 3.0 / 7}, {20, 3.0 / 7}, {30, 3.0 / 7}}));
  CHECK(fit.beta0 == Approx(0.999).epsilon(1e-6));
  CHECK(told(fit, "beta0 has run to 0.999"));
}

TEST_CASE("one slip of the pen among the impacts is named by its line", "[oblique-fit]") {
  auto data = sliding(0.092);
  data[2].line = 4;
  data[2].et->value -= 0.3;
  CHECK(told(fit_oblique(request(), data), "line 4: et = "));
}

TEST_CASE("what energy forbids is refused by line, noise is not", "[oblique-fit]") {
  const auto refused = [](std::size_t i, const auto& change, const char* words) {
    auto data = sliding(0.1);
    data[i].line = i + 2;
    change(data[i]);
    CHECK_THROWS_WITH(fit_oblique(request(), data), Catch::Contains(fmt::format("line {}: {}", i + 2, words)));
  };
  refused(
      1, [](auto& m) { m.et->value = 5.97; }, "et = 5.97: must be in [3/7, 1]");
  refused(
      1, [](auto& m) { m.et->value = 0.37; }, "et = 0.37");
  refused(
      2, [](auto& m) { m.spin->value *= -1; }, "spin = -");
  refused(
      2, [](auto& m) { m.spin->value = -1e-3; }, "spin = -0.001");
  refused(
      2, [](auto& m) { m.spin->value = 10 / 7.0 * 1.06 * m.tangential_velocity / radius; }, "spin = ");
  refused(
      3, [](auto& m) { m.rebound_angle = Observed{-0.2}; }, "rebound_angle = -11.");
  auto m = sliding(0.1).front();
  m.et->value = 1.04;
  CHECK_FALSE(impossible(request(), m));
  m.et = Observed{1.1, 0.04};
  CHECK_FALSE(impossible(request(), m));
  m.spin->value = 10 / 7.0 * 1.04 * m.tangential_velocity / radius;
  CHECK_FALSE(impossible(request(), m));
}

TEST_CASE("impacts of one angle do not tell two unknowns", "[oblique-fit]") {
  CHECK_THROWS_WITH(fit_oblique(elastic(), at_angles({{20, 0.6}, {20, 0.6}, {20, 0.6}})),
                    Catch::Contains("angles = 1"));
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
