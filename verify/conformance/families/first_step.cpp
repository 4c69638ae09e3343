#include "common.hpp"

#include <fmt/format.h>

namespace ricochet::verify::conformance {

std::vector<Case> first_step_cases() {
  constexpr double speed = 0.5, tcol = 1e-4, en = 0.5;
  Body sphere = Body::of_density(1.5e-3, 1000);
  sphere.velocity.x = 0.5 * speed;
  Body other = sphere;
  other.velocity.x = -0.5 * speed;
  std::vector<Case> cases;
  for (const double offset : {0.05, 1.0, 1.95}) {
    Case c{.name = fmt::format("first-step-{:.2f}", offset), .family = "first step"};
    c.title = fmt::format("As normal-linear-force, the touch {} steps after the start", offset);
    c.source =
        fmt::format("{}; an order that holds for one place of the touch in the step only is none", linear_by_force);
    c.how = by_collide;
    c.bodies = touching(sphere, other);
    c.law = calibrated(kind_of<Linear>, ContactEnd::force, tcol, en, {speed, mass_eff(sphere, other)});
    c.flight_steps = offset;
    c.time_scale = tcol;
    c.duration = run_of_one * tcol;
    c.asked = {{Quantity::vx, 1, speed}, {Quantity::vx, 2, speed}, {Quantity::separation, 1, tcol}};
    c.solver = one_collision;
    cases.push_back(c);
  }
  return cases;
}

}  // namespace ricochet::verify::conformance
