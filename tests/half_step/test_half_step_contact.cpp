#include <half_step_contact.hpp>

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/reduction.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace ricochet;
using namespace ricochet::half_step;

namespace {

using History = std::array<double, HalfStepContact::size>;

struct Bounce {
  double en = 0;
  double unbalanced = 0;  // (kinetic energy lost − energy dissipated)/kinetic energy before
};

/// A unit mass that meets a wall at unit speed, by velocity Verlet; the touch lies at `phase` of a step. t_col = 1.
template <class Law>
Bounce bounce(const Law& law, int steps_per_contact, double phase) {
  const double dt = 1.0 / steps_per_contact;
  const LocatedContact<Law> contact(law, dt, 2);
  History history{};
  double overlap = -(2 + phase) * dt, rate = 1, force = 0, dissipated = 0;
  for (int step = 1; step <= 2 * steps_per_contact; ++step) {
    rate -= 0.5 * dt * force;
    overlap += dt * rate;
    force = 0;
    if (overlap > 0) {
      const History before = history;
      contact.advance(history.data(), step, overlap, rate, dt);
      force = ContactHistory::repulsion(history.data());
      dissipated += contact.dissipated_energy(before.data(), history.data(), dt);
    }
    rate -= 0.5 * dt * force;
  }
  return {-rate, 1 - rate * rate - 2 * dissipated};
}

constexpr std::array phases{0.03, 0.25, 0.5, 0.75, 0.97};

}  // namespace

TEST_CASE(
    "A bounce has the restitution of the conversion degree, to second order in the step, wherever the touch falls") {
  for (double alpha : {0.05, 0.3196786, 0.6}) {
    const double en = fractional_contact(alpha).en;
    std::vector<double> worst, leak;
    for (int steps : {50, 100, 200, 400}) {
      worst.push_back(0), leak.push_back(0);
      for (double phase : phases) {
        const Bounce b = bounce(Reduction<Fractional>::of_degree(alpha), steps, phase);
        worst.back() = std::max(worst.back(), std::abs(b.en / en - 1));
        leak.back() = std::max(leak.back(), std::abs(b.unbalanced));
      }
    }
    CAPTURE(alpha, worst, leak);
    CHECK(std::log2(worst[0] / worst[3]) / 3 == Approx(2).margin(0.15));
    // The dashpots' power starts as t^{1−α}, which the trapezoid sums to order 2 − α.
    CHECK(std::log2(leak[0] / leak[3]) / 3 == Approx(2 - alpha).margin(0.15));
  }
}

namespace {

struct Orders {
  double en, leak;
};

/// Largest over the phases, between 50 and 400 steps; of what is not balanced the order.
template <class Law>
Orders observed_orders(const Law& law) {
  const double en = collide(law, {1, 1}).en;
  std::vector<double> worst, leak;
  for (int steps : {50, 100, 200, 400}) {
    worst.push_back(0), leak.push_back(0);
    for (double phase : phases) {
      const Bounce b = bounce(law, steps, phase);
      worst.back() = std::max(worst.back(), std::abs(b.en / en - 1));
      leak.back() = std::max(leak.back(), std::abs(b.unbalanced));
    }
  }
  CAPTURE(worst, leak);
  CHECK(worst[0] <= 1e-3);
  return {std::log2(worst[0] / worst[3]) / 3, std::log2(leak[0] / leak[3]) / 3};
}

template <class Law>
Law taking_unit_time(double en, const Held& held) {
  return Reduction<Law>::unit(en, ContactEnd::force, held)->law;
}

}  // namespace

TEST_CASE("A bounce under a law of a real solid is of second order too") {
  for (double alpha : {0.25, 0.5, 0.8}) {
    CAPTURE(alpha);
    const auto voigt = observed_orders(taking_unit_time<FractionalKelvinVoigt>(0.7, {alpha}));
    CHECK(voigt.en == Approx(2).margin(0.15));
    CHECK(voigt.leak == Approx(2 - alpha).margin(0.2));  // as above
    const auto zener = observed_orders(taking_unit_time<FractionalZener>(0.8, {alpha, 30}));
    CHECK(zener.en == Approx(2).margin(0.15));
    const auto hertz = observed_orders(taking_unit_time<FractionalHertz>(0.7, {alpha}));
    CHECK(hertz.en == Approx(2).margin(0.15));
    CHECK(hertz.leak == Approx(std::min(2.0, 2.5 - alpha)).margin(0.2));
  }
}

TEST_CASE("The rate at a step's end is exact for one that changes linearly, from three rates for a quadratic one") {
  for (const double bend : {0., 0.7}) {
    const auto rate = [&](double steps) { return 2 - 3 * steps + bend * steps * steps; };  // at steps from now
    if (bend == 0) CHECK(rate_at_end(rate(-0.5), rate(-1.5), 0) == Approx(rate(0)).epsilon(1e-14));
    CHECK(rate_at_end(rate(-0.5), rate(-1.5), rate(-2.5)) == Approx(rate(0)).epsilon(1e-14));
  }
}

TEST_CASE("A force that ends within the next step has the weight of a ramp's first kick, seen from its end") {
  const double fall = 3;
  for (const double theta : {0.01, 0.4, 0.99})
    CHECK(last_weighted(theta * fall, (1 + theta) * fall) == Approx(fall * start_weight(1, theta)).epsilon(1e-6));
  CHECK(last_weighted(1.01 * fall, 2.01 * fall) == 1.01 * fall);  // it goes on
  CHECK(last_weighted(-0.1, 1) == -0.1);
}

TEST_CASE("At a constant rate the force is the derivative's closed form, whatever the steps") {
  // D^α(vt) = v t^{1−α}/Γ(2−α), to the kernel's error; only the first step is weighted for the engine's sum.
  const double dt = 0.01, v = 0.7;
  for (double alpha : {0.1, 0.5, 0.9}) {
    const HalfStepContact contact(alpha, dt, 10);
    History history{};
    double t = 0;
    for (int step = 1; step <= 60; ++step) {
      const double h = step % 7 == 3 ? 2 * dt : dt;  // an engine may be told another step
      t += step == 1 ? 0.4 * dt : h;                 // the touch lies within the first
      contact.advance(history.data(), step, v * t, v, h);
      if (step == 1) continue;
      CAPTURE(alpha, step);
      REQUIRE(HalfStepContact::repulsion(history.data()) ==
              Approx(v * std::pow(t, 1 - alpha) / std::tgamma(2 - alpha)).epsilon(2 * contact.kernel_error()));
    }
  }
}

namespace {

/// The work up to a time grows with the force there, which the contact has by its arms.
template <class Law>
void check_work(const Law& law) {
  const double dt = 0.01, v = 0.7;
  const LocatedContact<Law> contact(law, dt, 10);
  History history{};
  for (int step = 1; step <= 60; ++step) {
    const double t = (step - 0.6) * dt, h = 1e-4 * t;
    contact.advance(history.data(), step, v * t, v, dt);
    if (step < 10) continue;  // the Hertzian law's rate is no polynomial at the start
    CAPTURE(Law::name, law.alpha(), step);
    REQUIRE((first_work(law, v, t + h) - first_work(law, v, t - h)) / (2 * h * v) ==
            Approx(ContactHistory::repulsion(history.data())).epsilon(1e-3));
  }
}

}  // namespace

TEST_CASE("At a constant rate the work grows with the force") {
  for (double alpha : {0.0, 0.3, 0.8}) {
    check_work(Fractional(2, 3, alpha));
    check_work(FractionalKelvinVoigt(2, 3, alpha));
    check_work(FractionalHertz(2, 3, alpha));
    check_work(FractionalZener(2, 3, 0.1, alpha));
  }
  check_work(FractionalKelvinVoigt(2, 3, 1));
}

TEST_CASE("Without memory the contact is a spring that keeps all energy") {
  const HalfStepContact spring(0, 0.01, 1);
  CHECK(spring.arm_count() == 0);
  CHECK(spring.alpha() == 0);
  History before{}, history{};
  spring.advance(before.data(), 4, 0.02, 1, 0.01);
  history = before;
  spring.advance(history.data(), 5, 0.03, 1, 0.01);
  CHECK(HalfStepContact::repulsion(history.data()) == Approx(0.03).epsilon(1e-15));
  CHECK(spring.stored_energy(history.data()) == Approx(0.5 * 0.03 * 0.03).epsilon(1e-15));
  CHECK(spring.dissipated_energy(before.data(), history.data(), 0.01) == Approx(0).margin(1e-18));
}

TEST_CASE("A history not touched in the step before is stale: the contact starts anew") {
  const double dt = 0.01;
  const HalfStepContact contact(0.4, dt, 1);
  History used{}, fresh{};
  contact.advance(used.data(), 7, 0.004, 1, dt);
  CHECK(HalfStepContact::is_at(used.data(), 7));
  CHECK(HalfStepContact::continues(used.data(), 8));
  CHECK_FALSE(HalfStepContact::continues(used.data(), 9));
  contact.advance(used.data(), 8, 0.014, 1, dt);
  contact.advance(used.data(), 12, 0.003, 1.1, dt);
  contact.advance(fresh.data(), 12, 0.003, 1.1, dt);
  CHECK(used == fresh);
}

TEST_CASE("A pair that overlaps when it is first seen is loaded over one step") {
  const double dt = 0.01;
  const HalfStepContact contact(0.4, dt, 1);
  History history{}, at_rest{};
  contact.advance(history.data(), 1, 0.05, 5, dt);
  contact.advance(at_rest.data(), 1, 0.05, 0, dt);  // 0.05 in one step: a rate of 5
  CHECK(history == at_rest);
}

TEST_CASE("What stays in a contact that no longer repels counts as lost") {
  const double dt = 0.01;
  const HalfStepContact contact(0.4, dt, 1);
  History history{};
  double overlap = 0, lost = 0, work = 0, force = 0;
  for (int step = 1; step <= 20; ++step) {  // pressed for ten steps, then withdrawn until the force has gone
    const double rate = step <= 10 ? 1 : -1;
    const History before = history;
    overlap += rate * dt;
    contact.advance(history.data(), step, overlap, rate, dt);
    const double now = HalfStepContact::repulsion(history.data());
    work += 0.5 * (force + now) * rate * dt;
    lost += contact.dissipated_energy(before.data(), history.data(), dt);
    force = now;
    if (now == 0) break;
  }
  REQUIRE(force == 0);
  REQUIRE(overlap > 0);
  CHECK(contact.stored_energy(history.data()) == 0);
  CHECK(lost == Approx(work).epsilon(0.05));  // the trapezoid at a kink of the rate, ten steps from the start
}

TEST_CASE("A contact that cannot be is named") {
  CHECK_THROWS_WITH(HalfStepContact(1, 0.01, 1), Catch::Contains("alpha = 1"));
  CHECK_THROWS_WITH(HalfStepContact(-0.1, 0.01, 1), Catch::Contains("alpha = -0.1"));
  CHECK_THROWS_WITH(HalfStepContact(0.5, 0, 1), Catch::Contains("dt = 0"));
  CHECK_THROWS_WITH(HalfStepContact(0.5, 0.01, 0.005), Catch::Contains("memory = 0.005"));
}
