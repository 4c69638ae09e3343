#include "common.hpp"

#include <fmt/format.h>

namespace ricochet::verify::conformance {

namespace {

constexpr double radius = 1.5e-3, density = 1000, tcol = 1e-4;

/// A sphere that flies to and fro between two walls; the first flight takes three collisions.
Case between_walls(std::string name, std::string title, std::string source, Body body, const Meeting& meeting,
                   int bounces) {
  Case c{.name = std::move(name), .family = "re-contact", .title = std::move(title), .source = std::move(source)};
  const double speed = -body.velocity.x, room = 3 * tcol * speed;
  c.how = by_collide;
  c.bodies = touching_wall(body);
  c.walls = {Plane{}, {{2 * body.radius + room, 0, 0}, {-1, 0, 0}}};
  c.wall_law = meeting;
  c.time_scale = tcol;
  // Half a flight after the last contact.
  double at = speed;
  const Collision met = collide(meeting.law, Impact{speed, body.mass}, {.end = meeting.end});
  for (int i = 0; i < bounces; ++i) {
    c.duration += met.tcol + met.overlap_end / (met.en * at);
    at *= met.en;
    c.duration += (i + 1 < bounces ? 1 : 0.5) * room / at;
  }
  c.solver = collisions_of_one;
  return c;
}

Body thrown(double speed) {
  Body body = Body::of_density(radius, density);
  body.velocity.x = -speed;
  return body;
}

/// A light bead is hit by a heavy one and goes to and fro between it and a wall.
Case light_bead() {
  Body light = Body::of_density(radius, density), heavy = Body::of_density(radius, 20 * density);
  light.position.x = radius + 2e-5, heavy.position.x = light.position.x + 2 * radius, heavy.velocity.x = -0.5;
  Case c{.name = "re-contact-light-bead", .family = "re-contact"};
  c.title = "A light bead between a wall and a heavy one: it is touched again and again";
  c.source = fmt::format("m_i x_i'' = F_left − F_right of three bodies on a line; {}", linear_by_force);
  c.how = by_line;
  c.bodies = {light, heavy};
  c.walls = {Plane{}};
  c.law = calibrated(kind_of<Linear>, ContactEnd::force, tcol, 0.9, {0.5, mass_eff(light, heavy)});
  c.wall_law = calibrated(kind_of<Linear>, ContactEnd::force, tcol, 0.9, {0.5, light.mass});
  c.time_scale = tcol;
  c.duration = 12.31 * tcol;
  c.asked = {{Quantity::vx, 1, 0.5}, {Quantity::vx, 2, 0.5}};
  c.solver = on_a_line;
  return c;
}

}  // namespace

std::vector<Case> again_cases() {
  std::vector<Case> cases;
  const Body fast = thrown(0.5), slow = thrown(1e-2);
  constexpr const char* powers = "after n bounces e^n of the velocity is left, as e does not depend on it";
  cases.push_back(between_walls("re-contact-linear", "Five bounces between two walls, linear law", powers, fast,
                                calibrated(kind_of<Linear>, ContactEnd::force, tcol, 0.8, {0.5, fast.mass}), 5));
  cases.back().asked = {{Quantity::vx, 1, 0.5}};
  cases.push_back(between_walls("re-contact-fractional",
                                "Five bounces between two walls, fractional law: no memory of "
                                "the contact before",
                                powers, fast,
                                calibrated(kind_of<Fractional>, ContactEnd::force, tcol, 0.8, {0.5, fast.mass}), 5));
  cases.back().asked = {{Quantity::vx, 1, 0.5}};
  Body oblique = slow;
  oblique.velocity.y = 4e-3;
  Case spring = between_walls("re-contact-spring",
                              "Three oblique bounces between two walls: the tangential spring of "
                              "one contact is gone in the next",
                              fmt::format("three times the oblique collision: {}", becker), oblique,
                              calibrated(kind_of<Linear>, ContactEnd::force, tcol, 0.8, {1e-2, slow.mass}), 3);
  const double mass = 2.0 / 7 * slow.mass, rate = std::acos(-0.5) / tcol;
  spring.tangential = rough(LinearTangential(mass * rate * rate), 0.3);
  spring.asked = {{Quantity::vy, 1, 1e-2}, {Quantity::wz, 1, 1e-2 / radius}, {Quantity::vx, 1, 1e-2}};
  cases.push_back(spring);
  cases.push_back(light_bead());
  return cases;
}

}  // namespace ricochet::verify::conformance
