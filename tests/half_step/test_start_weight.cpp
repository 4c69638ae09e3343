#include <half_step_contact.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace ricochet::liggghts;

TEST_CASE("the weight of the first kick is minus the Hurwitz zeta function where that is known") {
  // −ζ(0, a) = a − 1/2, −ζ(−1, a) = B₂(a)/2, ζ(s, 1) = ζ(s), ζ(s, 2) = ζ(s) − 1 and ζ(−1/2) = −0.2078862249773545….
  for (double theta : {1e-6, 0.1, 0.5, 0.9, 1.0}) {
    CHECK(start_weight(0, theta) == Approx(theta + 0.5).margin(1e-12));
    CHECK(start_weight(1, theta) == Approx((theta * theta + theta + 1.0 / 6) / 2).margin(1e-12));
  }
  CHECK(start_weight(0.5, 0) == Approx(0.2078862249773545).margin(1e-7));
  CHECK(start_weight(0.5, 1) == Approx(1.2078862249773545).margin(1e-7));
}

TEST_CASE("with the weight a sum of kicks loses its error of order 1 + p") {
  // ∫₀^∞ t^p e^{−t} dt = Γ(1+p). What is left of the start's error is that of the next power, t^{1+p}: order 2 + p.
  const auto error = [](double p, double theta, double h) {
    double sum = start_weight(p, theta) * std::pow(h, p);
    for (double t = (1 + theta) * h; t < 60; t += h) sum += std::pow(t, p) * std::exp(-t);
    return std::abs(h * sum - std::tgamma(1 + p));
  };
  for (double p : {0.05, 0.3, 0.7, 0.95})
    for (double theta : {0.03, 0.4, 0.97}) {
      CAPTURE(p, theta);
      CHECK(std::log2(error(p, theta, 0.02) / error(p, theta, 0.01)) == Approx(2 + p).margin(0.1));
    }
}

TEST_CASE("the rate at a step's end is exact for rates as smooth as its points allow") {
  const auto linear = [](double t) { return 2 - 3 * t; };
  const auto quadratic = [](double t) { return 2 - 3 * t + 5 * t * t; };
  CHECK(half_step::rate_at_end(linear(-0.5), linear(-1.5), 0) == Approx(linear(0)).epsilon(1e-15));
  CHECK(half_step::rate_at_end(quadratic(-0.5), quadratic(-1.5), quadratic(-2.5)) ==
        Approx(quadratic(0)).epsilon(1e-14));
}

TEST_CASE("a force about to end carries what is left of its ramp, any other is left as it is") {
  // A ramp with the slope s that ends θ of a step ahead; the area from half a step before on is the weight's.
  const double slope = 3;
  for (double theta : {0.1, 0.5, 0.99})
    CHECK(half_step::last_weighted(slope * theta, slope * (theta + 1)) ==
          Approx(slope * start_weight(1, theta)).epsilon(1e-12));
  CHECK(half_step::last_weighted(1.0, 1.9) == 1.0);  // it lasts longer than a step
  CHECK(half_step::last_weighted(2.0, 1.0) == 2.0);  // it rises
  CHECK(half_step::last_weighted(-1.0, 1.0) == -1.0);
}
