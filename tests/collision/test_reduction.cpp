#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/reduction.hpp>

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
