#include <catch2/catch.hpp>
#include <ricochet/contact/mean_force.hpp>
#include <ricochet/ricochet.hpp>

#include <boost/math/quadrature/gauss.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace ricochet;

namespace {

/// force·rate − d(stored_energy)/dt by central differences of the overlap at a steady rate: what the dashpots burn.
template <class Law>
double burnt(const Law& law, Approach a) {
  const typename Law::Memory none{};
  const double dt = 1e-5 * a.overlap / std::abs(a.rate);
  const auto stored = [&](double t) { return law.stored_energy({a.overlap + a.rate * t, a.rate}, none); };
  return law.force(a, none) * a.rate - (stored(dt) - stored(-dt)) / (2 * dt);
}

template <class Law>
void check_energy_balance(const Law& law) {
  for (const Approach a : {Approach{0.01, 0.5}, Approach{0.3, -2.0}, Approach{4.0, 1.0}}) {
    // Central differences at a relative step of 1e-5 leave 1e-10 of the truncation and 1e-11 of rounding.
    const double scale = std::abs(law.force(a, {}) * a.rate);
    CHECK(burnt(law, a) == Approx(law.dissipated_power(a, {})).margin(1e-9 * scale));
    CHECK(law.dissipated_power(a, {}) >= 0);
  }
}

/// Mean of a force over an overlap that runs from one value to another. In s = ζ^{1/4} every power here is a
/// polynomial, which Gauss's rule integrates as it stands.
template <class Law>
double mean_by_quadrature(const Law& law, double from, double to, double rate) {
  const auto force = [&](double s) { return law.force({s * s * s * s, rate}, {}) * 4 * s * s * s; };
  const double a = std::sqrt(std::sqrt(from)), b = std::sqrt(std::sqrt(to));
  return boost::math::quadrature::gauss<double, 15>::integrate(force, a, b) / (to - from);
}

template <class Law>
void check_mean_force(const Law& law) {
  for (const auto& [from, to] : {std::pair(1e-5, 3e-5), std::pair(3e-5, 1e-5), std::pair(0.0, 2e-5),
                                 std::pair(2e-5, 0.0), std::pair(1e-5, 1.0001e-5)})
    for (const double dt : {1e-5, 1e-3}) {
      const double rate = (to - from) / dt;
      CAPTURE(Law::name, from, to, dt);
      CHECK(mean_force(law, from, rate, {}, dt) == Approx(mean_by_quadrature(law, from, to, rate)).epsilon(1e-11));
    }
}

}  // namespace

TEST_CASE("a law rejects parameters outside its domain and names them") {
  CHECK_THROWS_WITH(Linear(-1, 0), "k = -1: must be finite and > 0");
  CHECK_THROWS_WITH(Linear(0, 0), "k = 0: must be finite and > 0");
  CHECK_THROWS_WITH(Linear(1, -0.5), "c = -0.5: must be finite and >= 0");
  CHECK_THROWS_WITH(Linear(std::numeric_limits<double>::quiet_NaN(), 0), Catch::Contains("must be finite and > 0"));
  CHECK_THROWS_WITH(KuwabaraKono(std::numeric_limits<double>::infinity(), 0), "k = inf: must be finite and > 0");
  CHECK_THROWS_WITH(KuwabaraKono(1, -1), "c = -1: must be finite and >= 0");
  CHECK_THROWS_WITH(Tsuji(1, -1), "c = -1: must be finite and >= 0");
  CHECK_THROWS_WITH(Hysteretic(2, 1), "k1 = 2: must be at most k2");
  CHECK_THROWS_WITH(Hysteretic(0, 1), "k1 = 0: must be finite and > 0");
  CHECK_THROWS_WITH(Fractional(1, 0, 0.5), "c = 0: must be finite and > 0");
  CHECK_THROWS_WITH(Fractional(1, 1, 2), "alpha = 2: must be finite and < 2");
}

TEST_CASE("the forces are the formulas of the model") {
  const Approach a{4e-6, -0.25};
  CHECK(Linear(5000, 0.1).force(a, {}) == Approx(5000 * 4e-6 - 0.1 * 0.25).epsilon(1e-15));
  CHECK(KuwabaraKono(1.4e6, 34).force(a, {}) == Approx(1.4e6 * 8e-9 - 34 * 2e-3 * 0.25).epsilon(1e-14));
  CHECK(Tsuji(1.4e6, 2).force(a, {}) == Approx(1.4e6 * 8e-9 - 2 * std::pow(4e-6, 0.25) * 0.25).epsilon(1e-14));
  CHECK(Fractional(5000, 0.1, 0.25).coefficient() == Approx(std::pow(0.1, 0.25) * std::pow(5000, 0.75)).epsilon(1e-14));
}

TEST_CASE("the mean of a force over a step is its integral") {
  check_mean_force(Linear(5000, 0.1));
  check_mean_force(KuwabaraKono(1.4e6, 34));
  check_mean_force(Tsuji(1.4e6, 2));
  // Past the greatest overlap so far, where 4 N are reached: a third of the way from 2 N to 4 N, the rest on to 5 N.
  const Hysteretic bent(1000, 4000);
  const Hysteretic::Memory pressed{4e-3};
  CHECK(mean_force(bent, 3.5e-3, 1.5, pressed, 1e-3) == Approx(4).epsilon(1e-14));
  CHECK(mean_force(bent, 5e-3, -1.5, pressed, 1e-3) == Approx(4).epsilon(1e-14));
}

TEST_CASE("a fractional law of order 0 is its k, of order 1 its c") {
  CHECK(Fractional(5000, 0.1, 0).coefficient() == 5000);
  CHECK(Fractional(5000, 0.1, 1).coefficient() == Approx(0.1).epsilon(1e-15));
}

TEST_CASE("Hertzian laws know no force, energy or loss without overlap") {
  for (const double overlap : {0.0, -1e-6}) {
    CHECK(KuwabaraKono(1e6, 30).force({overlap, 1}, {}) == 0);
    CHECK(Tsuji(1e6, 30).force({overlap, 1}, {}) == 0);
    CHECK(KuwabaraKono(1e6, 30).stored_energy({overlap, 1}, {}) == 0);
    CHECK(Tsuji(1e6, 30).dissipated_power({overlap, 1}, {}) == 0);
  }
}

TEST_CASE("power is either stored or dissipated") {
  check_energy_balance(Linear(3, 0.7));
  check_energy_balance(KuwabaraKono(3, 0.7));
  check_energy_balance(Tsuji(3, 0.7));
}

namespace {

/// Drives the law through random strokes of steady rate and compares, at a random place of each, force·rate with what
/// is stored and burnt. Returns how often the force was attractive there.
template <class Law>
int check_contract(const Law& law, double scale, double speed, double shortest_time, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> overlap(0.02, 1), share(0.1, 0.9), pace(0.2, 1);
  typename Law::Memory memory{};
  Approach now{0, 0};
  int attractive = 0;
  for (int stroke = 0; stroke < 200; ++stroke) {
    const double to = scale * overlap(random), rate = std::copysign(speed * pace(random), to - now.overlap);
    const double length = (to - now.overlap) / rate, when = share(random) * length;
    const auto at = [&](double t) { return Approach{now.overlap + rate * t, rate}; };
    const auto after = [&](double t) {
      auto then = memory;
      law.advance(then, at(0), at(t), t);
      return then;
    };
    const double dt = std::min(1e-4 * shortest_time, 1e-4 * when);
    const auto stored = [&](double t) { return law.stored_energy(at(t), after(t)); };
    const double force = law.force(at(when), after(when)), burnt = law.dissipated_power(at(when), after(when));
    const double kink =
        law.force(at(when + dt), after(when + dt)) - 2 * force + law.force(at(when - dt), after(when - dt));
    const double growth = (stored(when + dt) - stored(when - dt)) / (2 * dt);
    CHECK(burnt >= 0);
    // A central difference leaves (dt/time)² = 1e-8 of the power, and the rounding of the stored energy over dt.
    const double power = std::abs(force * rate) + burnt + std::abs(growth);
    const double rounding = 4e-16 * stored(when) / dt;
    const bool smooth = std::abs(kink) <= 1e-6 * (std::abs(force) + std::sqrt(stored(when) * power / speed / scale));
    if (smooth) CHECK(std::abs(force * rate - growth - burnt) <= 1e-7 * power + rounding);
    attractive += smooth && force < 0;
    memory = after(length);
    now = at(length);
  }
  return attractive;
}

}  // namespace

TEST_CASE("power is stored or dissipated along any path, also where the force is attractive") {
  const double scale = 1e-5, speed = 0.5, time = scale / speed;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    CAPTURE(seed);
    CHECK(check_contract(Linear(5000, 0.2), scale, speed, time, seed) > 10);
    CHECK(check_contract(KuwabaraKono(1.4e6, 60), scale, speed, time, seed) > 10);
    CHECK(check_contract(Tsuji(1.4e6, 2), scale, speed, time, seed) > 10);
    CHECK(check_contract(Hysteretic(1e4, 3e4), scale, speed, time, seed) > 10);
    const MemoryKernel kernel = memory_kernel(0.3, 1e-7, 1e-2, 1e-6);
    const FractionalArms arms(Fractional(5000, 0.3, 0.3), kernel, 1e-7);
    CHECK(check_contract(arms, scale, speed, 1e-8, seed) > 10);
  }
}

TEST_CASE("repulsion pushes only, and only in contact") {
  const Linear law(1000, 1);
  CHECK(repulsion(law, {1e-3, 0.1}, {}) == Approx(1.1));
  CHECK(repulsion(law, {1e-3, -2}, {}) == 0);
  CHECK(repulsion(law, {-1e-3, 5}, {}) == 0);
  CHECK(repulsion(law, {0, 5}, {}) == 0);
}

TEST_CASE("hysteretic: loads along k1, unloads and reloads along k2, and forgets nothing within a contact") {
  const Hysteretic law(1000, 4000);
  Hysteretic::Memory memory;
  CHECK(law.force({2e-3, 1}, memory) == Approx(2.0));
  law.advance(memory, {0, 1}, {4e-3, 1}, 1e-3);
  CHECK(memory.max_overlap == 4e-3);
  CHECK(law.residual_overlap(memory) == Approx(3e-3));
  CHECK(law.force({3.5e-3, -1}, memory) == Approx(2.0));
  CHECK(law.force({3.5e-3, +1}, memory) == Approx(2.0));
  law.advance(memory, {4e-3, -1}, {3.2e-3, -1}, 1e-3);
  CHECK(memory.max_overlap == 4e-3);
  CHECK(law.force({3e-3, -1}, memory) == Approx(0).margin(1e-15));
  CHECK(law.force({2e-3, -1}, memory) < 0);
  law.advance(memory, {3.2e-3, 1}, {5e-3, 1}, 1e-3);
  CHECK(law.force({5e-3, 1}, memory) == Approx(5.0));
}

TEST_CASE("hysteretic: what loading does not give back is the area between the branches") {
  const Hysteretic law(1000, 4000);
  Hysteretic::Memory memory;
  const double deepest = 4e-3, work = 0.5 * law.k1() * deepest * deepest;
  law.advance(memory, {0, 1}, {deepest, 1}, 1e-3);
  CHECK(law.stored_energy({deepest, 0}, memory) == Approx(work * law.k1() / law.k2()));
  // The loss grows as ∫ k₁(1 − k₁/k₂)ζ dζ while loading, and not at all on the way back.
  CHECK(law.dissipated_power({deepest, 1}, memory) == Approx(1000 * 0.75 * deepest));
  CHECK(law.dissipated_power({3.5e-3, -1}, memory) == 0);
}

TEST_CASE("any law tells its name") {
  CHECK(name(AnyLaw(Linear(1, 1))) == "linear");
  CHECK(name(AnyLaw(KuwabaraKono(1, 1))) == "kuwabara-kono");
  CHECK(name(AnyLaw(Tsuji(1, 1))) == "tsuji");
  CHECK(name(AnyLaw(Hysteretic(1, 1))) == "hysteretic");
  CHECK(name(AnyLaw(Fractional(1, 1, 0.5))) == "fractional");
}
