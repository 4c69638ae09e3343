// The law of docs/adding-a-law.md, as a user would try one that Ricochet does not have.

#include "../../docs/examples/standard_solid.hpp"

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
