#include <calibrate/direct_calibrator.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

struct Case {
  LawName law;
  ContactEnd end;
};
constexpr Case tabulated[] = {{LawName::linear, ContactEnd::overlap},      {LawName::linear, ContactEnd::force},
                              {LawName::kuwabara_kono, ContactEnd::force}, {LawName::tsuji, ContactEnd::overlap},
                              {LawName::tsuji, ContactEnd::force},         {LawName::hysteretic, ContactEnd::force},
                              {LawName::fractional, ContactEnd::force}};

AnyLaw by_table(const DirectCalibrator& calibrator, const Request& request) {
  const auto answer = calibrator(request);
  REQUIRE(std::holds_alternative<AnyLaw>(answer));
  return std::get<AnyLaw>(answer);
}

/// The slow path: the bracketed root or closed form, one collision each.
AnyLaw slowly(const Request& request) {
  const auto outcome = calibrate(request, {.method = Method::direct});
  REQUIRE(std::holds_alternative<Calibration>(outcome));
  return std::get<Calibration>(outcome).law;
}

/// Greatest relative difference of an identifiable parameter.
double difference(const AnyLaw& law, const AnyLaw& other) {
  const auto ours = identifiable(law), theirs = identifiable(other);
  double greatest = 0;
  for (std::size_t i = 0; i < ours.size(); ++i) {
    const double size = std::abs(theirs[i].value);
    greatest = std::max(greatest, std::abs(ours[i].value - theirs[i].value) / (size > 0 ? size : 1));
  }
  return greatest;
}

}  // namespace

TEST_CASE("the tables agree with the slow path on every law, end and panel") {
  const DirectCalibrator calibrator;
  constexpr int points = 90;  // three to a panel, an irrational step apart in ln ln e_n
  for (const auto& c : tabulated)
    for (int i = 0; i <= points; ++i) {
      const double loss = 1.0001e-4 * std::pow(5.1159 / 1.0001e-4, i / static_cast<double>(points));
      const double tcol = std::pow(10, -9 + 0.1 * i), velocity = std::pow(10, 0.07 * i - 3);
      const Request request{c.law, c.end, {tcol, std::exp(-loss), {velocity, 3e-5 * velocity}}};
      CAPTURE(text(c.law), text(c.end), request.target.en);
      // Two collisions' rounding, 1e-14 each, is all that either knows of the loss.
      CHECK(difference(by_table(calibrator, request), slowly(request)) < 1e-11 + 2e-14 / loss);
    }
}

TEST_CASE("a tabulated law does what it was asked for, by the numerical collision") {
  const DirectCalibrator calibrator;
  for (const auto& c : tabulated)
    for (const double en : {0.0061, 0.03, 0.2, 0.5, 0.77, 0.95, 0.999, 1.0}) {
      const Request request{c.law, c.end, {2e-4, en, {1.3, 4e-3}}};
      CAPTURE(text(c.law), text(c.end), en);
      const auto out = collide(by_table(calibrator, request), request.target.impact, {c.end, CollideMethod::numerical});
      CHECK(out.tcol == Approx(2e-4).epsilon(2e-11));
      CHECK(out.en == Approx(en).epsilon(2e-11));
    }
}

TEST_CASE("a stiffness to hold is held, and its c made to fit") {
  const DirectCalibrator calibrator;
  const Request request{LawName::fractional, ContactEnd::force, {1e-4, 0.5, {0.5, 7e-6}}, 1234.0};
  const auto law = std::get<Fractional>(by_table(calibrator, request));
  CHECK(law.k() == 1234);
  CHECK(difference(law, slowly(request)) < 1e-11);
}

TEST_CASE("what the tables leave out is answered as calibrate answers it") {
  const DirectCalibrator calibrator;
  const Impact impact{0.5, 7e-6};
  for (const Request& request : {Request{LawName::fractional, ContactEnd::overlap, {1e-4, 0.5, impact}},
                                 Request{LawName::tsuji, ContactEnd::force, {1e-4, 0.001, impact}},
                                 Request{LawName::kuwabara_kono, ContactEnd::force, {1e-4, 0.99999, impact}},
                                 Request{LawName::fractional, ContactEnd::force, {1e-4, 0.99999, impact}}})
    CHECK(difference(by_table(calibrator, request), slowly(request)) < 1e-11 + 2e-14 / -std::log(request.target.en));
  for (const LawName law : {LawName::linear, LawName::hysteretic, LawName::fractional}) {
    CHECK(std::holds_alternative<Infeasible>(calibrator({law, ContactEnd::force, {1e-4, 1e-320, impact}})));
    for (const double en : {0.0025, 0.003, 0.0033, 0.004, 0.0051, 1e-6})
      CHECK(std::holds_alternative<AnyLaw>(calibrator({law, ContactEnd::force, {1e-4, en, impact}})));
  }
  const auto spring = calibrator({LawName::fractional, ContactEnd::force, {1e-4, 1, impact}, 1.0});
  REQUIRE(std::holds_alternative<Infeasible>(spring));
  CHECK(std::get<Infeasible>(spring).quantity == "stiffness");
}

TEST_CASE("the direct calibrator names what it cannot use") {
  const DirectCalibrator calibrator;
  const Impact impact{0.5, 7e-6};
  CHECK_THROWS_WITH(calibrator({LawName::linear, ContactEnd::force, {0, 0.5, impact}}),
                    Catch::StartsWith("tcol = 0: must be"));
  CHECK_THROWS_WITH(calibrator({LawName::linear, ContactEnd::force, {1, 2, impact}}), "en = 2: must be in (0, 1]");
  CHECK_THROWS_WITH(calibrator({LawName::hysteretic, ContactEnd::overlap, {1, 0.5, impact}}),
                    "end = overlap: must be force for the law hysteretic");
}
