#include "column_cases.hpp"

#include <ricochet/motion/event_driven_column.hpp>

#include <catch2/catch.hpp>

using namespace ricochet;
using namespace column_cases;

TEST_CASE("The event-driven column follows gaps that change their rate between collisions", "[column]") {
  // Equal elastic beads swap velocities; by hand, (v1, v2, v3) and the gaps (plate, 2, 3) after each collision:
  // t = 0: (2, 0, -1), (10, 2, 4) | 1: (0, 2, -1), (12, 0, 3) | 2: (0, -1, 2), (12, 2, 0) | 4: (-1, 0, 2), (12, 0, 6)
  // | 16, with the plate: (1, 0, 2), (0, 12, 30) | 28: (0, 1, 2), which is the end.
  const EventDrivenResult out = event_driven_column({{3, 3, 3}, {10, 2, 4}, {2, 0, -1}}, 1);
  CHECK(out.status == EventDrivenResult::Status::separated);
  CHECK(out.collisions == 5);
  CHECK(out.time == Approx(28).epsilon(1e-14));
  CHECK(out.velocity[0] == Approx(0).margin(1e-14));
  CHECK(out.velocity[1] == Approx(1).epsilon(1e-14));
  CHECK(out.velocity[2] == Approx(2).epsilon(1e-14));
}

TEST_CASE("The event-driven column conserves what it must and reports collapse", "[column]") {
  Column elastic = equal_column(5, mass, 1e-3, velocity);
  CHECK(event_driven_column(elastic, 1).energy_ratio == Approx(1).epsilon(1e-12));
  CHECK(event_driven_column(equal_column(1, mass, 1e-3, velocity), 0.7).energy_ratio == Approx(0.49));
  // Independent of the size of equal gaps: nothing but gap/velocity sets a time.
  CHECK(event_driven_column(equal_column(9, mass, 1.0, velocity), 0.9).energy_ratio ==
        Approx(event_driven_column(equal_column(9, mass, 1e-6, velocity), 0.9).energy_ratio).epsilon(1e-10));
  const EventDrivenResult many = event_driven_column(equal_column(60, mass, 1e-3, velocity), 0.8, 100000);
  CHECK(many.status == EventDrivenResult::Status::collapsed);
  CHECK(many.collisions == 100000);
}

TEST_CASE("The event-driven column at the edge of doubles says so, and its energies know no units", "[column]") {
  const auto in_units = [](double kilogram, double metre_a_second) {
    return event_driven_column({{kilogram, 3 * kilogram}, {1, 1}, {0, -metre_a_second}}, 0.5).energy_ratio;
  };
  const double ratio = in_units(1, 1);
  CHECK(ratio > 0);
  CHECK(in_units(0x1p900, 0x1p-300) == ratio);
  CHECK(in_units(0x1p-900, 0x1p600) == ratio);
  // Five masses whose sum is no double.
  CHECK(event_driven_column(equal_column(5, 0x1p1022, 1, -1), 1).energy_ratio == Approx(1));
  // The beads meet after 1e313 s.
  const EventDrivenResult none = event_driven_column({{1, 1}, {1e308, 1e308}, {0, -1e-5}}, 1);
  CHECK(none.status == EventDrivenResult::Status::out_of_range);
  CHECK(none.velocity.empty());
  CHECK(none.time == 0);
}
