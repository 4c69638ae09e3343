#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/reach.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace ricochet;

TEST_CASE("A tuned law collides as asked", "[tuned]") {
  const double tcol = 1e-4;
  const Impact impact{0.5, 1.41e-5};
  const auto check = [&](LawKind kind, ContactEnd end, double margin) {
    for (const double en : {0.01, 0.3, 0.5, 0.945, 0.999}) {
      CollideOptions options;
      options.end = end;
      const Collision out = std::visit(
          [&]<class Law>(const Law& law) {
            if constexpr (std::same_as<Law, Fractional>) {
              const FractionalContact c = fractional_contact(law.alpha(), end);
              Collision exact;
              exact.en = c.en;
              exact.tcol = c.tau * std::pow(law.coefficient() / impact.mass_eff, -1 / (2 - law.alpha()));
              return exact;
            } else {
              return collide(law, impact, options);
            }
          },
          tuned_law(kind, tcol, en, impact, end));
      CAPTURE(kind.name(), en);
      CHECK(out.tcol == Approx(tcol).epsilon(margin));
      CHECK(out.en == Approx(en).epsilon(margin));
    }
  };
  check(kind_of<Linear>, ContactEnd::overlap, 1e-11);
  check(kind_of<Linear>, ContactEnd::force, 1e-11);
  check(kind_of<Tsuji>, ContactEnd::force, 1e-11);
  check(kind_of<Tsuji>, ContactEnd::overlap, 1e-11);
  check(kind_of<KuwabaraKono>, ContactEnd::force, 1e-10);
  check(kind_of<Hysteretic>, ContactEnd::force, 1e-11);
  check(kind_of<Fractional>, ContactEnd::force, 1e-11);
  CHECK_THROWS_AS(tuned_law(kind_of<Linear>, tcol, 1.0, impact), std::invalid_argument);
  CHECK_THROWS_AS(tuned_law(kind_of<Linear>, -1, 0.9, impact), std::invalid_argument);
  CHECK_THROWS_WITH(tuned_law(kind_of<Hysteretic>, tcol, 0.9, impact, ContactEnd::overlap),
                    "end = overlap: must be force for the law hysteretic");
  CHECK_THROWS_AS(tuned_law(kind_of<Hysteretic>, 1e-200, 0.9, impact), std::overflow_error);
}

TEST_CASE("every law reaches every restitution, as far as doubles carry it", "[tuned]") {
  const auto check = [](LawKind kind, ContactEnd end, double en, double bound) {
    CAPTURE(kind.name(), static_cast<int>(end), en);
    const auto found = unit_law(kind, en, end);
    REQUIRE(found);
    const auto out = collide(found->law, {1, 1}, {end});
    CHECK(out.tcol == Approx(1).epsilon(bound));
    CHECK(std::abs(out.en - en) <= bound * en);
  };
  const auto force = ContactEnd::force, overlap = ContactEnd::overlap;
  for (const double en : {1.0, 1 - 1e-16, 1 - 1e-12, 0.999, 0.3, 0.0046, 0.003, 1e-6, 1e-12, 1e-30, 1e-100}) {
    const double loss = -std::log(en);
    for (const auto kind : {kind_of<Linear>, kind_of<Tsuji>, kind_of<Hysteretic>, kind_of<KuwabaraKono>})
      check(kind, force, en, 1e-11);
    check(kind_of<Linear>, overlap, en, 1e-11 + 1e-16 * loss * loss * loss);
    check(kind_of<Tsuji>, overlap, en, 1e-11 + 1e-15 * loss * loss * loss);
    // 1 − alpha > 16 e_n
    if (en >= 1e-15) check(kind_of<Fractional>, force, en, 1e-11 + 2e-16 / (16 * en));
    if (en >= 1e-6) check(kind_of<Fractional>, overlap, en, 1e-11 + 1e-15 / (en * en));
  }
  for (const auto kind :
       {kind_of<Linear>, kind_of<Tsuji>, kind_of<Hysteretic>, kind_of<KuwabaraKono>, kind_of<Fractional>})
    CHECK_FALSE(unit_law(kind, 1e-320, force));
}

namespace {

/// The reduction that any law has against that of the law itself: `unit` to 1e-8, what a search by collisions gives.
template <class Law>
void check_generic(ContactEnd end) {
  for (const double en : {0.05, 0.3, 0.7, 0.99}) {
    CAPTURE(Law::name, static_cast<int>(end), en);
    const auto own = Reduction<Law>::unit(en, end), generic = GenericReduction<Law>::unit(en, end);
    REQUIRE(own);
    REQUIRE(generic);
    for (std::size_t i = 0; i < 2; ++i)
      CHECK(generic->law.values()[i] == Approx(own->law.values()[i]).epsilon(1e-8).margin(0));
    CHECK_FALSE(generic->closed_form);
    CHECK(generic->collisions > 1);
  }
}

/// k m v^{1−P} t^{−P−1} and c m v^{−Q} t^{−Q−1}: the units of an impact, P and Q spelt out.
template <class Law>
void check_scaling(double P, double Q) {
  const double k = 3, c = 0.7, tcol = 2.3e-5;
  const Impact impact{0.37, 4.1e-6};
  const double m = impact.mass_eff, v = impact.velocity;
  const auto law = Reduction<Law>::in_si(Law(k, c), tcol, impact);
  REQUIRE(law);
  CHECK(law->k() == Approx(k * m * std::pow(v, 1 - P) * std::pow(tcol, -P - 1)).epsilon(1e-14));
  CHECK(law->c() == Approx(c * m * std::pow(v, -Q) * std::pow(tcol, -Q - 1)).epsilon(1e-14));
  // Neither e_n nor t_col/tcol may change on the way.
  const auto unit = collide(Law(k, c), {1, 1}), si = collide(*law, impact);
  CHECK(si.en == Approx(unit.en).epsilon(1e-10));
  CHECK(si.tcol / tcol == Approx(unit.tcol).epsilon(1e-10));
}

}  // namespace

TEST_CASE("the reduction that any law has is that of the laws of which more is known", "[tuned]") {
  check_generic<Linear>(ContactEnd::force);
  check_generic<Linear>(ContactEnd::overlap);
  check_generic<Tsuji>(ContactEnd::force);
  check_generic<Tsuji>(ContactEnd::overlap);
  // Of Kuwabara and Kono's law nothing more is known than its elastic contact.
  const auto elastic = GenericReduction<KuwabaraKono>::unit(1, ContactEnd::force);
  REQUIRE(elastic);
  CHECK(elastic->law.c() == 0);
  CHECK(elastic->law.k() == Approx(Reduction<Tsuji>::unit(1, ContactEnd::force)->law.k()).epsilon(1e-9));
}

TEST_CASE("a law goes over into SI by its dimensions alone", "[tuned]") {
  check_scaling<Linear>(1, 0);
  check_scaling<KuwabaraKono>(1.5, 0.5);
  check_scaling<Tsuji>(1.5, 0.25);
  const auto hysteretic = Reduction<Hysteretic>::in_si({3, 5}, 2e-5, {0.4, 4e-6});
  REQUIRE(hysteretic);
  CHECK(hysteretic->k1() == Approx(3 * 4e-6 / 4e-10).epsilon(1e-14));
  CHECK(hysteretic->k2() == Approx(5 * 4e-6 / 4e-10).epsilon(1e-14));
}

TEST_CASE("coordinates with a collision time of 1 keep e_n and take it", "[tuned]") {
  for (const LawKind kind : LawKind::all()) {
    CAPTURE(kind.name());
    const double loss = -1;
    const auto before = collide(scaled_law(kind, {0, loss}), {1, 1});
    const auto after = collide(scaled_law(kind, with_unit_tcol(kind, loss, before.tcol)), {1, 1});
    CHECK(after.tcol == Approx(1).epsilon(1e-9));
    CHECK(after.en == Approx(before.en).epsilon(1e-9));
  }
}

TEST_CASE("a fractional law holds the k that is wanted, and collides the same", "[tuned]") {
  const auto unit = Reduction<Fractional>::unit(0.5, ContactEnd::force);
  REQUIRE(unit);
  const double tcol = 1e-4, mass = 7e-6, alpha = unit->law.alpha();
  for (const double k : {500.0, 5000.0, 5e5}) {
    const auto law = Reduction<Fractional>::holding(k, unit->law.coefficient(), unit->law.alpha(), tcol, mass);
    REQUIRE(law);
    CHECK(law->k() == k);
    CHECK(law->alpha() == alpha);
    // ln A to rounding, then over α.
    CHECK(law->coefficient() == Approx(unit->law.coefficient() * mass * std::pow(tcol, alpha - 2)).epsilon(1e-14));
    CHECK(collide(*law, {0.5, mass}).tcol == Approx(tcol).epsilon(1e-11));
  }
  // The elastic law has k alone; sqrt(k m) stands for c. And a c past every double is none.
  const auto spring = Reduction<Fractional>::holding(8, 1, 0, tcol, 2);
  REQUIRE(spring);
  CHECK(spring->c() == 4);
  CHECK_FALSE(Reduction<Fractional>::holding(1e-300, 1, 0.1, 1, 1));
}

TEST_CASE("what is reached ends where rounding takes the digits of e_n", "[tuned]") {
  const Impact impact{0.5, 1.41e-5};
  // Fractional by overlap: 1e-15/e_n^2 > 1e-10 below 10^-2.5 = 0.0031623, told as 0.00317.
  const double least = least_restitution(kind_of<Fractional>, ContactEnd::overlap, 1e-3, 1e-4, impact);
  CHECK(least == Approx(0.00317).epsilon(1e-12));
  CHECK(reaches(kind_of<Fractional>, ContactEnd::overlap, least, 1e-4, impact));
  CHECK_FALSE(reaches(kind_of<Fractional>, ContactEnd::overlap, 0.99 * std::pow(10, -2.5), 1e-4, impact));
  CHECK(reaches(kind_of<Linear>, ContactEnd::overlap, 1e-3, 1e-4, impact));
  // k1/k2 = e_n^2 leaves the range of normal doubles.
  CHECK_FALSE(reaches(kind_of<Hysteretic>, ContactEnd::force, 1e-200, 1e-4, impact));
  CHECK(reaches(kind_of<Hysteretic>, ContactEnd::force, 1e-100, 1e-4, impact));
}
