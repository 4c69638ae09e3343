#include "column_cases.hpp"

#include <ricochet/motion/engine/column_engine.hpp>
#include <ricochet/motion/event_driven_column.hpp>

#include <catch2/catch.hpp>

#include <array>
#include <vector>

using namespace ricochet;
using namespace column_cases;

namespace {

/// A second opinion on columns of linear contacts that end by overlap: classical Runge-Kutta on the whole column, each
/// step cut by bisection where the first overlap changes sign. Shares nothing with the engine.
class LinearColumnByRungeKutta {
 public:
  LinearColumnByRungeKutta(int beads, double en) : nc_(beads), plate_(linear(mass, en)), pair_(linear(mass / 2, en)) {
    position_.assign(nc_, 0.0);
    velocity_.assign(nc_, column_cases::velocity);
    on_.assign(nc_, true);  // touching: every overlap starts to grow at once
  }

  double energy_ratio(double step) {
    while (!over()) {
      const auto before = *this;
      advance(step);
      if (changed() < 0) continue;
      double low = 0, high = step;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        *this = before;
        advance(middle);
        (changed() < 0 ? low : high) = middle;
      }
      *this = before;
      advance(high);
      on_[changed()] ^= true;
    }
    double sum = 0;
    for (const double v : velocity_) sum += v * v;
    return sum / (nc_ * column_cases::velocity * column_cases::velocity);
  }

 private:
  using Vector = std::vector<double>;

  double overlap(const Vector& x, int j) const { return (j ? x[j - 1] : 0.0) - x[j]; }
  /// The first contact whose state does not fit its overlap, beyond rounding; −1 for none.
  int changed() const {
    for (int j = 0; j < nc_; ++j) {
      const double z = overlap(position_, j), rate = overlap(velocity_, j);
      if (on_[j] ? z < -1e-17 && rate < 0 : z > 1e-17 && rate > 0) return j;
    }
    return -1;
  }
  bool over() const {
    for (int j = 0; j < nc_; ++j)
      if (on_[j] || overlap(velocity_, j) > 1e-9) return false;
    return true;
  }
  Vector acceleration(const Vector& x, const Vector& v) const {
    Vector a(nc_, 0.0);
    for (int j = 0; j < nc_; ++j)
      if (on_[j]) {
        const double force = (j ? pair_ : plate_).force({overlap(x, j), overlap(v, j)}, {});
        a[j] += force / mass;
        if (j) a[j - 1] -= force / mass;
      }
    return a;
  }
  void advance(double h) {
    const auto shifted = [](const Vector& y, double s, const Vector& slope) {
      Vector result(y);
      for (std::size_t i = 0; i < y.size(); ++i) result[i] += s * slope[i];
      return result;
    };
    const Vector& x = position_;
    const Vector v1 = velocity_, a1 = acceleration(x, v1);
    const Vector v2 = shifted(velocity_, h / 2, a1), a2 = acceleration(shifted(x, h / 2, v1), v2);
    const Vector v3 = shifted(velocity_, h / 2, a2), a3 = acceleration(shifted(x, h / 2, v2), v3);
    const Vector v4 = shifted(velocity_, h, a3), a4 = acceleration(shifted(x, h, v3), v4);
    for (int i = 0; i < nc_; ++i) {
      position_[i] += h / 6 * (v1[i] + 2 * v2[i] + 2 * v3[i] + v4[i]);
      velocity_[i] += h / 6 * (a1[i] + 2 * a2[i] + 2 * a3[i] + a4[i]);
    }
  }

  int nc_;
  Linear plate_, pair_;
  Vector position_, velocity_;
  std::vector<char> on_;
};

}  // namespace

TEST_CASE("One bead is the binary collision with the wall", "[column]") {
  // At 20000 steps a contact (h/t_col)² is 2.5e-9. The zero of the force is found from mean forces of two steps, which
  // costs its time another factor of up to 10.
  const auto check = [](const auto& law, ContactEnd end) {
    CollideOptions exact;
    exact.end = end;
    const Collision binary = collide(law, {-velocity, mass}, exact);
    REQUIRE(binary.separated());
    ColumnOptions o{.step = binary.tcol / 20000, .duration = 1, .end = end};
    const ColumnResult one = run_column(equal_column(1, mass, 1.3e-6, velocity), law, law, o);
    CHECK(one.end == ColumnEnd::separated);
    CHECK(one.contacts == 1);
    CHECK(one.velocity[0] / -velocity == Approx(binary.en).epsilon(0).margin(1e-8));
    CHECK(one.last_contact_time == Approx(binary.tcol).epsilon(2.5e-8));
  };
  for (const double en : {0.945, 0.6, 0.2}) {
    check(linear(mass, en), ContactEnd::overlap);
    check(linear(mass, en), ContactEnd::force);
    check(hysteretic(mass, en), ContactEnd::force);
  }
  check(kuwabara_kono(mass), ContactEnd::force);
  check(tsuji(mass), ContactEnd::force);
}

TEST_CASE("Touching linear beads keep the energy of an independent integration", "[column]") {
  struct Case {
    int beads;
    double known;  // from one independent calculation, good to 1e-4
  };
  const auto law = [](double m) { return linear(m, 0.9); };
  for (const Case c : {Case{2, 0.840066}, {5, 0.879607}, {10, 0.905986}, {20, 0.929928}}) {
    const double ratio = energy_ratio(c.beads, 0, law, options(400, ContactEnd::overlap));
    CHECK(ratio == Approx(c.known).margin(1e-4));
    if (c.beads <= 10) {
      // Of second order, the engine's error at 400 steps is a third of what it changes from 200 to 400; a whole change
      // leaves room for the scatter of events. Runge-Kutta errs by (π/200)⁴/120 = 5e-10 a contact, a hundredth of 1e-7.
      const double second = LinearColumnByRungeKutta(c.beads, 0.9).energy_ratio(tcol / 200);
      const double coarse = energy_ratio(c.beads, 0, law, options(200, ContactEnd::overlap));
      CHECK(ratio == Approx(second).margin(std::abs(ratio - coarse) + 1e-7));
    }
  }
}

TEST_CASE("Wide gaps make the event-driven column", "[column]") {
  // A collision's e_n errs by ε, taken as the worst of one bead touching the plate at ten places of a step. It moves a
  // bead's energy by 2ε, and a bead meets 2nc collisions at most.
  for (const int beads : {1, 2, 3, 7, 12}) {
    const Column column = equal_column(beads, mass, 1.0, velocity);
    const EventDrivenResult hard = event_driven_column(column, 0.9);
    CHECK(hard.status == EventDrivenResult::Status::separated);
    const auto check = [&](const AnyLaw& plate, const AnyLaw& pair, ContactEnd end) {
      ColumnOptions o = options(400, end);
      o.duration = 1e5;
      double worst = 0;
      for (int place = 0; place < 10; ++place) {
        const Column one = equal_column(1, mass, 1e-6 - 0.1 * place * velocity * o.step, velocity);
        worst = std::max(worst, std::abs(run_column(one, plate, pair, o).velocity[0] / (-0.9 * velocity) - 1));
      }
      const ColumnResult soft = run_column(column, plate, pair, o);
      CHECK(soft.end != ColumnEnd::out_of_time);
      CHECK(soft.contacts == hard.collisions);
      CHECK(soft.energy_ratio == Approx(hard.energy_ratio).epsilon(4 * worst * beads));
    };
    check(linear(mass, 0.9), linear(mass / 2, 0.9), ContactEnd::overlap);
    check(hysteretic(mass, 0.9), hysteretic(mass / 2, 0.9), ContactEnd::force);
  }
}

TEST_CASE("Small gaps detach: constant laws lose less than the event-driven column, and not more with more beads",
          "[column]") {
  double last = 0;
  for (const int beads : {2, 5, 10, 20}) {
    const double soft = energy_ratio(
        beads, 0, [](double m) { return linear(m, 0.9); }, options(100, ContactEnd::overlap));
    CHECK(soft > event_driven_column(equal_column(beads, mass, 1e-6, velocity), 0.9).energy_ratio);
    CHECK(soft > last);
    last = soft;
  }
}

TEST_CASE("A column is of second order through every start and end of contact", "[column]") {
  // Errors of E/E0 against a run 8 times finer than the finest, over three halvings; the slope of their logarithms.
  // The reference's own error is 1/64 of the finest one's, which moves the slope by at most 0.02.
  const auto check = [](int beads, double gap, auto law, ContactEnd end) {
    const double exact = energy_ratio(beads, gap, law, options(6400, end));
    std::vector<double> errors;
    for (const int steps : {100, 200, 400, 800})
      errors.push_back(std::abs(energy_ratio(beads, gap, law, options(steps, end)) - exact));
    // Least squares through four equidistant points.
    const double slope = (3 * std::log2(errors[0] / errors[3]) + std::log2(errors[1] / errors[2])) / 10;
    CAPTURE(beads, gap, errors);
    CHECK(slope == Approx(2.0).margin(0.2));
  };
  check(
      1, 1e-6, [](double m) { return linear(m, 0.9); }, ContactEnd::overlap);
  check(
      3, 1e-6, [](double m) { return linear(m, 0.9); }, ContactEnd::overlap);
  check(
      5, 0, [](double m) { return linear(m, 0.9); }, ContactEnd::overlap);
  check(
      3, 1e-6, [](double m) { return linear(m, 0.9); }, ContactEnd::force);
  check(5, 1e-6, kuwabara_kono, ContactEnd::force);
  check(5, 1e-6, tsuji, ContactEnd::force);
}

TEST_CASE("It does not matter where in a step a contact starts and ends", "[column]") {
  // The time of separation, from where the bead flies afterwards, is wrong by E/n² at n steps a contact. While n grows
  // by one, the end moves once through a step; gaps move the start. Were a moment of the impulse missing, E would
  // follow the phase by up to c t_col/(8m) = −ln(e_n)/4 (½ I (h − s) of the active part s, with I = c v s): 0.026 at
  // e_n = 0.9, 0.4 at 0.2. What is left are terms of third order: some units over n.
  const double n0 = 400, bound = 4 / n0;
  for (const double en : {0.9, 0.5, 0.2}) {
    const Linear law = linear(mass, en);
    double low = 1e300, high = -1e300;
    for (const double gap : {0.0, 1.3e-6, 1.32e-6, 1.35e-6, 1.39e-6})
      for (int phase = 0; phase < 8; ++phase) {
        const double n = n0 + phase / 8.0;
        const ColumnOptions o{.step = tcol / n, .duration = 1, .end = ContactEnd::overlap};
        ColumnEngine<Linear> bead(equal_column(1, mass, gap, velocity), law, law, o);
        while (!bead.finished()) bead.step();
        const double separation = bead.time() + bead.overlap(0) / bead.velocity(0) + gap / velocity;
        const double error = (separation / tcol - 1) * n * n;
        low = std::min(low, error), high = std::max(high, error);
      }
    CAPTURE(en, low, high);
    CHECK(high - low < bound);
  }
}

TEST_CASE("A column of fractional contacts is of second order at any conversion degree", "[column]") {
  // Ratio of successive differences: no reference needed. The kernel's 1e-9 is far below the finest difference.
  for (const double alpha : {0.0293504, 0.3196786, 0.6})
    for (const int beads : {1, 3}) {
      std::vector<double> ratio;
      for (const int steps : {100, 200, 400, 800}) {
        ColumnOptions o = options(steps, ContactEnd::force);
        o.longest_memory = 1e-3;
        o.memory_tolerance = 1e-9;
        ratio.push_back(energy_ratio(
            beads, 1e-6, [&](double m) { return fractional(m, alpha); }, o));
      }
      CAPTURE(alpha, beads, ratio);
      CHECK(std::log2((ratio[1] - ratio[0]) / (ratio[2] - ratio[1])) == Approx(2).margin(0.25));
      CHECK(std::log2((ratio[2] - ratio[1]) / (ratio[3] - ratio[2])) == Approx(2).margin(0.25));
    }
}

TEST_CASE("One bead rebounds with the restitution of its conversion degree", "[column]") {
  // e_n(α) of the closed form (47)-(57): 0.945 and 0.5 to 7 digits of α.
  const auto rebound = [](double alpha) {
    ColumnOptions o = options(3200, ContactEnd::force);
    o.longest_memory = 2e-4;
    return run_column(equal_column(1, mass, 1e-6, velocity), fractional(mass, alpha), fractional(mass, alpha), o)
               .velocity[0] /
           -velocity;
  };
  CHECK(rebound(0.0293504) == Approx(0.945).margin(1e-6));
  CHECK(rebound(0.3196786) == Approx(0.5).margin(1e-6));
}

TEST_CASE("Energy closes to the scheme's order and never grows", "[column]") {
  // In units of E0, which passes through each of six contacts once: the trapezoid under the quarter wave of a force
  // errs by (πh/t_col)²/12 of the energy, a single step by h/t_col times π of that.
  constexpr double pi = std::numbers::pi, passes = 6;
  const auto check = [](auto law, ContactEnd end) {
    using Law = decltype(law(mass));
    double coarsest = 0, finest = 0;
    for (const int steps : {100, 200, 400}) {
      ColumnOptions o = options(steps, end);
      o.energy = true;
      ColumnEngine<Law> engine(equal_column(6, mass, 1e-6, velocity), law(mass), law(mass / 2), o);
      const double before = engine.energy().total();
      double mechanical = before, gap = 0, growth = 0;
      while (!engine.finished() && engine.time() < 1) {
        engine.step();
        const ColumnEnergy now = engine.energy();
        gap = std::max(gap, std::abs(now.total() - before) / before);
        growth = std::max(growth, (now.kinetic + now.stored - mechanical) / before);
        mechanical = now.kinetic + now.stored;
      }
      CAPTURE(Law::name, steps);
      CHECK(engine.finished());
      const double x = pi / steps;
      CHECK(gap < passes * x * x / 12);
      CHECK(growth < passes * x * x * x / 12);
      CHECK(engine.energy().dissipated > 0);
      (steps == 100 ? coarsest : finest) = gap;
    }
    CHECK(finest < coarsest / 8);  // second order would be a sixteenth; which step an event falls in scatters it
  };
  check([](double m) { return linear(m, 0.9); }, ContactEnd::overlap);
  check([](double m) { return linear(m, 0.9); }, ContactEnd::force);
  check([](double m) { return hysteretic(m, 0.9); }, ContactEnd::force);
  check(kuwabara_kono, ContactEnd::force);
  check(tsuji, ContactEnd::force);
  const MemoryKernel kernel = memory_kernel(0.0293504, tcol / 400, 2e-3, 1e-7);
  check([&](double m) { return FractionalArms(fractional(m, 0.0293504), kernel, tcol / 400); }, ContactEnd::force);
}

TEST_CASE("An elastic column keeps its energy", "[column]") {
  const auto law = [](double m) { return Linear(linear(m, 0.9).k(), 0); };
  for (const double gap : {0.0, 1e-6, 1e-4})
    CHECK(energy_ratio(8, gap, law, options(400, ContactEnd::force)) == Approx(1).margin(1e-6));
}

TEST_CASE("Velocities do not depend on frame, mirror image or unit of mass", "[column]") {
  // Far from the plate and moving away from it, a column is a free cluster.
  const std::vector<double> v{6.2, 6.0, 5.9, 5.1}, m{1.41e-5, 0.7e-5, 2e-5, 1e-5}, g{1e3, 1e-6, 2e-6, 0.5e-6};
  const Linear law = linear(1e-5, 0.8);
  const ColumnOptions o = options(100, ContactEnd::force);
  const ColumnResult r = run_column({m, g, v}, law, law, o);
  REQUIRE(r.end == ColumnEnd::separated);
  REQUIRE(r.contacts >= 3);
  double before = 0, after = 0;
  for (int i = 0; i < 4; ++i) before += m[i] * v[i], after += m[i] * r.velocity[i];
  CHECK(after == Approx(before).epsilon(1e-12));

  std::vector<double> shifted(v), mirrored(v), mirrored_mass(m), heavy(m);
  for (int i = 0; i < 4; ++i) {
    shifted[i] = v[i] + 3;
    mirrored[i] = 20 - v[3 - i];
    mirrored_mass[i] = m[3 - i];
    heavy[i] = 1024 * m[i];
  }
  const ColumnResult in_frame = run_column({m, g, shifted}, law, law, o);
  const ColumnResult in_mirror = run_column({mirrored_mass, {g[0], g[3], g[2], g[1]}, mirrored}, law, law, o);
  const ColumnResult in_units =
      run_column({heavy, g, v}, Linear(1024 * law.k(), 1024 * law.c()), Linear(1024 * law.k(), 1024 * law.c()), o);
  for (int i = 0; i < 4; ++i) {
    CHECK(in_frame.velocity[i] == Approx(r.velocity[i] + 3).epsilon(1e-9));
    CHECK(in_mirror.velocity[i] == Approx(20 - r.velocity[3 - i]).epsilon(1e-9));
    CHECK(in_units.velocity[i] == r.velocity[i]);  // a power of two changes no digit
  }
}

TEST_CASE(
    "A pair that stays silent until it has separated lets beads pass through each other, a single contact does not "
    "notice",
    "[column]") {
  const auto law = [](double m) { return hysteretic(m, 0.3); };
  ColumnOptions repels = options(200, ContactEnd::force), silent = repels;
  silent.reclosing = Reclosing::silent;
  CHECK(energy_ratio(1, 1e-6, law, silent) == energy_ratio(1, 1e-6, law, repels));
  // Eight beads at e_n = 0.3 come almost to rest; those that sink through each other keep their energy.
  CHECK(energy_ratio(8, 1e-6, law, repels) < 0.1);
  CHECK(energy_ratio(8, 1e-6, law, silent) > 0.5);
}

TEST_CASE("Beads that approach by next to nothing while they still touch are at rest", "[column]") {
  const auto end = [](double negligible) {
    ColumnOptions o = options(200, ContactEnd::force);
    o.negligible_approach = negligible;
    return run_column(equal_column(1, mass, 1e-6, velocity), linear(mass, 0.2), linear(mass / 2, 0.2), o).end;
  };
  // The force is gone at 0.16 m/s, some 50 steps before the overlap is.
  CHECK(end(0.5) == ColumnEnd::resting);
  CHECK(end(1e-9) == ColumnEnd::separated);
}

TEST_CASE("A bead that falls gains energy and has not broken down", "[column]") {
  Column column = equal_column(1, mass, 1, velocity);
  column.gravity = 9.81;
  const Linear law = linear(mass, 0.3);
  const ColumnResult r = run_column(column, law, law, {.step = tcol / 100, .duration = 0.1});
  CHECK(r.end == ColumnEnd::out_of_time);
  CHECK(r.velocity[0] == Approx(-1.481).epsilon(1e-4));  // −0.5 m/s − g·0.1 s
  CHECK(r.energy_ratio == Approx(1.481 * 1.481 / 0.25).epsilon(1e-4));
}

TEST_CASE("Under gravity a bead comes to rest where its weight is carried", "[column]") {
  const Linear law = linear(mass, 0.3);
  Column column = equal_column(1, mass, 1e-7, 0);
  column.gravity = 9.81;
  ColumnOptions o{.step = tcol / 100, .duration = 0.05, .energy = true};
  const ColumnResult r = run_column(column, law, law, o);
  CHECK(r.end == ColumnEnd::out_of_time);
  CHECK(std::abs(r.velocity[0]) < 1e-9);
  const double sunk = -r.energy.potential / (mass * 9.81);
  CHECK(sunk == Approx(mass * 9.81 / law.k()).epsilon(1e-6));
  CHECK(r.energy.total() == Approx(mass * 9.81 * 1e-7).epsilon(1e-5));  // m g gap at the start
}

// Ended by force the pair still overlaps while it opens. A hysteretic spring cannot push any more: nothing is left to
// come. The arms of a fractional contact relax meanwhile and may: it is over when the pair has parted.
TEST_CASE("A column is over when its contacts' memories can no longer wake", "[column]") {
  const auto slack_in_contact = [](auto& engine) {
    while (!(engine.velocity(0) > 0)) engine.step();
    for (double before = -1; engine.velocity(0) != before;) before = engine.velocity(0), engine.step();
    REQUIRE(engine.any_contact());
    REQUIRE(engine.overlap(0) > 0);
    return !engine.finished();
  };
  const ColumnOptions o = options(400, ContactEnd::force);
  const Column one = equal_column(1, mass, 1e-7, velocity);
  const Fractional ideal = fractional(mass, 0.6);
  const FractionalArms arms(ideal, memory_kernel(0.6, o.step, 1000 * o.step, 1e-6), o.step);
  ColumnEngine<FractionalArms> fractional_engine(one, arms, arms, o);
  CHECK(slack_in_contact(fractional_engine));
  const Hysteretic spring = hysteretic(mass, 0.6);
  ColumnEngine<Hysteretic> hysteretic_engine(one, spring, spring, o);
  CHECK_FALSE(slack_in_contact(hysteretic_engine));
}
