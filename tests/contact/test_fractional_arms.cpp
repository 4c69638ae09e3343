#include <ricochet/contact/fractional.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

using namespace ricochet;

namespace {

/// D^α of a rate that starts as v0 + a t at 0: v0 t^{1−α}/Γ(2−α) + a t^{2−α}/Γ(3−α).
double derivative_of_ramp(double alpha, double v0, double a, double t) {
  return v0 * std::pow(t, 1 - alpha) / std::tgamma(2 - alpha) + a * std::pow(t, 2 - alpha) / std::tgamma(3 - alpha);
}

const double orders[] = {0.05, 0.2, 0.5, 0.8, 0.95};

}  // namespace

TEST_CASE("FractionalArms reproduce D^α of a piecewise linear rate at the ends of steps not below δ") {
  const double delta = 1e-6;
  for (const double alpha : orders) {
    CAPTURE(alpha);
    const Fractional law(5000, 0.3, alpha);
    const FractionalArms arms(law, memory_kernel(alpha, delta, 100 * delta, 1e-11), delta);
    FractionalArms::Memory memory;
    double t = 0, overlap = 0;
    const double v0 = 0.5, a = -9e3, kink = 40 * delta, bend = 2.5e4;
    const auto rate = [&](double s) { return v0 + a * s + (s > kink ? bend * (s - kink) : 0); };
    for (int i = 0; i < 60; ++i) {
      // Nominal steps first, then steps that only the general path knows.
      const double dt = i < 41 ? delta : 1.7 * delta, next = i < 40 ? (i + 1) * delta : t + dt;
      const Approach before{overlap, rate(t)};
      overlap += 0.5 * (rate(t) + rate(next)) * (next - t);
      const Approach after{overlap, rate(next)};
      arms.advance(memory, before, after, i < 40 ? delta : next - t);
      t = next;
      if (t > 95 * delta) break;
      double exact = derivative_of_ramp(alpha, v0, a, t);
      if (t > kink) exact += derivative_of_ramp(alpha, 0, bend, t - kink);
      CHECK(arms.force(after, memory) == Approx(law.coefficient() * exact).epsilon(2e-11).margin(1e-12));
    }
  }
}

TEST_CASE("An arm's step is exact over five decades of rate times dt") {
  // A single arm under a linear rate: q = (b/s)(1 − e^{−x}) + (a/s²)(x − 1 + e^{−x}), in long double.
  const double alpha = 0.5;
  const MemoryKernel kernel = memory_kernel(alpha, 1, 1e5, 1e-6);
  const FractionalArms arms(Fractional(1, 1, alpha), kernel, 1);
  for (const double dt : {1e-3, 0.1, 1.0, 7.0, 300.0, 1e5}) {
    FractionalArms::Memory memory;
    arms.advance(memory, {0, 2}, {0, 5}, dt);
    for (std::size_t j = 0; j < arms.arms(); ++j) {
      const long double s = kernel.arms()[j].rate, x = s * dt;
      long double ramp = x + std::expm1(-x);  // x − 1 + e^{−x}
      if (x < 1e-2L) ramp = x * x * (0.5L - x / 6 + x * x / 24 - x * x * x / 120 + x * x * x * x / 720);
      const long double q = 2 / s * -std::expm1(-x) + 3 / dt / (s * s) * ramp;
      CHECK(memory.elongation[j] == Approx(double(q)).epsilon(1e-13));
    }
  }
}

TEST_CASE("force·rate = d(stored)/dt + dissipated for FractionalArms") {
  for (const double alpha : orders) {
    CAPTURE(alpha);
    const Fractional law(5000, 0.3, alpha);
    const FractionalArms arms(law, memory_kernel(alpha, 1e-6, 1e-4, 1e-8), 1e-6);
    FractionalArms::Memory memory;
    const double w = std::numbers::pi / 1e-4;
    const auto at = [&](double t) { return Approach{0.5 / w * std::sin(w * t), 0.5 * std::cos(w * t)}; };
    double t = 0;
    for (; t < 3.05e-5; t += 1e-6) arms.advance(memory, at(t), at(t + 1e-6), 1e-6);
    // A central difference of the stored energy over ±h; backwards in time the arms run as well.
    const double h = 2e-9;
    FractionalArms::Memory ahead = memory, behind = memory;
    arms.advance(ahead, at(t), at(t + h), h);
    arms.advance(behind, at(t), at(t - h), -h);
    const double power = (arms.stored_energy(at(t + h), ahead) - arms.stored_energy(at(t - h), behind)) / (2 * h);
    const double work = arms.force(at(t), memory) * at(t).rate;
    CHECK(power + arms.dissipated_power(at(t), memory) == Approx(work).epsilon(1e-6));
    CHECK(arms.dissipated_power(at(t), memory) > 0);
    CHECK(arms.stored_energy(at(t), memory) > 0);
  }
}

TEST_CASE("The limits of FractionalArms are the spring and the dashpot") {
  const MemoryKernel spring = memory_kernel(0, 1e-6, 1e-4, 1e-8), dashpot = memory_kernel(1, 1e-6, 1e-4, 1e-8);
  const FractionalArms elastic(Fractional(5000, 0.3, 0), spring, 1e-6);
  const FractionalArms viscous(Fractional(5000, 0.3, 1), dashpot, 1e-6);
  const FractionalArms::Memory none;
  CHECK(elastic.force({1e-5, 0.2}, none) == Approx(5000 * 1e-5).epsilon(1e-15));
  CHECK(viscous.force({1e-5, 0.2}, none) == Approx(0.3 * 0.2).epsilon(1e-15));
}

TEST_CASE("FractionalArms refuse a kernel of another order or with too many arms") {
  const Fractional law(5000, 0.3, 0.3);
  CHECK_THROWS_WITH(FractionalArms(law, memory_kernel(0.31, 1, 100, 1e-4), 1), Catch::Contains("kernel alpha = 0.31"));
  CHECK_THROWS_WITH(FractionalArms(law, memory_kernel(0.3, 1, 1e6, 1e-8), 1), Catch::Contains("kernel arms"));
  CHECK_THROWS_WITH(FractionalArms(law, memory_kernel(0.3, 1, 100, 1e-4), 0), Catch::Contains("step = 0"));
}

TEST_CASE("A collision by FractionalArms has the restitution of the closed form") {
  // Steps fine enough that the second-order step error is far below the bound; e_n is −E_{2−α,1}(−z*).
  struct {
    double alpha, en, tau;
  } cases[] = {{0.03125, 0.94151044447350612861, 3.1167757923696375332},
               {0.0625, 0.88530126103356068260, 3.0930202460162310133}};
  for (const auto& c : cases) {
    CAPTURE(c.alpha);
    const double dt = 3.2 / 4000;
    const Fractional law(1, 1, c.alpha);  // A = 1: unit mass and coefficient, so t_col = tau
    const FractionalArms arms(law, memory_kernel(c.alpha, dt, 4, 1e-9), dt);
    FractionalArms::Memory memory;
    Approach a{0, 1};
    double t = 0, force = 0;
    for (;;) {
      // Exponential trapezoid: the force at the new end is linear in the new rate, so one step is solved exactly.
      const auto residual = [&](double rate, FractionalArms::Memory& m, Approach& after, double& f) {
        after = {a.overlap + 0.5 * dt * (a.rate + rate), rate};
        m = memory;
        arms.advance(m, a, after, dt);
        f = arms.force(after, m);
        return rate - a.rate + 0.5 * dt * (force + f);
      };
      FractionalArms::Memory m;
      Approach after;
      double f;
      const double r0 = residual(0, m, after, f), r1 = residual(1, m, after, f);
      residual(-r0 / (r1 - r0), m, after, f);
      if (t > 1 && f <= 0) {
        const double part = force / (force - f);
        // Near its zero the force is linear: the rate changes by half of what is left of it.
        CHECK(-(a.rate - 0.5 * part * dt * force) == Approx(c.en).epsilon(2e-6));
        CHECK(t + part * dt == Approx(c.tau).epsilon(2e-6));
        break;
      }
      REQUIRE(t < 4);
      memory = m;
      a = after;
      force = f;
      t += dt;
    }
  }
}

TEST_CASE("a step in one pass is the step and what the law then says, of any number of arms") {
  constexpr double step = 1e-6;
  std::set<std::size_t> numbers;
  for (const double tolerance : {0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8, 1e-10}) {
    const FractionalArms arms(Fractional(5000, 0.3, 0.3), memory_kernel(0.3, step, 1000 * step, tolerance), step);
    numbers.insert(arms.arms());
    FractionalArms::Memory one, two;
    Approach before{0, 0.2};
    for (int n = 0; n < 30; ++n) {
      const double rate = 0.2 * std::cos(0.1 * n);
      const Approach after{before.overlap + 0.5 * step * (before.rate + rate), rate};
      const double foreseen = arms.force_after(before, after, one);
      arms.advance(one, before, after, step);
      const MaxwellArms::Reading read = arms.advance_and_read(two, before, after);
      REQUIRE(one == two);
      CHECK(read.force == Approx(arms.force(after, one)).epsilon(1e-13));
      CHECK(foreseen == Approx(arms.force(after, one)).epsilon(1e-13));
      CHECK(read.stored == Approx(arms.stored_energy(after, one)).epsilon(1e-13));
      CHECK(read.dissipated == Approx(arms.dissipated_power(after, one)).epsilon(1e-13));
      before = after;
    }
  }
  CHECK(std::count_if(numbers.begin(), numbers.end(), [](std::size_t n) { return n % 2 == 1; }) > 0);
  CHECK(std::count_if(numbers.begin(), numbers.end(), [](std::size_t n) { return n % 2 == 0; }) > 0);
}
