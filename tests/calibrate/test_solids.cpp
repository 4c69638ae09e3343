// The laws of real solids through calibration: the values of independent computations, what is held, what is refused.

#include <calibrate/direct_calibrator.hpp>
#include <calibrate/given_law.hpp>
#include <calibrate/known.hpp>
#include <catch2/catch.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/motion/column.hpp>

#include <cmath>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

constexpr Impact unit{1, 1}, impact{0.5, 7e-6};

/// Values of the parameters that answer a target in the units of the impact, by the search and by the reduction.
std::vector<double> found(const Request& request) {
  const auto searched = std::get<Calibration>(calibrate(request));
  const auto direct = std::get<Calibration>(calibrate(request, {.method = Method::direct}));
  CHECK(searched.method == Method::nlopt);
  CHECK(searched.cross_difference < 1e-9);
  auto ours = values(searched.law);
  const auto theirs = values(direct.law);
  for (std::size_t i = 0; i < ours.size(); ++i) CHECK(ours[i] == Approx(theirs[i]).epsilon(1e-9));
  const auto tables = DirectCalibrator()(request);
  CHECK(values(std::get<AnyLaw>(tables)) == theirs);
  return ours;
}

void check_close(const std::vector<double>& got, const std::vector<double>& wanted, double bound) {
  REQUIRE(got.size() == wanted.size());
  for (std::size_t i = 0; i < got.size(); ++i) CHECK(got[i] == Approx(wanted[i]).epsilon(bound));
}

}  // namespace

TEST_CASE("collisions computed elsewhere are answered by the parameters that they were computed for", "[solids]") {
  const auto force = ContactEnd::force, overlap = ContactEnd::overlap;
  const auto kelvin_voigt = [&](ContactEnd end, double tcol, double en, double alpha) {
    return found({.law = kind_of<FractionalKelvinVoigt>, .end = end, .target = {tcol, en, unit}, .held = {alpha}});
  };
  check_close(kelvin_voigt(force, 2.489833431848, .7016741548288, 0.5), {1, 0.5, 0.5}, 1e-10);
  check_close(kelvin_voigt(force, 2.068085982719, .5660168764213, 0.5), {1, 1, 0.5}, 1e-10);
  check_close(kelvin_voigt(force, 2.504411640990, .8443239715506, 0.25), {1, 0.5, 0.25}, 1e-10);
  check_close(kelvin_voigt(overlap, 2.519347682702, .4698858598635, 0.5), {1, 1, 0.5}, 1e-10);
  check_close(kelvin_voigt(overlap, 2.638438965071, .8331564688078, 0.25), {1, 0.5, 0.25}, 1e-10);
  const auto hertz = [&](double tcol, double en, double alpha) {
    return found({.law = kind_of<FractionalHertz>, .end = force, .target = {tcol, en, unit}, .held = {alpha}});
  };
  check_close(hertz(2.53903632686, .679172198859, 0.5), {1, 0.5, 0.5}, 1e-9);
  check_close(hertz(2.164148712927, .5441635565531, 0.5), {1, 1, 0.5}, 1e-9);
  check_close(hertz(2.9324650753, .5739153602, 1), {1, 0.36, 1}, 1e-8);
  // (1, 4, 0.2, 0.5) is beyond the tau of the least en: the shorter of the two is answered, which does the same.
  const auto zener = found(
      {.law = kind_of<FractionalZener>, .end = force, .target = {1.91550721613, .67295252788, unit}, .held = {0.5, 4}});
  CHECK(zener[2] / std::sqrt(1 / zener[0]) < 0.2);
  CHECK(zener[1] == Approx(4 * zener[0]).epsilon(1e-14));
  const Collision same = collide(FractionalZener(zener[0], zener[1], zener[2], 0.5), unit);
  CHECK(same.tcol == Approx(1.91550721613).epsilon(1e-10));
  CHECK(same.en == Approx(.67295252788).epsilon(1e-10));
}

TEST_CASE("what calibration finds does it on Maxwell arms too, in a column of one bead", "[solids]") {
  for (const LawKind law : {kind_of<FractionalKelvinVoigt>, kind_of<FractionalHertz>, kind_of<FractionalZener>}) {
    CAPTURE(law.name());
    const auto answer = std::get<Calibration>(calibrate({law, ContactEnd::force, {1e-4, 0.7, impact}}));
    const Column bead = equal_column(1, impact.mass_eff, 1e-7, -impact.velocity);
    const auto kept = [&](double steps) {
      return run_column(bead, answer.law, answer.law, {.step = 1e-4 / steps, .duration = 1}).velocity.front() /
             impact.velocity;
    };
    // Of second order: what the coarser steps miss by is four times the finer ones' miss.
    const double coarse = kept(500), fine = kept(1000);
    CHECK(fine + (fine - coarse) / 3 == Approx(0.7).epsilon(1e-5));
  }
}

TEST_CASE("what the direct calibrator keeps of an en serves every time and impact to the bit", "[solids]") {
  const DirectCalibrator kept;
  for (const LawKind law : {kind_of<FractionalKelvinVoigt>, kind_of<FractionalHertz>, kind_of<FractionalZener>})
    for (const Held& held : {Held{}, Held{.alpha = 0.3, .stiffening = 40}})
      for (const auto& [tcol, velocity] : {std::pair{1e-4, 0.5}, {3e-5, 0.5}, {1e-4, 2.0}}) {
        const Request request{
            .law = law, .end = ContactEnd::force, .target = {tcol, 0.8, {velocity, 7e-6}}, .held = held};
        const auto alone = std::get<Calibration>(calibrate(request, {.method = Method::direct}));
        CHECK(values(std::get<AnyLaw>(kept(request))) == values(alone.law));
      }
}

TEST_CASE("fitted at one speed fractional-hertz goes with v^(alpha/5)", "[solids]") {
  const auto loss = [](const AnyLaw& law, double v) { return 1 - collide(law, {v, 7e-6}).en; };
  for (const double alpha : {0.3, 0.8}) {
    const auto answer = calibrate(
        {.law = kind_of<FractionalHertz>, .end = ContactEnd::force, .target = {1e-4, 0.999, impact}, .held = {alpha}});
    const AnyLaw law = std::get<Calibration>(answer).law;
    CHECK(std::log(loss(law, 5) / loss(law, 0.5)) / std::log(10) == Approx(alpha / 5).epsilon(5e-3));
  }
}

TEST_CASE("a k beside collision time and restitution leaves Kelvin-Voigt one alpha", "[solids]") {
  Request request{.law = kind_of<FractionalKelvinVoigt>,
                  .end = ContactEnd::force,
                  .target = {2.068085982719, .5660168764213, unit},
                  .stiffness = 1};
  check_close(found(request), {1, 1, 0.5}, 1e-9);
  request.target = {1e-4, 0.5, impact};
  request.stiffness = 1e6;
  const auto missed = std::get<Infeasible>(calibrate(request));
  CHECK(missed.quantity == "stiffness");
  CHECK(missed.highest == Approx(std::get<Linear>(tuned_law(kind_of<Linear>, 1e-4, 0.5, impact)).k()).epsilon(1e-10));
  CHECK(missed.low_open);
  CHECK(std::holds_alternative<Infeasible>(DirectCalibrator()(request)));
  // Springs have no alpha: their k is that of the time, or none.
  request.target.en = 1;
  CHECK(std::get<Infeasible>(calibrate(request)).lowest == Approx(std::pow(M_PI / 1e-4, 2) * 7e-6).epsilon(1e-12));
  request.stiffness = std::pow(M_PI / 1e-4, 2) * 7e-6;
  CHECK(std::holds_alternative<Calibration>(calibrate(request)));
}

TEST_CASE("what is out of reach at what is held is told by it", "[solids]") {
  const auto missed = [](LawKind law, const Held& held) {
    return std::get<Infeasible>(
        calibrate({.law = law, .end = ContactEnd::force, .target = {1e-4, 0.1, impact}, .held = held}));
  };
  CHECK(missed(kind_of<FractionalHertz>, {0.25}).reason == "no loss leaves less at alpha = 0.25, which is held");
  CHECK(missed(kind_of<FractionalHertz>, {0.25}).lowest == 0.572);
  CHECK(missed(kind_of<FractionalKelvinVoigt>, {}).lowest == 0.301);
  CHECK(missed(kind_of<FractionalZener>, {0.5, 4}).reason ==
        "no loss leaves less at alpha = 0.5 and k1/k = 4, which are held");
  const auto refused = [](const Held& held) {
    return [=] { return calibrate({.law = kind_of<FractionalZener>, .target = {1e-4, 0.9, impact}, .held = held}); };
  };
  CHECK_THROWS_WITH(refused({1.5})(), "alpha = 1.5: must be in [0, 1]");
  CHECK_THROWS_WITH(refused({0.5, -1})(), Catch::StartsWith("stiffening = -1: must be in [1e-30, 1e30]"));
  // A scale that is no time meets the same bound on its way to one.
  const auto known = calibrate(kind_of<FractionalKelvinVoigt>, ContactEnd::force,
                               {scale::Stiffness{4000}, loss::Restitution{0.1}, impact, {0.75}});
  CHECK(std::get<Infeasible>(known).lowest == Approx(fractional_contact(0.75).en).margin(1e-3));
}

TEST_CASE("the forward question says what calibration would have held", "[solids]") {
  const auto zener = std::get<Calibration>(answer(FractionalZener(1, 4, 0.2, 0.5), ContactEnd::force, unit));
  CHECK(zener.achieved.en == Approx(.67295252788).epsilon(1e-10));
  CHECK(zener.request.held.stiffening == 4);
  const auto hertz = std::get<Calibration>(answer(FractionalHertz(0, 1, 0.25), ContactEnd::force, unit));
  CHECK(hertz.achieved.tcol == Approx(2.8422870976).epsilon(1e-9));
  CHECK(hertz.request.held.alpha == 0.25);
  CHECK(std::get<Calibration>(answer(FractionalKelvinVoigt(1, 1, 0.5), ContactEnd::force, unit)).request.held.alpha ==
        0.5);
}
