#include "case.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace ricochet::verify::conformance {

namespace {

constexpr std::array<std::string_view, 12> quantity_names{
    "x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz", "separation", "contact_time", "max_overlap"};

double volume(double radius) { return 4.0 / 3 * std::numbers::pi * radius * radius * radius; }

}  // namespace

Body Body::of_density(double radius, double density) { return {radius, density * volume(radius), {}, {}, {}}; }

double Body::density() const noexcept { return mass / volume(radius); }

std::string_view name(Quantity quantity) noexcept { return quantity_names[static_cast<std::size_t>(quantity)]; }

long Case::steps_of_run(int steps_in_scale) const noexcept {
  return std::lround(std::ceil(flight_steps + duration * steps_in_scale / time_scale - 1e-6));
}

double Case::end_of_run(int steps_in_scale) const noexcept {
  return (static_cast<double>(steps_of_run(steps_in_scale)) - flight_steps) * step(steps_in_scale);
}

std::vector<Body> Case::start(int steps_in_scale) const {
  std::vector<Body> all = bodies;
  for (Body& body : all) body.position -= flight_steps * step(steps_in_scale) * body.velocity;
  return all;
}

double component(const Body& body, Quantity quantity) {
  const std::array<double, 9> all{body.position.x, body.position.y, body.position.z, body.velocity.x, body.velocity.y,
                                  body.velocity.z, body.spin.x,     body.spin.y,     body.spin.z};
  return all.at(static_cast<std::size_t>(quantity));
}

double number(const Solution& of, const Asked& asked) {
  if (asked.quantity == Quantity::separation) return of.separation;
  if (asked.quantity == Quantity::contact_time) return of.contact_time;
  if (asked.quantity == Quantity::max_overlap) return of.max_overlap;
  return component(of.bodies.at(asked.body - 1), asked.quantity);
}

std::vector<Answer> answers(const Case& of) {
  const Solution at_radius = of.solver(of, ContactArm::radius);
  const Solution at_point = of.tangential ? of.solver(of, ContactArm::contact_point) : at_radius;
  std::vector<Answer> all;
  all.reserve(of.asked.size());
  for (const Asked& asked : of.asked) {
    const double value = number(at_radius, asked);
    // The contact point of a wall, at r − ζ/2, is half-way to the wall itself, where some engines have it.
    all.push_back({asked, value, 2 * std::abs(number(at_point, asked) - value) + at_radius.error * asked.scale});
  }
  return all;
}

double energy(const std::vector<Body>& bodies, Vec3 gravity) {
  double sum = 0;
  for (const Body& b : bodies)
    sum += 0.5 * b.mass * dot(b.velocity, b.velocity) + 0.5 * b.inertia() * dot(b.spin, b.spin) -
           b.mass * dot(gravity, b.position);
  return sum;
}

}  // namespace ricochet::verify::conformance
