#include <calibrate/tangential.hpp>
#include <ricochet/collision/oblique.hpp>
#include <ricochet/collision/reduction.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

using std::numbers::pi;

constexpr Impact impact{.velocity = 0.5, .mass_eff = 7.06858e-6};
constexpr double tcol = 1e-4, en = 0.7;
const double m_t = 2.0 / 7 * impact.mass_eff;

AnyLaw normal(LawKind kind, ContactEnd end = ContactEnd::force) {
  return at_impact(unit_law(kind, en, end)->law, tcol, impact).value();
}

TangentialCalibration found(const TangentialRequest& request, const AnyLaw& law, ContactEnd end = ContactEnd::force) {
  return std::get<TangentialCalibration>(calibrate_tangential(request, law, end, {tcol, en, impact}));
}

Infeasible missed(const TangentialRequest& request, const AnyLaw& law) {
  return std::get<Infeasible>(calibrate_tangential(request, law, ContactEnd::force, {tcol, en, impact}));
}

}  // namespace

TEST_CASE("a spring and a dashpot for beta0: half a period in tcol, whatever the normal law", "[tangential]") {
  for (const LawKind kind : LawKind::all()) {
    CAPTURE(kind.name());
    for (const double beta0 : {0.2, 0.7, 1.0}) {
      const auto c = found({.beta0 = beta0}, normal(kind));
      const auto& law = std::get<LinearTangential>(c.law);
      CHECK(law.k_t() == Approx(m_t * (pi * pi + std::pow(std::log(beta0), 2)) / (tcol * tcol)).epsilon(1e-14));
      CHECK(law.c_t() == Approx(-2 * m_t * std::log(beta0) / tcol).epsilon(1e-14).margin(1e-300));
      // The other way to the number: the oblique collision of the normal law, and the search over it.
      CHECK(c.achieved == Approx(beta0).margin(1e-7));
      CHECK(c.cross_difference.value() < 1e-5);
    }
  }
}

TEST_CASE("a spring alone for beta0", "[tangential]") {
  for (const double beta0 : {-0.9, -0.3, 0.0, 0.5, 1.0}) {
    CAPTURE(beta0);
    const auto c = found({.form = TangentialForm::undamped, .beta0 = beta0}, normal(kind_of<Tsuji>));
    CHECK(std::get<LinearTangential>(c.law).k_t() ==
          Approx(m_t * std::pow(std::acos(-beta0) / tcol, 2)).epsilon(1e-14));
    CHECK(c.achieved == Approx(beta0).margin(1e-7));
    CHECK(c.cross_difference.value() < 1e-5);
  }
}

TEST_CASE("Mindlin's spring for beta0, or of moduli with a dashpot for it", "[tangential]") {
  for (const double beta0 : {-0.5, 0.0, 0.3}) {
    CAPTURE(beta0);
    const auto c = found({.form = TangentialForm::mindlin, .beta0 = beta0}, normal(kind_of<Tsuji>));
    CHECK(std::get<MindlinTangential>(c.law).c_t() == 0);
    CHECK(c.achieved == Approx(beta0).margin(1e-8));
    CHECK(c.cross_difference.value() < 1e-5);
  }
  // Equal bodies: G* = G/(2(2-nu)) = E/(4(1+nu)(2-nu)), and of unlike ones their compliances add up.
  const double k = mindlin_stiffness(1e9, 0.3, 1e9, 0.3, 1e-3);
  CHECK(k == Approx(8 * 1e9 / (4 * 1.3 * 1.7) * std::sqrt(1e-3)).epsilon(1e-14));
  CHECK(2 / mindlin_stiffness(1e9, 0.3, 5e9, 0.2, 1e-3) ==
        Approx(1 / k + 1 / mindlin_stiffness(5e9, 0.2, 5e9, 0.2, 1e-3)).epsilon(1e-14));
  const double of_moduli =
      std::get<MindlinTangential>(found({.form = TangentialForm::mindlin, .beta0 = 0.3}, normal(kind_of<Tsuji>)).law)
          .k_t();
  const auto free = found({.form = TangentialForm::mindlin, .mindlin = of_moduli}, normal(kind_of<Tsuji>));
  CHECK(free.beta0 == Approx(0.3).margin(1e-8));
  CHECK(free.achieved == free.beta0);
  const auto damped =
      found({.form = TangentialForm::mindlin, .beta0 = 0.1, .mindlin = of_moduli}, normal(kind_of<Tsuji>));
  CHECK(std::get<MindlinTangential>(damped.law).k_t() == of_moduli);
  CHECK(std::get<MindlinTangential>(damped.law).c_t() > 0);
  CHECK(damped.achieved == Approx(0.1).margin(1e-8));
  // A weak spring gives back little; a dashpot brings what it leaves of the slip to rest.
  const TangentialRequest weak{.form = TangentialForm::mindlin, .mindlin = 0.2 * of_moduli};
  const double left = found(weak, normal(kind_of<Tsuji>)).beta0;
  CHECK(left < -0.2);
  TangentialRequest halved = weak;
  halved.beta0 = 0.5 * left;
  CHECK(found(halved, normal(kind_of<Tsuji>)).achieved == Approx(0.5 * left).margin(1e-8));
  halved.beta0 = 0.5;
  const Infeasible out = missed(halved, normal(kind_of<Tsuji>));
  CHECK(out.lowest == Approx(left).margin(1e-12));
  CHECK(out.highest < 0.5);
}

TEST_CASE("out of a form's range, beta0 is told with the range", "[tangential]") {
  const AnyLaw law = normal(kind_of<Linear>);
  for (const double beta0 : {-0.1, 0.0, 1.1}) {
    const Infeasible out = missed({.beta0 = beta0}, law);
    CHECK(out.quantity == "beta0");
    CHECK((out.lowest == 0 && out.low_open && out.highest == 1 && !out.open));
    CHECK(out_of_form(TangentialForm::linear, beta0, kind_of<Linear>, ContactEnd::force)->reason == out.reason);
  }
  for (const double beta0 : {-1.0, 1.01}) {
    const Infeasible out = missed({.form = TangentialForm::undamped, .beta0 = beta0}, law);
    CHECK((out.lowest == -1 && out.low_open && out.highest == 1));
  }
  const Infeasible out = missed({.form = TangentialForm::mindlin, .beta0 = 0.99}, law);
  CHECK(out.highest < 0.99);
  const auto top = found({.form = TangentialForm::mindlin, .beta0 = out.highest - 1e-6}, law);
  CHECK(top.achieved == Approx(out.highest).margin(2e-6));
  CHECK_THROWS_AS(calibrate_tangential({}, law, ContactEnd::force, {tcol, en, impact}), std::invalid_argument);
  CHECK_THROWS_AS(calibrate_tangential({.beta0 = 1, .mu = -1}, law, ContactEnd::force, {tcol, en, impact}),
                  std::invalid_argument);
}

TEST_CASE("a contact that ends by overlap lets go in its tangent plane before it ends, which is said", "[tangential]") {
  const auto c = found({.beta0 = 0.5}, normal(kind_of<Linear>, ContactEnd::overlap), ContactEnd::overlap);
  CHECK(std::get<LinearTangential>(c.law).c_t() == Approx(-2 * m_t * std::log(0.5) / tcol).epsilon(1e-14));
  // The repulsion of a damped spring lasts 2 psi/(sin psi sqrt(k/m)), cos psi = c/(2 sqrt(km)), and the tangential
  // motion then is -e^(-Dt)(cos wt - (D/w) sin wt), w = pi/tcol.
  const Linear law = std::get<Linear>(normal(kind_of<Linear>, ContactEnd::overlap));
  const double psi = std::acos(law.c() / (2 * std::sqrt(law.k() * impact.mass_eff)));
  const double repulsion = 2 * psi / (std::sin(psi) * std::sqrt(law.k() / impact.mass_eff));
  const double D = -std::log(0.5) / tcol, w = pi / tcol;
  CHECK(c.achieved ==
        Approx(-std::exp(-D * repulsion) * (std::cos(w * repulsion) - D / w * std::sin(w * repulsion))).epsilon(1e-8));
  CHECK(c.remarks.size() == 1);
}

TEST_CASE("by overlap a contact that slides throughout rubs as long as it repels: mu (1 + e_force)/(1 + e_n)",
          "[tangential]") {
  const AnyLaw law = normal(kind_of<Linear>, ContactEnd::overlap);
  const double mu = 0.1;
  const auto c = found({.beta0 = 0.6}, law, ContactEnd::overlap);
  const auto& spring = std::get<Linear>(law);
  // Where R reaches 0 the rebound is exp(-2 psi/tan psi) fast, cos psi = c/(2 sqrt(km)).
  const double psi = std::acos(spring.c() / (2 * std::sqrt(spring.k() * impact.mass_eff)));
  const double expected = mu * (1 + std::exp(-2 * psi / std::tan(psi))) / (1 + en);
  CHECK(expected > 1.001 * mu);
  const auto r = rebounds(c.law, mu, law, ContactEnd::overlap, impact, std::array{85 * pi / 180})[0];
  CHECK(r.impulse_ratio == Approx(expected).epsilon(1e-8));
  CHECK(r.et == Approx(1 - expected * (1 + en) / std::tan(r.angle)).epsilon(1e-8));
}

TEST_CASE("beta0 next to an end of its range: the search finds the closed form's branch, or says how far it is",
          "[tangential]") {
  for (const double beta0 : {-0.999999, -0.9999, 0.9999}) {
    CAPTURE(beta0);
    const auto c = found({.form = TangentialForm::undamped, .beta0 = beta0}, normal(kind_of<Tsuji>));
    CHECK(c.cross_difference.value() < 1e-9);
    CHECK(c.remarks.empty());
  }
  const auto c = found({.beta0 = 0.9999999}, normal(kind_of<Tsuji>));
  CHECK(c.cross_difference.value() > 1e-6);
  CHECK(c.remarks.size() == 1);
  const auto elastic = found({.beta0 = 1}, normal(kind_of<Tsuji>));
  CHECK_FALSE(std::signbit(std::get<LinearTangential>(elastic.law).c_t()));
}

TEST_CASE("a weak dashpot sticks as asked, though its sliding cannot be followed", "[tangential]") {
  const AnyLaw law = normal(kind_of<Tsuji>);
  const auto c = found({.beta0 = 0.9999}, law);
  CHECK(c.achieved == Approx(0.9999).margin(1e-9));
  CHECK_THROWS_AS(rebounds(c.law, 0.3, law, ContactEnd::force, impact, usual_angles()), NotConverged);
}

TEST_CASE("a repulsion that fades lets even endless friction slide, which is said", "[tangential]") {
  const double least = 1e-6;
  const AnyLaw law = at_impact(unit_law(kind_of<Linear>, least, ContactEnd::force)->law, tcol, impact).value();
  const auto c = std::get<TangentialCalibration>(
      calibrate_tangential({.beta0 = 0.4}, law, ContactEnd::force, {tcol, least, impact}));
  CHECK(c.achieved > 0.41);
  REQUIRE(c.remarks.size() == 1);
  CHECK(c.remarks[0].find("slides") != std::string::npos);
}

TEST_CASE("the range beside Mindlin's spring ends at extremes, not at samples, and is reached up to there",
          "[tangential]") {
  const AnyLaw law = normal(kind_of<Tsuji>);
  const double k = std::get<MindlinTangential>(found({.form = TangentialForm::mindlin, .beta0 = -0.05}, law).law).k_t();
  const auto at = [&](double beta0) { return TangentialRequest{TangentialForm::mindlin, beta0, std::nullopt, k}; };
  const Infeasible below = missed(at(-0.9), law), above = missed(at(0.9), law);
  CHECK(below.lowest == above.lowest);
  CHECK(below.highest == above.highest);
  // Another way: samples ten times as dense as the calibration's own reach no further, and nearly as far.
  double lowest = 0, highest = 0;
  for (int i = -400; i <= 240; ++i) {
    const double c_t = m_t / tcol * std::exp(0.025 * i);
    const auto out = collide(law, {.law = MindlinTangential(k, c_t), .friction = {1e9, 1e9, 0}},
                             {.i = {.mass = impact.mass_eff, .radius = 1, .velocity = {0.5, 0, 0.5}}});
    lowest = std::min(lowest, out.beta.value());
    highest = std::max(highest, out.beta.value());
  }
  CHECK(above.lowest <= lowest + 1e-9);
  CHECK(above.lowest == Approx(lowest).margin(1e-4));
  CHECK(above.highest >= highest - 1e-9);
  CHECK(above.highest == Approx(highest).margin(1e-4));
  for (const double inside : {above.lowest + 1e-9, above.highest - 1e-9})
    CHECK(found(at(inside), law).achieved == Approx(inside).margin(1e-9));
}

TEST_CASE("rebounds: what slides throughout, and what sticks, as they are known in closed form", "[tangential]") {
  const AnyLaw law = normal(kind_of<KuwabaraKono>);
  const double beta0 = 0.6, mu = 0.1;
  const auto c = found({.beta0 = beta0}, law);
  const std::array steep{70 * pi / 180, 80 * pi / 180};
  for (const ObliqueRebound& r : rebounds(c.law, mu, law, ContactEnd::force, impact, steep)) {
    CHECK(r.impulse_ratio == Approx(mu).epsilon(1e-9));
    CHECK(r.et == Approx(1 - mu * (1 + en) / std::tan(r.angle)).epsilon(1e-8));
    CHECK(r.rebound_angle == Approx(std::atan(r.et * std::tan(r.angle) / en)).epsilon(1e-8));
  }
  const std::array flat{5 * pi / 180};
  const ObliqueRebound stuck = rebounds(c.law, 1e6, law, ContactEnd::force, impact, flat)[0];
  CHECK(stuck.beta == Approx(beta0).margin(1e-6));
  CHECK(stuck.et == Approx(1 - 2.0 / 7 * (1 + beta0)).margin(1e-6));
  CHECK(usual_angles().size() == 17);
  CHECK_THROWS_AS(rebounds(c.law, mu, law, ContactEnd::force, impact, std::array{pi / 2}), std::invalid_argument);
}

TEST_CASE("sensitivities of e_t are those of gross sliding at grazing impacts, of sticking at steep ones",
          "[tangential]") {
  const TangentialRequest request{.beta0 = 0.6, .mu = 0.1};
  const AnyLaw law = normal(kind_of<Linear>);
  const auto c = found(request, law);
  const std::array angles{80 * pi / 180};
  const auto s = sensitivities(c, request, kind_of<Linear>, ContactEnd::force, {tcol, en, impact}, angles)[0];
  const double per = 0.01 / std::tan(angles[0]);
  CHECK(s.mu == Approx(-0.1 * (1 + en) * per).epsilon(1e-5));
  CHECK(s.en == Approx(-0.1 * en * per).epsilon(1e-5));
  CHECK(s.beta0 == Approx(0).margin(1e-9));
  CHECK(s.tcol == Approx(0).margin(1e-9));
  const TangentialRequest sticky{.beta0 = 0.6, .mu = 1e6};
  const auto t = sensitivities(found(sticky, law), sticky, kind_of<Linear>, ContactEnd::force, {tcol, en, impact},
                               std::array{5 * pi / 180})[0];
  CHECK(t.beta0 == Approx(-2.0 / 7 * 0.6 * 0.01).epsilon(1e-3));
  CHECK(t.mu == Approx(0).margin(1e-8));
}
