#include <catch2/catch.hpp>
#include <rapidcheck.h>
#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/reach.hpp>
#include <ricochet/collision/scale_and_loss.hpp>

#include <cmath>
#include <numbers>

using namespace ricochet;

namespace {

constexpr ElasticSolid steel{210e9, 0.3};

rc::Gen<double> decades(double low, double high) {
  constexpr int steps = 1'000'000;
  return rc::gen::map(rc::gen::inRange(0, steps + 1),
                      [=](int i) { return std::pow(10, low + (high - low) * i / steps); });
}

struct Case {
  LawKind law;
  ContactEnd end;
};

Case any_case() {
  const auto all = LawKind::all();
  const LawKind law = all[*rc::gen::inRange<std::size_t>(0, all.size())];
  return {law, law.ends().overlap && *rc::gen::arbitrary<bool>() ? ContactEnd::overlap : ContactEnd::force};
}

/// The e_n, or one halfway to 1 from what the law of a real solid does not go below.
double reached(const Case& c, double en) {
  const double bound = restitution_bound(c.law, c.end);
  return en > 1.001 * bound ? en : 0.5 * (1 + bound);
}

void close(double a, double b, double bound) {
  RC_ASSERT(std::abs(a - b) <= bound * std::max(std::abs(a), std::abs(b)));
}

/// The law that a target determines, as calibration makes it.
AnyLaw law_of(const Case& c, double tcol, double en, const Impact& impact, std::optional<double> held) {
  const AnyLaw unit = unit_law(c.law, en, c.end).value().law;
  if (const auto* f = std::get_if<Fractional>(&unit); f && held)
    return Reduction<Fractional>::holding(*held, f->coefficient(), f->alpha(), tcol, impact.mass_eff).value();
  return at_impact(unit, tcol, impact).value();
}

}  // namespace

TEST_CASE("the contact modulus of two solids, and Hertz's stiffness of it", "[scale]") {
  CHECK(contact_modulus(steel, steel) == Approx(210e9 / (2 * (1 - 0.09))).epsilon(1e-15));
  // A rigid partner leaves the plane-strain modulus of the other.
  CHECK(contact_modulus(steel, {1e300, 0.5}) == Approx(210e9 / (1 - 0.09)).epsilon(1e-15));
  // E = 1e7 Pa, ν = 0.33, two spheres of r = 2.5 mm.
  CHECK(hertz_stiffness(contact_modulus({1e7, 0.33}, {1e7, 0.33}), 1.25e-3) == Approx(264507.08).epsilon(1e-8));
}

TEST_CASE("Hertz's time and overlap are those of the undamped collision", "[scale]") {
  const Impact impact{0.7, 3e-5};
  const double k = 2e7;
  const Collision out = collide(Tsuji(k, 0), impact);
  CHECK(hertz_time(k, impact) == Approx(out.tcol).epsilon(1e-11));
  CHECK(hertz_overlap(k, impact) == Approx(out.max_overlap).epsilon(1e-11));
  // (m²/(k²v))^{1/5} has the constant 3.218…, ζ/v the better known 2.943….
  CHECK(hertz_time(k, impact) / std::pow(3e-5 * 3e-5 / (k * k * 0.7), 0.2) ==
        Approx(3.2180654597190431).epsilon(1e-14));
}

TEST_CASE("a linear spring stands for Hertz's in time or in depth", "[scale]") {
  const Impact impact{0.7, 3e-5};
  const double k = 2e7;
  const Collision hertz = collide(Tsuji(k, 0), impact);
  CHECK(collide(Linear(linear_stiffness(k, impact), 0), impact).tcol == Approx(hertz.tcol).epsilon(1e-11));
  CHECK(collide(Linear(linear_stiffness(k, impact, LinearMatch::overlap), 0), impact).max_overlap ==
        Approx(hertz.max_overlap).epsilon(1e-11));
}

TEST_CASE("softer bodies: E* is divided", "[scale]") {
  const Impact impact{0.7, 3e-5};
  const auto k = [&](LawKind law, double soften) {
    return stiffness(law, scale::Moduli{steel, steel, 1e-3, soften}, impact).value();
  };
  CHECK(k(kind_of<Tsuji>, 100) == Approx(k(kind_of<Tsuji>, 1) / 100).epsilon(1e-15));
  CHECK(k(kind_of<Fractional>, 100) == linear_stiffness(k(kind_of<Tsuji>, 100), impact));
}

TEST_CASE("which law has which loss, and how far it reaches", "[loss]") {
  const Loss factor = loss::LossFactor{0.1}, ratio = loss::DampingRatio{0.1}, en = loss::Restitution{0.5};
  for (const LawKind law : LawKind::all()) {
    CAPTURE(law.name());
    CHECK(has_loss(law, en));
    CHECK(has_loss(law, factor) == (law == kind_of<Fractional>));
    CHECK(has_loss(law, ratio) == (law == kind_of<Linear> || law == kind_of<Tsuji>));
  }
  CHECK_FALSE(restitution(kind_of<Tsuji>, ContactEnd::overlap, loss::DampingRatio{1}));
  CHECK(restitution(kind_of<Tsuji>, ContactEnd::overlap, loss::DampingRatio{0.99}));
  CHECK(restitution(kind_of<Linear>, ContactEnd::force, loss::DampingRatio{3}));
  CHECK_FALSE(restitution(kind_of<Linear>, ContactEnd::force, loss::DampingRatio{1e300}));
  const double limit = loss_limit(kind_of<Fractional>, ContactEnd::overlap, factor);
  CHECK(2 / std::numbers::pi * std::atan(limit) == Approx(overlap_limit).epsilon(1e-15));
  CHECK_FALSE(restitution(kind_of<Fractional>, ContactEnd::overlap, loss::LossFactor{limit}));
  CHECK(restitution(kind_of<Fractional>, ContactEnd::force, loss::LossFactor{limit}));
  CHECK_FALSE(restitution(kind_of<Fractional>, ContactEnd::force, loss::LossFactor{1e20}));
}

TEST_CASE("values of the measures of loss", "[loss]") {
  // tan(π/4) = 1 is α = 1/2: en of the table in reference/fractional_contact.csv.
  CHECK(restitution(kind_of<Fractional>, ContactEnd::force, loss::LossFactor{1}).value() ==
        Approx(fractional_contact(0.5).en).epsilon(1e-14));
  CHECK(restitution(kind_of<Fractional>, ContactEnd::force, loss::LossFactor{0}).value() == 1);
  CHECK(restitution(kind_of<Fractional>, ContactEnd::overlap, loss::ConversionDegree{0.3}).value() ==
        fractional_contact(0.3, ContactEnd::overlap).en);
  CHECK_FALSE(restitution(kind_of<Fractional>, ContactEnd::overlap, loss::ConversionDegree{0.41}));
  // Linear by overlap: e = exp(−πβ/√(1−β²)).
  CHECK(restitution(kind_of<Linear>, ContactEnd::overlap, loss::DampingRatio{0.6}).value() ==
        Approx(std::exp(-0.75 * std::numbers::pi)).epsilon(1e-15));
}

TEST_CASE("values outside their domain are named", "[scale][loss]") {
  const Impact impact{0.5, 1e-5};
  const auto time = [&](const Scale& scale) {
    return collision_time(kind_of<Tsuji>, ContactEnd::force, scale, 0.5, impact);
  };
  using Catch::Contains;
  CHECK_THROWS_WITH(time(scale::CollisionTime{-1}), Contains("tcol = -1"));
  CHECK_THROWS_WITH(time(scale::Stiffness{0}), Contains("stiffness = 0"));
  CHECK_THROWS_WITH(time(scale::MaxOverlap{0}), Contains("max_overlap = 0"));
  CHECK_THROWS_WITH(time(scale::Moduli{{0, 0.3}, steel, 1e-3}), Contains("young = 0"));
  CHECK_THROWS_WITH(time(scale::Moduli{steel, {1e9, 0.6}, 1e-3}), Contains("poisson = 0.6: must be in (-1, 0.5]"));
  CHECK_THROWS_WITH(time(scale::Moduli{steel, steel, 0}), Contains("radius_eff = 0"));
  CHECK_THROWS_WITH(time(scale::Moduli{steel, steel, 1e-3, 0.01}), Contains("soften = 0.01"));
  CHECK_THROWS_WITH(collision_time(kind_of<Tsuji>, ContactEnd::force, scale::Stiffness{1}, 0.5, {0, 1}),
                    Contains("velocity = 0"));
  CHECK_THROWS_WITH(restitution(kind_of<Linear>, ContactEnd::force, loss::Restitution{1.5}), Contains("en = 1.5"));
  CHECK_THROWS_WITH(restitution(kind_of<Linear>, ContactEnd::force, loss::DampingRatio{-1}),
                    Contains("damping_ratio = -1"));
  CHECK_THROWS_WITH(restitution(kind_of<Fractional>, ContactEnd::force, loss::LossFactor{-1}),
                    Contains("loss_factor = -1"));
  CHECK_THROWS_WITH(restitution(kind_of<Hysteretic>, ContactEnd::force, loss::LossFactor{0.1}), Contains("hysteretic"));
}

TEST_CASE("one scale after another leads back to the collision time", "[scale][property]") {
  CHECK(rc::check("tcol → law → its stiffness, its overlap → tcol", [] {
    const Case c = any_case();
    const Impact impact{*decades(-3, 2), *decades(-9, 1)};
    const double tcol = *decades(-8, 0), en = reached(c, *rc::gen::inRange(20, 1000) / 1000.0);
    const double held =
        values(at_impact(unit_law(kind_of<Linear>, en, ContactEnd::force).value().law, tcol, impact).value())[0];
    const AnyLaw law = law_of(c, tcol, en, impact, held);
    const Collision out = collide(law, impact, {c.end});
    close(out.tcol, tcol, 1e-10);
    close(collision_time(c.law, c.end, scale::Stiffness{values(law)[0]}, en, impact).value(), tcol, 1e-10);
    close(collision_time(c.law, c.end, scale::MaxOverlap{out.max_overlap}, en, impact).value(), tcol, 1e-10);
  }));
  CHECK(rc::check("moduli → k of the law that they make", [] {
    const Case c = any_case();
    const Impact impact{*decades(-2, 1), *decades(-8, 0)};
    const scale::Moduli moduli{{*decades(6, 12), 0.3}, {*decades(6, 12), 0.2}, *decades(-4, -1), *decades(0, 4)};
    const double en = reached(c, *rc::gen::inRange(50, 1000) / 1000.0);
    const double k = stiffness(c.law, moduli, impact).value();
    const double tcol = collision_time(c.law, c.end, moduli, en, impact).value();
    close(values(law_of(c, tcol, en, impact, k))[0], k, 1e-10);
  }));
}

TEST_CASE("the loss of a law leads back to its measure", "[loss][property]") {
  CHECK(rc::check("damping ratio → e_n → c → damping ratio", [] {
    const Impact impact{0.5, *decades(-8, 0)};
    const auto end = *rc::gen::element(ContactEnd::force, ContactEnd::overlap);
    const double ratio = *rc::gen::inRange(1, 800) / 1000.0;
    const auto again = [&](LawKind kind) {
      const double en = restitution(kind, end, loss::DampingRatio{ratio}).value();
      const AnyLaw law = at_impact(unit_law(kind, en, end).value().law, 1e-4, impact).value();
      return std::visit(
          [&]<class Law>(const Law& l) {
            if constexpr (requires { damping_ratio(l, impact.mass_eff); })
              return damping_ratio(l, impact.mass_eff);
            else
              return 0.0;
          },
          law);
    };
    close(again(kind_of<Linear>), ratio, 1e-10);
    close(again(kind_of<Tsuji>), ratio, 1e-10);
  }));
  CHECK(rc::check("loss factor → e_n → alpha → loss factor", [] {
    const double tan_delta = *decades(-3, 1);
    const double en = restitution(kind_of<Fractional>, ContactEnd::force, loss::LossFactor{tan_delta}).value();
    close(std::tan(std::numbers::pi / 2 * conversion_degree(en)), tan_delta, 1e-10);
  }));
}
