#include <first_touch.hpp>
#include <half_step_contact.hpp>

#include <catch2/catch.hpp>

#include <cmath>

using namespace ricochet;
using namespace ricochet::half_step;

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
  CHECK(rate_at_end(linear(-0.5), linear(-1.5), 0) == Approx(linear(0)).epsilon(1e-15));
  CHECK(rate_at_end(quadratic(-0.5), quadratic(-1.5), quadratic(-2.5)) == Approx(quadratic(0)).epsilon(1e-14));
}

TEST_CASE("a force about to end carries what is left of its ramp, any other is left as it is") {
  // A ramp with the slope s that ends θ of a step ahead; the area from half a step before on is the weight's.
  const double slope = 3;
  for (double theta : {0.1, 0.5, 0.99})
    CHECK(last_weighted(slope * theta, slope * (theta + 1)) == Approx(slope * start_weight(1, theta)).epsilon(1e-12));
  CHECK(last_weighted(1.0, 1.9) == 1.0);  // it lasts longer than a step
  CHECK(last_weighted(2.0, 1.0) == 2.0);  // it rises
  CHECK(last_weighted(-1.0, 1.0) == -1.0);
}

TEST_CASE("the first kicks of the laws have their limits") {
  const double rate = 0.7, dt = 0.01;
  const auto spring = [&](double theta) { return rate * dt * start_weight(1, theta); };
  for (double theta : {1e-4, 0.3, 1.0})
    for (double alpha : {0.2, 0.5, 0.9}) {
      CAPTURE(theta, alpha);
      const double voigt = first_kick(FractionalKelvinVoigt(2, 3, alpha), rate, theta, dt);
      CHECK(voigt - 2 * spring(theta) == Approx(first_kick(Fractional(3, 3, alpha), rate, theta, dt)).epsilon(1e-12));
      // Fast against τ the arm is its spring, slow its springpot of k1 τ^α.
      CHECK(first_kick(FractionalZener(2, 3, 1e40, alpha), rate, theta, dt) == Approx(5 * spring(theta)).epsilon(1e-6));
      const double tau = 1e-40, stiff = 3 * std::pow(tau, -alpha);
      CHECK(first_kick(FractionalZener(2, stiff, tau, alpha), rate, theta, dt) ==
            Approx(voigt).margin(4e-5 * 3 * rate * std::pow(dt, 1 - alpha) / std::tgamma(2 - alpha)));
      // Hertz's with α = 0 is one spring, with α = 1 a dashpot of f' = (3/2) ζ^{1/2} ζ'.
      const double hertz = std::pow(rate * dt, 1.5);
      CHECK(first_kick(FractionalHertz(2, 3, 0), rate, theta, dt) ==
            Approx(5 * hertz * start_weight(1.5, theta)).epsilon(1e-12));
      CHECK(first_kick(FractionalHertz(2, 3, 1), rate, theta, dt) ==
            Approx(hertz * (2 * start_weight(1.5, theta) + 4.5 / dt * start_weight(0.5, theta))).epsilon(1e-12));
    }
  CHECK(first_kick(FractionalZener(2, 3, 0.1, 0), rate, 0.4, dt) == Approx(3.5 * spring(0.4)).epsilon(1e-12));
}

TEST_CASE("with a law's first kick a sum of kicks loses its start error") {
  // Σ dt F((k + θ) dt) of the force at a constant rate against its integral, both up to a time after which they differ
  // by the trapezoid's end alone: what is left is of second order, as without the weight it is of order 1 + p < 2.
  const FractionalZener law(2, 30, 0.02, 0.7);
  const auto work = [&](double t) { return first_work(law, 1, t); };
  const auto force = [&](double t) { return (work(t + 1e-5 * t) - work(t - 1e-5 * t)) / (2e-5 * t); };
  const auto error = [&](double theta, int kicks) {
    const double dt = 1 / (kicks + theta);
    double sum = first_kick(law, 1, theta, dt) + 0.5 * force(1);
    for (int k = 1; k < kicks; ++k) sum += force((k + theta) * dt);
    return std::abs(sum * dt - work(1));
  };
  for (double theta : {0.03, 0.4, 0.97}) {
    CAPTURE(theta, error(theta, 40), error(theta, 80), error(theta, 160));
    CHECK(std::log2(error(theta, 40) / error(theta, 160)) / 2 == Approx(2).margin(0.2));
  }
}
