#include "common.hpp"

#include <fmt/format.h>

namespace ricochet::verify::conformance {

namespace {

constexpr double gravity = 9.81, radius = 1e-3, density = 2500;

/// A sphere at rest in a floor of stiffness k, gravity turned by `degrees` from its normal towards y: it neither sinks
/// nor rises. The overlap is `share` of the radius.
Case on_floor(std::string name, std::string title, std::string source, double degrees, Body body, double share) {
  const double angle = degrees * std::numbers::pi / 180;
  const double pressure = body.mass * gravity * std::cos(angle), k = pressure / (share * body.radius);
  Case c{.name = std::move(name), .family = "floor", .title = std::move(title), .source = std::move(source)};
  c.how = by_floor;
  body.position.x = (1 - share) * body.radius;
  c.bodies = {body};
  c.walls = {Plane{}};
  c.gravity = {-gravity * std::cos(angle), gravity * std::sin(angle), 0};
  c.wall_law = Meeting{Linear(k, 0)};
  c.tangential = rough(LinearTangential(2.0 / 7 * k), 0.5);
  c.flight_steps = 0;
  c.time_scale = std::numbers::pi * std::sqrt(body.mass / k);
  c.solver = on_a_floor;
  return c;
}

/// `scales` times the time scale; y and v_y and the spin by the speeds that the motion has.
Case lasting(Case c, int scales, double speed) {
  c.duration = scales * c.time_scale;
  c.asked = {{Quantity::vy, 1, speed},
             {Quantity::wz, 1, speed / c.bodies.front().radius},
             {Quantity::y, 1, speed * c.duration}};
  return c;
}

Case resting() {
  const Body sphere = Body::of_density(radius, density);
  const double share = 1e-3, k = sphere.mass * gravity / (share * radius);
  Case c{.name = "resting-floor",
         .family = "floor",
         .title = "A sphere that is laid on a floor sinks in and comes to rest"};
  c.source = "a damped oscillator, m ζ'' = m g − k ζ − c ζ' from ζ = ζ' = 0";
  c.how = by_line;
  c.bodies = touching_wall(sphere);
  c.walls = {Plane{}};
  c.gravity = {-gravity, 0, 0};
  c.wall_law = Meeting{Linear(k, 0.3 * 2 * std::sqrt(sphere.mass * k))};
  c.flight_steps = 0;
  c.time_scale = std::numbers::pi * std::sqrt(sphere.mass / k);
  c.duration = 2 * c.time_scale;
  c.asked = {{Quantity::x, 1, share * radius}, {Quantity::vx, 1, gravity * c.time_scale}};
  c.solver = on_a_line;
  return c;
}

}  // namespace

std::vector<Case> plane_cases() {
  std::vector<Case> cases{resting()};
  const Body sphere = Body::of_density(radius, density);
  Body rolling = sphere;
  // e_z × … : forward along y on a floor whose normal is x is a spin about z.
  rolling.velocity = {0, 0.05, 0}, rolling.spin = {0, 0, 0.05 / radius};
  cases.push_back(lasting(on_floor("rolling-free", "A sphere that rolls on a floor without rolling resistance rolls on",
                                   "Newton's first law", 0, rolling, 1e-5),
                          10, 0.05));
  Case resisted = on_floor("rolling-resistance", "A sphere that rolls on a floor slows down by (5/7) μ_r g",
                           "J. Ai, J.-F. Chen, J. M. Rotter, J. Y. Ooi, Powder Technol. 206, 269 (2011), model C "
                           "without viscous part",
                           0, rolling, 1e-5);
  const double k = values(resisted.wall_law->law).front();
  // The spring that scenes of `simulate` have, (7/2) (J/m) k_t.
  resisted.tangential->rolling = {0.1, {0.4 * k * radius * radius, 0}};
  cases.push_back(lasting(resisted, 40, 0.05));
  Body sliding = Body::of_density(0.5e-3, 1e4);
  sliding.velocity.y = 0.5;
  cases.push_back(published(lasting(on_floor("dem04-sliding-to-rolling",
                                             "A sphere slides on a rough floor until it rolls", "", 0, sliding, 1e-4),
                                    160, 0.5),
                            std::string(mfix) + "DEM04, with a tangential spring"));
  // Slides where μ < (2/7) tan θ.
  Case slides = on_floor("slope-sliding", "A sphere let go on a slope of 45°, μ = 0.2: it slides",
                         "Coulomb: v' = g (sin θ − μ cos θ), ω' = (5/2) μ g cos θ/r", 45, sphere, 1e-5);
  slides.tangential->friction = Friction(0.2, 0.2, 0);
  cases.push_back(lasting(slides, 40, gravity * 40 * slides.time_scale));
  const Case rolls = on_floor("slope-rolling", "A sphere let go on a slope of 20°, μ = 0.5: it rolls",
                              "v' = (5/7) g sin θ, and the swinging of the tangential spring", 20, sphere, 1e-5);
  cases.push_back(lasting(rolls, 40, gravity * 40 * rolls.time_scale));
  return cases;
}

}  // namespace ricochet::verify::conformance
