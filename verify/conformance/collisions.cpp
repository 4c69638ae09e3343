#include "solvers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ricochet::verify::conformance {

namespace {

constexpr double closed_form_error = 1e-11;  // of collide and of what it is made of, relative; 1e-9 with a spin

const Meeting& meeting_of(const Case& of, bool wall) { return wall ? of.wall_law.value() : of.law.value(); }

ImpactBody impact_body(const Body& b) { return {b.mass, b.radius, b.velocity, b.spin, 0.4}; }

struct Met {
  ObliqueCollision what;
  double approach = 0;
};

/// `normal` points from `first` to the other.
Met meet(const Case& of, const Body& first, const Body* second, Vec3 normal, ContactArm arm) {
  const Meeting& meeting = meeting_of(of, second == nullptr);
  const ObliqueImpact impact{normal, impact_body(first), second ? impact_body(*second) : ImpactBody::wall()};
  const TangentialContact smooth{};
  Met met{collide(meeting.law, of.tangential.value_or(smooth), impact, {.end = meeting.end, .arm = arm})};
  if (!met.what.separated()) throw std::logic_error("the bodies of a case do not part: " + of.name);
  met.approach = dot(first.velocity - (second ? second->velocity : Vec3{}), normal);
  return met;
}

Body after(Body body, Vec3 velocity, Vec3 spin) {
  body.velocity = velocity, body.spin = spin;
  return body;
}

/// Until the overlap is 0 again, the bodies flying straight from the end of the contact.
double separation(const Met& met) {
  const Collision& c = met.what.normal;
  return c.tcol + c.overlap_end / (c.en * met.approach);
}

double solver_error(const Case& of) { return of.tangential ? 1e-9 : closed_form_error; }

}  // namespace

Solution one_collision(const Case& of, ContactArm arm) {
  const Body* second = of.walls.empty() ? &of.bodies.at(1) : nullptr;
  const Body& first = of.bodies.front();
  const Vec3 branch = second ? second->position - first.position : -of.walls.front().normal;
  const Vec3 normal = branch / norm(branch);
  const Met met = meet(of, first, second, normal, arm);
  const ObliqueCollision& c = met.what;
  Solution solution{.bodies = of.bodies, .error = solver_error(of)};
  solution.bodies[0] = after(first, c.velocity_i, c.spin_i);
  if (second) {
    solution.bodies[1] = after(*second, c.velocity_j, c.spin_j);
    const double before = norm(tangential(first.velocity - second->velocity, normal)),
                 after = norm(tangential(c.velocity_i - c.velocity_j, normal));
    solution.error += std::max(before, after) * c.normal.tcol / norm(branch);
  }
  solution.separation = separation(met);
  solution.contact_time = c.normal.tcol, solution.max_overlap = c.normal.max_overlap;
  return solution;
}

Solution collisions_of_one(const Case& of, ContactArm arm) {
  Solution solution{.bodies = of.bodies, .error = solver_error(of)};
  Body& body = solution.bodies.front();
  double time = 0;
  while (true) {
    // The wall that is met first.
    const Plane* next = nullptr;
    double flight = std::numeric_limits<double>::infinity();
    for (const Plane& wall : of.walls) {
      const double approach = -dot(body.velocity, wall.normal);
      const double gap = dot(body.position - wall.point, wall.normal) - body.radius;
      if (approach > 0 && gap / approach < flight) flight = gap / approach, next = &wall;
    }
    if (!next || time + flight >= of.duration) break;
    body.position += flight * body.velocity;
    const Met met = meet(of, body, nullptr, -next->normal, arm);
    const double lasts = separation(met);
    body = after(body, met.what.velocity_i, met.what.spin_i);
    body.position += next->normal * (body.radius - dot(body.position - next->point, next->normal));
    time += flight + lasts;
  }
  body.position += (of.duration - time) * body.velocity;
  return solution;
}

}  // namespace ricochet::verify::conformance
