#include <calibrate/calibration.hpp>
#include "../../calibrate/src/confirmation.hpp"

#include <catch2/catch.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

constexpr Impact table_two{0.5, 7.06858e-6};

struct Case {
  LawKind law;
  ContactEnd end;
};
constexpr Case all_cases[] = {{kind_of<Linear>, ContactEnd::overlap},     {kind_of<Linear>, ContactEnd::force},
                              {kind_of<KuwabaraKono>, ContactEnd::force}, {kind_of<Tsuji>, ContactEnd::overlap},
                              {kind_of<Tsuji>, ContactEnd::force},        {kind_of<Hysteretic>, ContactEnd::force},
                              {kind_of<Fractional>, ContactEnd::overlap}, {kind_of<Fractional>, ContactEnd::force}};

Calibration calibrated(const Case& c, double tcol, double en, const Settings& settings = {}) {
  const auto outcome = calibrate({c.law, c.end, {tcol, en, table_two}}, settings);
  REQUIRE(std::holds_alternative<Calibration>(outcome));
  return std::get<Calibration>(outcome);
}

Infeasible missed(const Request& request, const Settings& settings = {}) {
  const auto outcome = calibrate(request, settings);
  REQUIRE(std::holds_alternative<Infeasible>(outcome));
  return std::get<Infeasible>(outcome);
}

std::map<std::string, double> named_values(const AnyLaw& law) {
  std::map<std::string, double> all;
  for (const auto& p : parameters(law)) all[p.name] = p.value;
  return all;
}

}  // namespace

TEST_CASE("both methods hit the target and agree, for every law and end, over the whole range of targets") {
  for (const auto& c : all_cases)
    for (const double tcol : {1e-12, 1e-4, 1e3})
      for (const double en : {0.01, 0.1, 0.5, 0.9, 0.99, 0.9999}) {
        CAPTURE(c.law.name(), text(c.end), tcol, en);
        const auto result = calibrated(c, tcol, en);
        CHECK(std::abs(result.tcol_residual) <= 1e-10);
        CHECK(std::abs(result.en_residual) <= 1e-10);
        CHECK(result.cross_difference <= 1e-8);
        CHECK(result.method == Method::nlopt);
        CHECK(result.cross_method == Method::direct);
      }
}

TEST_CASE("the direct method answers with the same law") {
  for (const auto& c : all_cases) {
    CAPTURE(c.law.name(), text(c.end));
    const auto searched = named_values(calibrated(c, 1e-4, 0.5).law);
    const auto reduced = named_values(calibrated(c, 1e-4, 0.5, {.method = Method::direct}).law);
    for (const auto& [name, value] : reduced) CHECK(searched.at(name) == Approx(value).epsilon(1e-8));
  }
}

TEST_CASE("linear and hysteretic parameters are those of their formulas") {
  const double m = table_two.mass_eff, t = 1e-4, e = 0.3, loss = -std::log(e), pi = std::numbers::pi;
  const auto linear1 = named_values(calibrated({kind_of<Linear>, ContactEnd::overlap}, t, e).law);
  CHECK(linear1.at("c") == Approx(2 * m * loss / t).epsilon(1e-10));
  CHECK(linear1.at("k") == Approx(m * (pi * pi + loss * loss) / (t * t)).epsilon(1e-10));
  const auto linear2 = named_values(calibrated({kind_of<Linear>, ContactEnd::force}, t, e).law);
  CHECK(linear2.at("c") == Approx(2 * m * loss / t).epsilon(1e-10));
  const auto hysteretic = named_values(calibrated({kind_of<Hysteretic>, ContactEnd::force}, t, e).law);
  CHECK(hysteretic.at("k1") == Approx(m * std::pow(0.5 * pi * (1 + e) / t, 2)).epsilon(1e-10));
  CHECK(hysteretic.at("k1") / hysteretic.at("k2") == Approx(e * e).epsilon(1e-10));
}

TEST_CASE("an elastic target is a spring without damping") {
  for (const auto& c : all_cases) {
    CAPTURE(c.law.name(), text(c.end));
    const auto law = named_values(calibrated(c, 1e-4, 1).law);
    if (c.law == kind_of<Hysteretic>) CHECK(law.at("k1") == law.at("k2"));
    if (c.law == kind_of<Fractional>) CHECK(law.at("alpha") == 0);
    if (c.law != kind_of<Hysteretic> && c.law != kind_of<Fractional>) CHECK(law.at("c") == 0);
  }
  const auto spring = named_values(calibrated({kind_of<Linear>, ContactEnd::force}, 1e-4, 1).law);
  CHECK(spring.at("k") == Approx(table_two.mass_eff * std::numbers::pi * std::numbers::pi / 1e-8).epsilon(1e-10));
}

TEST_CASE("the fractional law holds k, and another k changes neither alpha nor c^alpha k^(1-alpha)") {
  Request request{kind_of<Fractional>, ContactEnd::force, {1e-4, 0.5, table_two}};
  const auto held = std::get<Calibration>(calibrate(request));
  const auto linear2 = named_values(calibrated({kind_of<Linear>, ContactEnd::force}, 1e-4, 0.5).law);
  CHECK(named_values(held.law).at("k") == Approx(linear2.at("k")).epsilon(1e-10));
  request.stiffness = 5225;
  const auto other = std::get<Calibration>(calibrate(request));
  CHECK(named_values(other.law).at("k") == 5225);
  CHECK(named_values(other.law).at("c") == Approx(0.2964394).epsilon(1e-6));
  const auto one = identifiable(held.law), two = identifiable(other.law);
  REQUIRE(one.size() == 2);
  for (std::size_t i = 0; i < one.size(); ++i) CHECK(one[i].value == Approx(two[i].value).epsilon(1e-10));
  CHECK(two[0].value == Approx(conversion_degree(0.5)).epsilon(1e-10));
}

TEST_CASE("Eq. (57) goes with the end that it is about") {
  CHECK(calibrated({kind_of<Fractional>, ContactEnd::force}, 1e-4, 0.5).tcol_estimate.has_value());
  CHECK_FALSE(calibrated({kind_of<Fractional>, ContactEnd::overlap}, 1e-4, 0.5).tcol_estimate.has_value());
  CHECK_FALSE(calibrated({kind_of<Linear>, ContactEnd::force}, 1e-4, 0.5).tcol_estimate.has_value());
}

TEST_CASE("every offered algorithm reaches the tolerance on every law") {
  for (const auto& algorithm : algorithms())
    for (const auto& c : all_cases)
      for (const double en : {0.05, 0.5, 1.0}) {
        CAPTURE(algorithm, c.law.name(), text(c.end), en);
        const auto result = calibrated(c, 1e-4, en, {.algorithm = algorithm});
        CHECK(result.algorithm == algorithm);
        CHECK(result.cross_difference <= 1e-8);
      }
}

TEST_CASE("what cannot be reached comes with a range that can") {
  const Target target{1e-4, 1e-5, table_two};
  const auto out = missed({kind_of<Fractional>, ContactEnd::overlap, target});
  CHECK(out.quantity == "en");
  CHECK(out.asked == 1e-5);
  CHECK(out.lowest > 1e-5);
  CHECK(out.lowest < 0.01);
  CHECK(out.highest == 1);
  calibrated({kind_of<Fractional>, ContactEnd::overlap}, 1e-4, out.lowest);
}

TEST_CASE("a held k that no c can go with is infeasible, with the range of k") {
  const Target elastic{1e-4, 1, table_two};
  const auto spring = missed({kind_of<Fractional>, ContactEnd::force, elastic, 5000.0});
  CHECK(spring.quantity == "stiffness");
  CHECK(spring.lowest == spring.highest);
  CHECK(
      std::holds_alternative<Calibration>(calibrate({kind_of<Fractional>, ContactEnd::force, elastic, spring.lowest})));
  const Target nearly{1e-4, 0.9999, table_two};
  const auto narrow = missed({kind_of<Fractional>, ContactEnd::force, nearly, 4.0});
  CHECK(narrow.lowest > 4);
  for (const double k : {narrow.lowest * 1.0001, narrow.highest / 1.0001})
    CHECK(std::holds_alternative<Calibration>(calibrate({kind_of<Fractional>, ContactEnd::force, nearly, k})));
}

TEST_CASE("misuse names the value") {
  const auto with = [](Target target) { return Request{kind_of<Linear>, ContactEnd::force, target}; };
  CHECK_THROWS_WITH(calibrate(with({-1, 0.5, table_two})), "tcol = -1: must be in [1e-30, 1e30]");
  CHECK_THROWS_WITH(calibrate(with({1e-4, 1.5, table_two})), "en = 1.5: must be in (0, 1]");
  CHECK_THROWS_WITH(calibrate(with({1e-4, 0.5, {0.5, -1}})), "mass_eff = -1: must be in [1e-30, 1e30]");
  CHECK_THROWS_WITH(calibrate(with({1e-4, 0.5, table_two}), {.tolerance = 1e-20}),
                    "tolerance = 1e-20: must be in [1e-11, 0.1]");
  CHECK_THROWS_WITH(calibrate(with({1e-4, 0.5, table_two}), {.algorithm = "GN_ISRES"}),
                    Catch::Contains("algorithm = GN_ISRES: must be one of LN_BOBYQA"));
  CHECK_THROWS_WITH(calibrate({kind_of<Hysteretic>, ContactEnd::overlap, {1e-4, 0.5, table_two}}),
                    "end = overlap: must be force for the law hysteretic");
}

TEST_CASE("what a law reaches does not hang on the luck of the last digits") {
  const auto direct = Settings{.method = Method::direct};
  const auto reached = [&](LawKind law, ContactEnd end, double en) {
    CAPTURE(law.name(), text(end), en);
    const auto result = calibrated({law, end}, 1e-4, en, direct);
    CHECK((result.remarks.empty() || std::abs(result.en_residual) < 1e-6));
    CHECK(std::abs(result.tcol_residual) < 1e-6);
  };
  for (int i = 0; i < 40; ++i) reached(kind_of<Hysteretic>, ContactEnd::force, 0.0025 + 0.0001 * i);
  for (const double en : {1e-5, 1e-6, 1e-7, 3e-8, 1e-12, 1e-30}) {
    reached(kind_of<Hysteretic>, ContactEnd::force, en);
    reached(kind_of<Linear>, ContactEnd::force, en);
    reached(kind_of<Linear>, ContactEnd::overlap, en);
    reached(kind_of<Tsuji>, ContactEnd::force, en);
    reached(kind_of<KuwabaraKono>, ContactEnd::force, en);
  }
  for (const double en : {0.003, 1e-4, 1e-6}) reached(kind_of<Fractional>, ContactEnd::force, en);
}

TEST_CASE("the range that is named is reached to its last digit, and nothing below") {
  const double tolerance = 1e-10;
  for (const Case& c : {Case{kind_of<Fractional>, ContactEnd::overlap}, Case{kind_of<Fractional>, ContactEnd::force},
                        Case{kind_of<Linear>, ContactEnd::overlap}, Case{kind_of<Hysteretic>, ContactEnd::force}}) {
    CAPTURE(c.law.name(), text(c.end));
    const auto out =
        missed({c.law, c.end, {1e-4, 1e-310, table_two}}, {.method = Method::direct, .tolerance = tolerance});
    calibrated(c, 1e-4, out.lowest, {.method = Method::direct, .tolerance = tolerance});
    CHECK(std::holds_alternative<Infeasible>(calibrate({c.law, c.end, {1e-4, 0.98 * out.lowest, table_two}},
                                                       {.method = Method::direct, .tolerance = tolerance})));
  }
  // Of the fractional law by overlap, 1e-15/e_n² is the tolerance at 0.003162….
  CHECK(missed({kind_of<Fractional>, ContactEnd::overlap, {1e-4, 1e-3, table_two}}).lowest ==
        Approx(0.00317).epsilon(1e-12));
}

TEST_CASE("where the search misses the tolerance the direct solution is answered, and said to be") {
  const auto by_direct = [](const Case& c, double en, const Settings& settings) {
    CAPTURE(c.law.name(), en);
    const auto result = calibrated(c, 1e-4, en, settings);
    CHECK(std::abs(result.tcol_residual) <= 1e-10);
    CHECK(std::abs(result.en_residual) <= 1e-10);
    if (result.method == Method::nlopt) return false;
    CHECK(result.cross_method == Method::nlopt);
    CHECK_THAT(result.remarks.at(0), Catch::EndsWith("; the direct solution is answered"));
    return true;
  };
  // No step of a search is small enough for a k2/k1 past e^40.
  CHECK(by_direct({kind_of<Hysteretic>, ContactEnd::force}, 1e-9, {}));
  CHECK(calibrated({kind_of<Hysteretic>, ContactEnd::force}, 1e-4, 1e-9).remarks.at(0) ==
        "LN_BOBYQA missed the tolerance; the direct solution is answered");
  for (const auto& c : all_cases)
    if (c.law != kind_of<Fractional> || c.end != ContactEnd::overlap) by_direct(c, 0.002, {});
  for (const auto& c : all_cases) by_direct(c, 0.999999999999, {.algorithm = "LD_SLSQP"});
  const auto asked = calibrated({kind_of<Hysteretic>, ContactEnd::force}, 1e-4, 1e-9, {.method = Method::direct});
  CHECK(asked.remarks.at(0) == "the cross-check by LN_BOBYQA missed the tolerance");
}

namespace {

double greatest_difference(const Calibration& one, const Calibration& other) {
  const auto ours = identifiable(one.law), theirs = identifiable(other.law);
  double greatest = 0;
  for (std::size_t i = 0; i < ours.size(); ++i)
    greatest = std::max(greatest, std::abs(ours[i].value / theirs[i].value - 1));
  return greatest;
}

}  // namespace

TEST_CASE("close to en = 1 the answer keeps the digits that the parameters have, and says where it got them") {
  // Rounding hides 2e-14 of −ln e_n from a search: with it go c, alpha and k2/k1 − 1, 2 % of them at 1 − 1e-12. What
  // the tolerance of 1e-10 allows is 2e-10, t_col entering squared.
  for (const auto& c : all_cases)
    for (const double en : {0.999, 1 - 1e-5, 1 - 1e-6, 1 - 1e-9, 1 - 1e-12, 1 - 1e-15}) {
      CAPTURE(c.law.name(), text(c.end), en);
      const auto asked = calibrated(c, 1e-4, en), direct = calibrated(c, 1e-4, en, {.method = Method::direct});
      CHECK(greatest_difference(asked, direct) <= 2.1e-10);
      if (asked.method == Method::nlopt) continue;
      CHECK_THAT(asked.remarks.at(0), Catch::EndsWith("; the direct solution is answered"));
    }
  const auto tsuji = calibrated({kind_of<Tsuji>, ContactEnd::force}, 1e-4, 1 - 1e-12);
  CHECK(tsuji.method == Method::direct);
  CHECK(tsuji.cross_method == Method::nlopt);
  CHECK(tsuji.cross_difference > 1e-4);
  CHECK(calibrated({kind_of<Tsuji>, ContactEnd::force}, 1e-4, 0.999).method == Method::nlopt);
}

TEST_CASE(
    "an answer is confirmed by a collision to the tolerance, or to what the collision is off by, and no further") {
  CHECK(confirmed(0.99e-9, 1e-9, 0) == Confirmation::full);
  CHECK(confirmed(1.01e-9, 1e-9, 0) == Confirmation::missed);
  CHECK(confirmed(1.01e-9, 1e-9, 1.02e-9) == Confirmation::within_error);
  CHECK(confirmed(1.03e-9, 1e-9, 1.02e-9) == Confirmation::missed);
  CHECK(confirmed(std::nan(""), 1e-9, 1) == Confirmation::missed);
}

TEST_CASE("a stiffness of Kelvin and Voigt's law leaves its degree to the collision") {
  Request request{.law = kind_of<FractionalKelvinVoigt>, .target = {1e-4, 0.5, table_two}};
  request.stiffness = 3000;
  for (const Method method : {Method::nlopt, Method::direct}) {
    const auto found = std::get<Calibration>(calibrate(request, {.method = method}));
    const auto law = std::get<FractionalKelvinVoigt>(found.law);
    CHECK(law.k() == Approx(3000).epsilon(1e-9));
    const Collision does = collide(law, table_two);
    CHECK(does.tcol == Approx(1e-4).epsilon(1e-9));
    CHECK(does.en == Approx(0.5).epsilon(1e-9));
  }
}
