#include "located.hpp"
#include "solvers.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ricochet::verify::conformance {

namespace {

/// A spring with a slider behind it: the traction is −k ξ, |k ξ| ≤ limit; at the limit ξ stays as long as the motion
/// goes on in its direction.
struct Slider {
  double stiffness = 0, limit = 0;
  int slides = 0;  ///< the sign of ξ while it slides

  double strain_rate(double motion) const { return slides == 0 ? motion : 0; }
  int mode_at(double strain, double motion) const {
    if (slides != 0) return motion * slides < 0 ? 0 : slides;
    if (!(stiffness > 0) || std::abs(stiffness * strain) <= limit) return 0;
    return strain > 0 ? 1 : -1;
  }
};

/// x: place, velocity, roll (ω about the axis of rolling forward), strain of the tangential and of the rolling spring.
class Floor {
 public:
  Floor(const Case& of, ContactArm place) : body_(of.bodies.front()), normal_(of.walls.front().normal) {
    const TangentialContact& t = of.tangential.value();
    const double pressure = -body_.mass * dot(of.gravity, normal_);
    const Vec3 pull = tangential(of.gravity, normal_);
    const Vec3 along = norm(pull) > 0 ? pull : tangential(body_.velocity, normal_);
    if (!(pressure > 0) || !(norm(along) > 0)) throw std::logic_error("nothing moves on the floor of " + of.name);
    if (t.friction.mu_static() > 0 && !compliant(t.law)) throw std::logic_error("rigid friction in " + of.name);
    forward_ = along / norm(along);
    pull_ = dot(pull, forward_);
    const double overlap = body_.radius - dot(body_.position - of.walls.front().point, normal_);
    arm_ = body_.radius - (place == ContactArm::radius ? 0 : 0.5 * overlap);
    slide_ = {spring(t.law, overlap).stiffness, t.friction.mu_static() * pressure};
    roll_ = {t.rolling.spring.stiffness, t.rolling.mu * body_.radius * pressure};
  }

  /// What a step that does not resolve how the spring is loaded by the first slip takes too much of the velocity [m/s].
  double unresolved(double first_slip) const {
    if (!(std::abs(first_slip) > 0) || !(slide_.limit > 0)) return 0;
    const double loading = slide_.limit / (slide_.stiffness * std::abs(first_slip));
    return 0.5 * slide_.limit / body_.mass * loading;
  }
  Vec3 forward() const { return forward_; }
  Vec3 axis() const { return cross(normal_, forward_); }
  void rate(const State& x, State& dxdt) const {
    const double traction = -slide_.stiffness * x[3], torque = -roll_.stiffness * x[4];
    dxdt[0] = x[1];
    dxdt[1] = pull_ + traction / body_.mass;
    dxdt[2] = (torque - arm_ * traction) / body_.inertia();
    dxdt[3] = slide_.strain_rate(slip(x));
    dxdt[4] = roll_.strain_rate(x[2]);
  }
  bool happened(const State& x) const {
    return slide_.mode_at(x[3], slip(x)) != slide_.slides || roll_.mode_at(x[4], x[2]) != roll_.slides;
  }
  void change(const State& x) {
    slide_.slides = slide_.mode_at(x[3], slip(x));
    roll_.slides = roll_.mode_at(x[4], x[2]);
  }

 private:
  double slip(const State& x) const { return x[1] - arm_ * x[2]; }

  Body body_;
  Vec3 normal_, forward_{};
  double pull_ = 0, arm_ = 0;
  Slider slide_, roll_;
};

double speed_of(const Case& of) { return std::max(norm(of.bodies.front().velocity), norm(of.gravity) * of.duration); }

Solution end_of(const Case& of, ContactArm arm, double tolerance) {
  Floor floor(of, arm);
  const Body& body = of.bodies.front();
  const double speed = speed_of(of), length = speed * of.time_scale;
  const State x{0, dot(body.velocity, floor.forward()), dot(body.spin, floor.axis()), 0, 0};
  const State scale{length, speed, speed / body.radius, length, length / body.radius};
  const State end = follow_located(floor, x, of.duration, scale, tolerance, 1e-3 * of.time_scale);
  Solution solution{.bodies = of.bodies};
  Body& moved = solution.bodies.front();
  moved.position += end[0] * floor.forward();
  moved.velocity += (end[1] - x[1]) * floor.forward();
  moved.spin += (end[2] - x[2]) * floor.axis();
  return solution;
}

}  // namespace

Solution on_a_floor(const Case& of, ContactArm arm) {
  Solution solution = end_of(of, arm, 1e-14);
  const Solution coarser = end_of(of, arm, 1e-11);
  for (const Asked& asked : of.asked)
    solution.error = std::max(solution.error, std::abs(number(solution, asked) - number(coarser, asked)) / asked.scale);
  const Floor floor(of, arm);
  const Body& body = of.bodies.front();
  const double slip = dot(body.velocity, floor.forward()) - body.radius * dot(body.spin, floor.axis());
  solution.error += floor.unresolved(slip) / speed_of(of);
  return solution;
}

}  // namespace ricochet::verify::conformance
