// The law of docs/adding-a-law.md, as a user would try one that Ricochet does not have.

#include "../../docs/examples/standard_solid.hpp"

#include <ricochet/motion/column.hpp>
#include <ricochet/motion/engine/column_engine.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace ricochet;

static_assert(ContactLaw<StandardSolid>);

namespace {

constexpr double mass = 1e-5, velocity = 0.5, tcol = 1e-4;
constexpr double k = mass * (std::numbers::pi / tcol) * (std::numbers::pi / tcol);

/// One bead on the plate; the restitution, with the energy balance checked on the way.
double restitution(const StandardSolid& law, double step, double gap = 0) {
  ColumnOptions options;
  options.step = step;
  options.duration = 10 * tcol;
  options.energy = true;
  ColumnEngine<StandardSolid> engine(equal_column(1, mass, gap, -velocity), law, law, options);
  const double start = engine.energy().total();
  while (!engine.finished() && engine.time() < options.duration) engine.step();
  REQUIRE(engine.finished());
  CHECK(engine.energy().total() == Approx(start).epsilon(20 * (step / tcol) * (step / tcol)));
  return engine.velocity(0) / velocity;
}

}  // namespace

TEST_CASE("an added law has the limits that its equation has") {
  const double step = tcol / 400;
  // A frozen arm is a second spring, an arm that flows at once is no arm: both elastic.
  CHECK(restitution({k, k, 1e6 * tcol}, step) == Approx(1).epsilon(1e-4));
  CHECK(restitution({k, k, 1e-7 * tcol}, step) == Approx(1).epsilon(1e-4));
  // In between it loses energy.
  CHECK(restitution({k, k, 0.2 * tcol}, step) < 0.9);
}

TEST_CASE("an added law is stepped to second order by the column engine") {
  const StandardSolid law(k, k, 0.2 * tcol);
  const double exact = restitution(law, tcol / 51200);
  // The error depends on where in a step the contact starts and ends: it is averaged over starts.
  const auto error = [&](double step) {
    double sum = 0;
    for (int i = 0; i < 16; ++i) sum += std::abs(restitution(law, step, (i + 0.5) / 16 * velocity * step) - exact);
    return sum / 16;
  };
  CHECK(std::log2(error(tcol / 200) / error(tcol / 800)) / 2 == Approx(2).margin(0.2));
}

TEST_CASE("an added law runs in run_column as its engine does, and its step is bounded there") {
  const StandardSolid law(k, k, 0.2 * tcol);
  const Column column = equal_column(5, mass, 1e-6, -velocity);
  ColumnOptions options{.step = tcol / 200, .duration = 100 * tcol};
  const ColumnResult ran = run_column(column, law, law, options);
  CHECK(ran.end == ColumnEnd::separated);
  CHECK(ran.energy_ratio < 1);
  ColumnEngine<StandardSolid> engine(column, law, law, options);
  for (std::size_t n = 0; n < ran.steps; ++n) {
    if (!engine.any_contact()) engine.skip_free_flight();
    engine.step();
  }
  for (std::size_t i = 0; i < engine.beads(); ++i) CHECK(engine.velocity(i) == ran.velocity[i]);
  options.step = 1.01 * largest_step(column, law, law);
  CHECK_THROWS_WITH(run_column(column, law, law, options), Catch::StartsWith("step = "));
}

// Of laws whose slopes are written down the bound found by numbers alone must be the same: of a linear one to the
// bisection, 2^{-40}; of Hertzian ones theirs is a bound, at an overlap that no collision passes, and near it for weak
// damping: at c = 0 the overlap reaches it to the per mille of the walk.
TEST_CASE("the largest step of an added law is that of the slopes it shows") {
  const Column one = equal_column(1, mass, 0, -velocity);
  const auto by_numbers = [&](const auto& law) {
    collision::Driven driven(law);
    return motion::stable_step(driven, 1 / mass, mass, velocity);
  };
  for (const double ratio : {0.0, 0.1, 1.0, 10.0}) {
    const Linear law(k, 2 * ratio * std::sqrt(k * mass));
    CAPTURE(ratio);
    CHECK(by_numbers(law) == Approx(largest_step(one, law, law)).epsilon(1e-9));
  }
  CHECK(by_numbers(Hysteretic(k, 4 * k)) == Approx(largest_step(one, Hysteretic(k, 4 * k), Hysteretic(k, 4 * k))));
  const Tsuji hertz(1e6, 0);
  const double bound = largest_step(one, hertz, hertz);
  CHECK(by_numbers(hertz) >= 0.95 * bound);  // a step's mean sees the slope beyond the greatest overlap, too
  CHECK(by_numbers(hertz) <= 1.01 * bound);
  // An arm that never flows is a second spring; the generic mean_force carries it exactly.
  const Linear twice(2 * k, 0);
  const StandardSolid frozen(k, k, 1e6 * tcol);
  CHECK(largest_step(one, frozen, frozen) == Approx(largest_step(one, twice, twice)).epsilon(1e-6));
}
