#include <calibrate/advice.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

constexpr Impact impact{.velocity = 0.5, .mass_eff = 7.06858e-6};

}  // namespace

TEST_CASE("sensitivities are the exponents of the closed forms") {
  // e_n = sqrt(k1/k2), t_col = (pi/2) sqrt(m/k1) (1 + e_n).
  const auto walton = sensitivities(Hysteretic(4000, 16000), ContactEnd::force, impact);
  CHECK(*walton[0].en == Approx(0.5).epsilon(1e-6));
  CHECK(*walton[1].en == Approx(-0.5).epsilon(1e-6));
  CHECK(*walton[0].tcol == Approx(-0.5 + 0.5 * 0.5 / 1.5).epsilon(1e-6));
  CHECK(*walton[1].tcol == Approx(-0.5 * 0.5 / 1.5).epsilon(1e-6));
  // t_col ~ (c^alpha k^(1-alpha))^(-1/(2-alpha)), e_n of alpha alone.
  const double alpha = 0.3;
  const auto fractional = sensitivities(Fractional(5000, 0.3, alpha), ContactEnd::force, impact);
  CHECK(*fractional[0].tcol == Approx(-(1 - alpha) / (2 - alpha)).epsilon(1e-6));
  CHECK(*fractional[1].tcol == Approx(-alpha / (2 - alpha)).epsilon(1e-6));
  CHECK(*fractional[0].en == Approx(0).margin(1e-6));
  CHECK(*fractional[1].en == Approx(0).margin(1e-6));
  // A spring has no c to move, and k1 cannot rise above k2.
  CHECK_FALSE(sensitivities(Linear(5000, 0), ContactEnd::overlap, impact)[1].en);
  CHECK_FALSE(sensitivities(Hysteretic(4000, 4000), ContactEnd::force, impact)[0].en);
}

TEST_CASE("the error of a plain engine's step falls in proportion to it") {
  const Linear law(7316.0209, 0.0979913);
  const Collision exact = collide(law, impact, {.end = ContactEnd::overlap});
  const auto errors = step_errors(law, ContactEnd::overlap, {exact.tcol, exact.en, impact});
  const auto at = [&](int steps) {
    for (const StepError& e : errors)
      if (e.steps == steps) return e.error;
    return std::nan("");
  };
  CHECK(std::log10(at(100) / at(1000)) == Approx(1).margin(0.1));
  const int enough = steps_for(errors, 0.01).value();
  CHECK(at(enough) <= 0.01);
  CHECK_FALSE(steps_for(errors, 1e-9));
}
