#include "common.hpp"

#include <fmt/format.h>

namespace ricochet::verify::conformance {

namespace {

constexpr double gravity = 9.80665;  // MFiX's

/// A damped spring of the restitution e that it would have ended by overlap, without gravity.
Linear linear(double k, double mass, double en) {
  return {k, 2 * damping_of_restitution(en, ContactEnd::overlap) * std::sqrt(mass * k)};
}

/// DEM01 and DEM02: a sphere of 0.2 m, 2600 kg/m³, let go with its centre at 0.5 m.
Case drop(std::string name, std::string title, const std::string& source, double k, double en, double about) {
  Case c{.name = std::move(name), .family = "bouncing", .title = std::move(title)};
  Body sphere = Body::of_density(0.1, 2600);
  sphere.position.x = 0.5;
  c.how = by_line;
  c.bodies = {sphere};
  c.walls = {Plane{}};
  c.gravity = {-gravity, 0, 0};
  c.wall_law = Meeting{linear(k, sphere.mass, en), ContactEnd::overlap};
  c.flight_steps = 0;
  c.time_scale = std::numbers::pi * std::sqrt(sphere.mass / k);
  c.duration = std::round(about / c.time_scale) * c.time_scale;
  c.asked = {{Quantity::x, 1, 0.5}, {Quantity::vx, 1, std::sqrt(2 * gravity * 0.4)}};
  c.solver = on_a_line;
  return published(c, source);
}

/// Beads that fly at a wall and at each other, along x.
Case beads(std::string name, std::string title, std::string source, std::size_t count, const Meeting& meeting,
           double tcol) {
  Case c{.name = std::move(name), .family = "column", .title = std::move(title), .source = std::move(source)};
  const Body bead = Body::of_density(1.5e-3, 1000);
  for (std::size_t i = 0; i < count; ++i) {
    Body b = bead;
    b.position.x = static_cast<double>(2 * i + 1) * bead.radius;
    c.bodies.push_back(b);
  }
  c.how = by_line;
  c.law = meeting;
  c.time_scale = tcol;
  c.solver = on_a_line;
  return c;
}

void ask_all_velocities(Case& c, double speed) {
  for (std::size_t i = 1; i <= c.bodies.size(); ++i) c.asked.push_back({Quantity::vx, i, speed});
}

/// Three beads with gaps fall on a wall (the detachment effect): several contacts at once.
Case column() {
  constexpr double speed = 0.5, tcol = 1e-4, gap = 2e-6;
  const double mass = Body::of_density(1.5e-3, 1000).mass;
  const Impact impact{speed, mass / 2};
  Case c =
      beads("column-three-beads", "Three beads, 2 µm apart, fall on a wall: contacts that last together",
            "S. Luding, E. Clément, A. Blumen, J. Rajchenbach, J. Duran, Phys. Rev. E 50, 4113 (1994); paper's Fig. 6",
            3, calibrated(kind_of<Linear>, ContactEnd::force, tcol, 0.945, impact), tcol);
  c.walls = {Plane{}};
  c.wall_law = calibrated(kind_of<Linear>, ContactEnd::force, tcol, 0.945, {speed, mass});
  for (std::size_t i = 0; i < 3; ++i)
    c.bodies[i].position.x += static_cast<double>(i) * gap, c.bodies[i].velocity.x = -speed;
  c.duration = 6.23 * tcol;
  ask_all_velocities(c, speed);
  return c;
}

/// One bead hits a row of four that touch, Hertz's law without loss.
Case chain() {
  constexpr double speed = 0.5, tcol = 1e-4;
  const double mass = Body::of_density(1.5e-3, 1000).mass;
  Case c = beads("chain-five-beads", "A bead hits a row of four that touch, Hertz's law without loss: a wave runs",
                 "V. F. Nesterenko, J. Appl. Mech. Tech. Phys. 24, 733 (1983)", 5,
                 calibrated(kind_of<Tsuji>, ContactEnd::force, tcol, 1, {speed, mass / 2}), tcol);
  c.bodies.front().velocity.x = speed;
  c.duration = 6.23 * tcol;
  c.orders.leapfrog = 2;
  ask_all_velocities(c, speed);
  return c;
}

/// DEM03: two spheres of 1 mm, the lower twice as dense, pressed together between walls 1.8 mm apart.
Case pressed() {
  constexpr double r = 0.5e-3, between = 1.8e-3, k = 1e3;
  Case c{.name = "dem03-pressed", .family = "column"};
  c.title = "Two spheres are let go pressed together between two walls, under gravity";
  c.how = by_line;
  Body lower = Body::of_density(r, 2e4), upper = Body::of_density(r, 1e4);
  lower.position.x = between / 4, upper.position.x = 3 * between / 4;
  c.bodies = {lower, upper};
  c.walls = {Plane{}, {{between, 0, 0}, {-1, 0, 0}}};
  c.gravity = {-gravity, 0, 0};
  c.law = Meeting{linear(k, mass_eff(lower, upper), 0.8), ContactEnd::overlap};
  c.wall_law = Meeting{linear(k, upper.mass, 0.8), ContactEnd::overlap};
  c.flight_steps = 0;
  c.time_scale = std::numbers::pi * std::sqrt(mass_eff(lower, upper) / k);
  c.duration = 12 * c.time_scale;
  c.asked = {{Quantity::x, 1, 0.1 * r}, {Quantity::x, 2, 0.1 * r}};
  c.solver = on_a_line;
  return published(c, std::string(mfix) + "DEM03, here with one damping at both walls");
}

}  // namespace

std::vector<Case> falling_cases() {
  return {drop("dem01-fall", "A sphere falls on a wall and rebounds", std::string(mfix) + "DEM01, k = 1e4, e = 0.9",
               1e4, 0.9, 0.6),
          drop("dem02-bounces", "A sphere falls on a wall and bounces three times",
               std::string(mfix) + "DEM02, k = 5e4, e = 0.9", 5e4, 0.9, 1.65),
          column(), chain(), pressed()};
}

}  // namespace ricochet::verify::conformance
