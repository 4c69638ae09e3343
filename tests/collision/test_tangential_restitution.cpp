#include <catch2/catch.hpp>
#include <ricochet/collision/tangential_restitution.hpp>

#include <cmath>
#include <numbers>

using namespace ricochet;

namespace {

/// u after tcol from u = 1, by the fourth-order Taylor map of u'' + 2D u' + W² u = 0, whose state matrix is stepped by
/// squaring: e^{A t} = (e^{A t/2^n})^{2^n}.
double stepped(const LinearTangential& law, double tcol, double mass_eff) {
  const double m = 2.0 / 7 * mass_eff;
  constexpr int squarings = 16;
  const double h = tcol / std::pow(2.0, squarings);
  // (ξ, u)' = ((0, 1), (−k/m, −c/m)): entries of e^{A h} by its series.
  struct Map {
    double a, b, c, d;
    Map operator*(const Map& o) const {
      return {a * o.a + b * o.c, a * o.b + b * o.d, c * o.a + d * o.c, c * o.b + d * o.d};
    }
  };
  const Map rate{0, h, -law.k_t() / m * h, -law.c_t() / m * h};
  Map power = rate, map{1 + rate.a, rate.b, rate.c, 1 + rate.d};
  for (const double n : {2.0, 3.0, 4.0, 5.0}) {
    power = power * rate;
    power = {power.a / n, power.b / n, power.c / n, power.d / n};
    map = {map.a + power.a, map.b + power.b, map.c + power.c, map.d + power.d};
  }
  for (int n = 0; n < squarings; ++n) map = map * map;
  return map.d;
}

}  // namespace

TEST_CASE("the spring made for a tangential restitution has it") {
  const double tcol = 3e-5, mass = 2.6e-4;
  for (const double beta0 : {1e-3, 0.1, 0.5, 0.9, 1.0}) {
    const LinearTangential law = tangential_for(beta0, tcol, mass);
    CHECK(sticking_restitution(law, tcol, mass) == Approx(beta0).epsilon(1e-13));
    CHECK(-stepped(law, tcol, mass) == Approx(beta0).epsilon(1e-10));
  }
  for (const double beta0 : {-0.99, -0.5, 0.0, 0.5, 0.99, 1.0}) {
    const LinearTangential law = tangential_for(beta0, tcol, mass, StickingForm::undamped);
    CHECK(law.c_t() == 0);
    CHECK(sticking_restitution(law, tcol, mass) == Approx(beta0).margin(1e-14));
    CHECK(-stepped(law, tcol, mass) == Approx(beta0).margin(1e-10));
  }
}

TEST_CASE("at full reversal both forms are the same half period") {
  const LinearTangential damped = tangential_for(1, 2, 7), undamped = tangential_for(1, 2, 7, StickingForm::undamped);
  CHECK(damped.c_t() == 0);
  CHECK(damped.k_t() == Approx(undamped.k_t()).epsilon(1e-15));
  CHECK(damped.k_t() == Approx(2 * std::pow(std::numbers::pi / 2, 2)).epsilon(1e-15));
}

TEST_CASE("an oscillator is followed through critical damping") {
  for (const double c : {1.0, 3.999999, 4.0, 4.000001, 40.0, 4e3}) {
    const LinearTangential law(2, c);  // m_t = 2: critical at c = 4
    CHECK(sticking_restitution(law, 1.5, 7) == Approx(-stepped(law, 1.5, 7)).margin(1e-9));
  }
  CHECK(sticking_restitution(LinearTangential(1, 1e300), 1, 7) == Approx(0).margin(1e-12));
}

TEST_CASE("a restitution outside its form's domain is refused") {
  CHECK_THROWS_WITH(tangential_for(0, 1, 1), "beta0 = 0: must be > 0 and <= 1 (damped form)");
  CHECK_THROWS_WITH(tangential_for(1.1, 1, 1, StickingForm::undamped), "beta0 = 1.1: must be > -1 and <= 1");
  CHECK_THROWS(tangential_for(-1, 1, 1, StickingForm::undamped));
  CHECK_THROWS(tangential_for(0.5, 0, 1));
  CHECK_THROWS(sticking_restitution(LinearTangential(1), 1, -1));
}
