#include "column_cases.hpp"

#include <ricochet/motion/engine/column_engine.hpp>
#include <ricochet/motion/event_driven_column.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <type_traits>

using namespace ricochet;
using namespace column_cases;

TEST_CASE("The largest step is where the scheme turns unstable", "[column]") {
  // A bead pressed on the plate by gravity never leaves it: a linear motion that rests below the bound and grows above.
  const auto shakes = [](const auto& law, const AnyLaw& any, double share) {
    Column column = equal_column(1, mass, 0, 0);
    column.gravity = 9.81;
    const double step = share * largest_step(column, any, any);
    ColumnOptions o{.step = step, .duration = 1, .end = ContactEnd::overlap};
    ColumnEngine<std::decay_t<decltype(law)>> engine(column, law, law, o);
    double jump = 0;  // of the velocity from step to step: the unstable mode alternates, a creeping overlap does not
    for (int n = 0; n < 4000; ++n) {
      const double before = engine.velocity(0);
      engine.step();
      if (n >= 3000) jump = std::max(jump, std::abs(engine.velocity(0) - before));
    }
    return !(jump < 1e-3 * 9.81 * step);  // from about 9.81 step on the bead hops
  };
  const double k = linear(mass, 0.9).k(), critical = 2 * std::sqrt(mass * k);
  for (const double ratio : {0.05, 0.5, 1.0, 10.0}) {
    const Linear law(k, ratio * critical);
    CAPTURE(ratio);
    CHECK_FALSE(shakes(law, law, 0.97));
    CHECK(shakes(law, law, 1.03));
  }
  for (const double alpha : {0.3, 0.7}) {
    const Fractional ideal = fractional(mass, alpha);
    const auto arms = [&](double share) {
      const double step = share * largest_step(equal_column(1, mass, 0, 0), ideal, ideal);
      return FractionalArms(ideal, memory_kernel(alpha, step, 1e4 * step, 1e-6), step);
    };
    CAPTURE(alpha);
    CHECK_FALSE(shakes(arms(0.97), ideal, 0.97));
    CHECK(shakes(arms(1.03), ideal, 1.03));
  }
}

TEST_CASE("A step that cannot resolve the contacts is refused, and no column gains energy below it", "[column]") {
  const Column column = equal_column(3, mass, 1e-6, velocity);
  const auto check = [&](const AnyLaw& plate, const AnyLaw& pair, ContactEnd end) {
    const double largest = largest_step(column, plate, pair);
    ColumnOptions o{.step = 1.01 * largest, .duration = 10, .end = end};
    CHECK_THROWS_WITH(run_column(column, plate, pair, o),
                      Catch::StartsWith("step = ") && Catch::Contains("must be at most"));
    o.step = 10 * tcol;
    CHECK_THROWS_AS(run_column(column, plate, pair, o), std::invalid_argument);
    for (const double share : {1.0, 0.7, 0.3}) {
      o.step = share * largest;
      const ColumnResult r = run_column(column, plate, pair, o);
      CAPTURE(share);
      CHECK(r.end == ColumnEnd::separated);
      CHECK(r.energy_ratio < 1);
    }
  };
  check(linear(mass, 0.9), linear(mass / 2, 0.9), ContactEnd::overlap);
  check(linear(mass, 0.9), linear(mass / 2, 0.9), ContactEnd::force);
  check(hysteretic(mass, 0.9), hysteretic(mass / 2, 0.9), ContactEnd::force);
  check(kuwabara_kono(mass), kuwabara_kono(mass / 2), ContactEnd::force);
  check(tsuji(mass), tsuji(mass / 2), ContactEnd::force);
  check(fractional(mass, 0.3), fractional(mass / 2, 0.3), ContactEnd::force);
}

TEST_CASE("A light bead between heavy ones is squeezed by their energy, which the largest step knows", "[column]") {
  // On the plate, under a hundred thousand times its mass: a binary collision of its own presses it far less.
  const Column column{{1e-6, 0.1}, {0, 0}, {velocity, velocity}};
  const auto energy = [&](const auto& law, double share) {
    const double step = share * largest_step(column, law, law);
    const ColumnResult r = motion::run(column, law, law, {.step = step, .duration = 2000 * step / share});
    return r.end == ColumnEnd::broke_down ? std::nan("") : r.energy_ratio;
  };
  const auto check = [&](const auto& law) {
    CHECK(energy(law, 1) == Approx(energy(law, 0.3)).epsilon(0.01));
    CHECK(std::isnan(energy(law, 2)));  // as the step by its own collisions does, thrice as long
  };
  check(KuwabaraKono(1e7, 1));
  check(Tsuji(1e7, 0.1));
  // For a lone bead it is the energy of its own collision, and for beads that fly apart there is none.
  const Tsuji hertz(1e7, 0);
  const double overlap = std::pow(1.25 * mass * velocity * velocity / 1e7, 0.4), slope = 1.5 * 1e7 * std::sqrt(overlap);
  CHECK(largest_step(equal_column(1, mass, 0, velocity), hertz, hertz) ==
        Approx(std::sqrt(mass / slope)).epsilon(1e-12));
  CHECK(std::isinf(largest_step(equal_column(2, mass, 0, -velocity), hertz, hertz)));
}

TEST_CASE("A column that breaks down says so and gives no numbers", "[column]") {
  // Nothing moves at the start, so that nothing tells how stiff the Hertzian contact will be that the fall from 1 m
  // makes.
  Column column = equal_column(3, mass, 1, 0);
  column.gravity = 9.81;
  const ColumnResult r = run_column(column, tsuji(mass), tsuji(mass), {.step = 100 * tcol, .duration = 1000});
  CHECK(r.end == ColumnEnd::broke_down);
  CHECK(r.velocity.empty());
  CHECK(r.energy_ratio == 0);
}

TEST_CASE("Misuse of a column is named", "[column]") {
  const Linear law = linear(mass, 0.9);
  const ColumnOptions o = options(100, ContactEnd::force);
  CHECK_THROWS_AS(run_column({}, law, law, o), std::invalid_argument);
  CHECK_THROWS_AS(run_column({{mass}, {0, 0}, {velocity}}, law, law, o), std::invalid_argument);
  CHECK_THROWS_AS(run_column(equal_column(2, mass, -1e-6, velocity), law, law, o), std::invalid_argument);
  CHECK_THROWS_AS(run_column(equal_column(2, -mass, 0, velocity), law, law, o), std::invalid_argument);
  CHECK_THROWS_AS(run_column(equal_column(2, mass, 0, velocity), law, hysteretic(mass, 0.9), o), std::invalid_argument);
  CHECK_THROWS_AS(run_column(equal_column(2, mass, 0, velocity), law, law, ColumnOptions{}), std::invalid_argument);
  CHECK_THROWS_AS(event_driven_column(equal_column(2, mass, 0, velocity), 1.1), std::invalid_argument);
  const auto memory = [&](double shortest, double longest, double tolerance) {
    ColumnOptions with = o;
    with.shortest_memory = shortest, with.longest_memory = longest, with.memory_tolerance = tolerance;
    return run_column(equal_column(1, mass, 0, velocity), fractional(mass, 0.3), fractional(mass, 0.3), with);
  };
  CHECK_THROWS_WITH(memory(0, 0, 0), "memory_tolerance = 0: must be in [1e-12, 0.1]");
  CHECK_THROWS_WITH(memory(-1, 0, 1e-6), "shortest_memory = -1: must be finite and >= 0");
  CHECK_THROWS_WITH(memory(0, std::nan(""), 1e-6), "longest_memory = nan: must be finite and >= 0");
  CHECK_THROWS_WITH(memory(0, 5, 1e-6), Catch::StartsWith("longest_memory = 5: must be at most 1e6 of the shortest"));
  CHECK_THROWS_WITH(memory(0, 0, 1e-12),
                    Catch::StartsWith("memory_tolerance = 1e-12: must be at least ") &&
                        Catch::EndsWith("at alpha = 0.3 with a longest memory of 1e+05 shortest ones"));
}
