// The laws of real solids on Maxwell arms: their limits and where their energy goes.

#include <ricochet/contact/fractional_hertz.hpp>
#include <ricochet/contact/fractional_kelvin_voigt.hpp>
#include <ricochet/contact/fractional_zener.hpp>
#include <ricochet/contact/laws.hpp>
#include <ricochet/contact/mean_force.hpp>

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <numbers>

using namespace ricochet;

namespace {

constexpr double step = 1e-6;
MemoryKernel kernel(double alpha) { return memory_kernel(alpha, step, 1e-4, 1e-8); }

/// ζ along half a sine and back.
Approach along(double t) {
  const double w = std::numbers::pi / 1e-4;
  return {1.1e-5 + 1e-5 * std::sin(w * t - 1), 1e-5 * w * std::cos(w * t - 1)};
}

template <class Arms>
void check_balance(const Arms& arms) {
  typename Arms::Memory memory;
  arms.advance(memory, {0, 0}, along(0), step);
  for (double t = 0; t < 9e-5; t += step) {
    const double h = 2e-9;
    auto ahead = memory;
    arms.advance(ahead, along(t), along(t + h), h);
    const double power = (arms.stored_energy(along(t + h), ahead) - arms.stored_energy(along(t), memory)) / h;
    // Trapezoids: the fastest arms relax by some hundredths within h, so that their square is left.
    const double burnt = arms.dissipated_power(along(t), memory), then = arms.dissipated_power(along(t + h), ahead);
    const double work = arms.force(along(t), memory) * along(t).rate;
    const double after = arms.force(along(t + h), ahead) * along(t + h).rate;
    const double scale = std::abs(arms.force(along(t), memory)) * 0.4 + burnt;
    CHECK(std::abs(power + 0.5 * (burnt + then) - 0.5 * (work + after)) <= 1e-3 * scale);
    CHECK(arms.dissipated_power(along(t), memory) >= 0);
    CHECK(arms.stored_energy(along(t), memory) >= 0);
    arms.advance(memory, along(t), along(t + step), step);
  }
}

}  // namespace

TEST_CASE("the laws of real solids on arms store what they do not burn, and never give more back") {
  for (const double alpha : {0.1, 0.5, 0.9}) {
    CAPTURE(alpha);
    check_balance(FractionalKelvinVoigtArms({5000, 0.3, alpha}, kernel(alpha), step));
    check_balance(FractionalZenerArms({5000, 20000, 1e-5, alpha}, kernel(alpha), step));
    check_balance(FractionalHertzArms({1e6, 2e4, alpha}, kernel(alpha), step));
  }
}

TEST_CASE("at α = 0 and 1 the arms are springs and dashpots") {
  const Approach at{1e-5, 0.2};
  const FractionalKelvinVoigtArms::Memory none;
  CHECK(FractionalKelvinVoigtArms({5000, 300, 0}, kernel(0), step).force(at, none) == Approx(5300 * 1e-5));
  CHECK(FractionalKelvinVoigtArms({5000, 0.3, 1}, kernel(1), step).force(at, none) == Approx(5000 * 1e-5 + 0.3 * 0.2));
  CHECK(FractionalZenerArms({5000, 800, 1, 0}, kernel(0), step).force(at, none) == Approx(5400 * 1e-5));
  const FractionalZenerArms standard({5000, 800, 1e-5, 1}, kernel(1), step);
  REQUIRE(standard.arms() == 1);
  CHECK(standard.relaxation_rate(0) == Approx(1e5).epsilon(1e-14));
  CHECK(standard.stiffness(0) == Approx(800).epsilon(1e-14));
  CHECK(standard.dashpot() == 0);
  const KuwabaraKono viscous(1e6, 1.5 * 20);
  const FractionalHertzArms hertz({1e6, 20, 1}, kernel(1), step);
  CHECK(hertz.force(at, none) == Approx(viscous.force(at, {})).epsilon(1e-14));
  CHECK(mean_force(hertz, 1e-5, 0.2, none, step) == Approx(mean_force(viscous, 1e-5, 0.2, {}, step)).epsilon(1e-13));
  CHECK(hertz.stored_energy(at, none) == Approx(viscous.stored_energy(at, {})).epsilon(1e-14));
  CHECK(hertz.dissipated_power(at, none) == Approx(viscous.dissipated_power(at, {})).epsilon(1e-14));
  CHECK(hertz.rate_gain(step, 1e-5) == Approx(30 * std::sqrt(1e-5)).epsilon(1e-14));
}

TEST_CASE("Zener's arms have the modulus of the kernel's arms in series with a spring") {
  for (const double alpha : {0.05, 0.5, 0.95})
    for (const double tau : {1e-9, 1e-5, 1.0})
      for (const double k1 : {1e-3, 800.0, 1e9}) {
        CAPTURE(alpha, tau, k1);
        const FractionalZener law(5000, k1, tau, alpha);
        const FractionalZenerArms arms(law, kernel(alpha), step);
        const auto parts = fractional_parts(k1 * std::pow(tau, alpha), alpha, kernel(alpha));
        for (const double w : {1e3, 1e5, 1e7}) {
          using Complex = std::complex<double>;
          const Complex s(0, w);
          Complex pot = parts.spring + parts.dashpot * s, got = arms.spring() + arms.dashpot() * s;
          for (const Arm& arm : parts.arms) pot += arm.strength * s / (s + arm.rate);
          for (std::size_t j = 0; j < arms.arms(); ++j) got += arms.stiffness(j) * s / (s + arms.relaxation_rate(j));
          const Complex exact = 5000.0 + k1 * pot / (k1 + pot);
          CHECK(std::abs(got - exact) <= 1e-11 * std::abs(exact));
          for (std::size_t j = 0; j < arms.arms(); ++j) CHECK(arms.stiffness(j) >= 0);
        }
      }
}

TEST_CASE("the arms of a Hertzian contact follow a parabola of f' exactly, and their mean force its integral") {
  const double alpha = 0.5;
  const FractionalHertzArms arms({1e6, 2e4, alpha}, kernel(alpha), step);
  FractionalHertzArms::Memory memory;
  arms.advance(memory, {1e-6, 0.3}, {2e-6, 0.35}, 3e-6);
  // Along a constant rate; f' = 3/2 √ζ ζ' is no parabola there, so the two differ by a share of dt⁴.
  const double dt = 4e-6, rate = 0.1, from = 2e-6;
  const auto after = [&](double t) {
    auto m = memory;
    constexpr int parts = 64;
    for (int i = 0; i < parts; ++i)
      arms.advance(m, {from + rate * t * i / parts, rate}, {from + rate * t * (i + 1) / parts, rate}, t / parts);
    return m;
  };
  auto once = memory;
  arms.advance(once, {from, rate}, {from + rate * dt, rate}, dt);
  CHECK(arms.force({from + rate * dt, rate}, once) ==
        Approx(arms.force({from + rate * dt, rate}, after(dt))).epsilon(1e-5));
  using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
  const double mean = Rule::integrate(
                          [&](double t) {
                            return arms.force({from + rate * t, rate}, after(t));
                          },
                          0.0, dt, 4, 1e-8) /
                      dt;
  CHECK(arms.mean_force(from, rate, memory, dt) == Approx(mean).epsilon(1e-5));
  auto faster = memory;
  arms.advance(faster, {from, rate}, {from + rate * dt, rate + 0.01}, dt);
  CHECK(arms.force({from + rate * dt, rate + 0.01}, faster) - arms.force({from + rate * dt, rate}, once) ==
        Approx(0.01 * arms.rate_gain(dt, from + rate * dt)).epsilon(1e-9));
}

TEST_CASE("a Hertzian contact goes through the engine's step as through one a rounding longer") {
  const FractionalHertzArms arms({1e6, 2e4, 0.5}, kernel(0.5), step);
  const double longer = std::nextafter(step, 1.0);
  FractionalHertzArms::Memory made, computed;
  for (double t = 0; t < 2e-5; t += step) {
    arms.advance(made, along(t), along(t + step), step);
    arms.advance(computed, along(t), along(t + step), longer);
    const Approach now = along(t + step);
    CHECK(arms.force(now, made) == Approx(arms.force(now, computed)).epsilon(1e-12));
    CHECK(arms.mean_force(now.overlap, now.rate, made, step) ==
          Approx(arms.mean_force(now.overlap, now.rate, made, longer)).epsilon(1e-12));
  }
  CHECK(arms.rate_gain(step, 1e-5) == Approx(arms.rate_gain(longer, 1e-5)).epsilon(1e-12));
}

TEST_CASE("misuse of the laws of real solids is named") {
  CHECK_THROWS_WITH(FractionalKelvinVoigt(0, 1, 0.5), Catch::StartsWith("k = 0"));
  CHECK_THROWS_WITH(FractionalKelvinVoigt(1, 1, 1.5), "alpha = 1.5: must be in [0, 1]");
  CHECK_THROWS_WITH(FractionalHertz(0, 0, 0.5), "c = 0: must be finite and > 0 where k = 0");
  CHECK_THROWS_WITH(FractionalZener(1, 1, 0, 0.5), Catch::StartsWith("tau = 0"));
  CHECK_THROWS_WITH(FractionalZenerArms({1, 1, 1, 0.25}, affordable_kernel(0.25, {1, 2100, 1e-12}, 24), 1),
                    Catch::StartsWith("kernel arms = 24"));
  CHECK(unit_text({4, 0, -8, 4}) == "kg s^(alpha-2)");
  CHECK(unit_text({4, -2, -8, 4}) == "kg s^(alpha-2)/m^(1/2)");
}
