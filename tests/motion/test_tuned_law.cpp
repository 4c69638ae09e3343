#include <ricochet/contact/fractional_contact.hpp>
#include <ricochet/motion/tuned_law.hpp>

#include <catch2/catch.hpp>

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
      CAPTURE(static_cast<int>(kind), en);
      CHECK(out.tcol == Approx(tcol).epsilon(margin));
      CHECK(out.en == Approx(en).epsilon(margin));
    }
  };
  check(LawKind::linear, ContactEnd::overlap, 1e-11);
  check(LawKind::linear, ContactEnd::force, 1e-11);
  check(LawKind::tsuji, ContactEnd::force, 1e-11);
  check(LawKind::tsuji, ContactEnd::overlap, 1e-11);
  check(LawKind::kuwabara_kono, ContactEnd::force, 1e-10);
  check(LawKind::hysteretic, ContactEnd::force, 1e-11);
  check(LawKind::fractional, ContactEnd::force, 1e-11);
  CHECK_THROWS_AS(tuned_law(LawKind::linear, tcol, 1.0, impact), std::invalid_argument);
  CHECK_THROWS_AS(tuned_law(LawKind::linear, -1, 0.9, impact), std::invalid_argument);
  CHECK_THROWS_AS(tuned_law(LawKind::hysteretic, tcol, 0.9, impact, ContactEnd::overlap), std::invalid_argument);
}
