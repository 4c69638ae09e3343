#include "located.hpp"
#include "solvers.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ricochet::verify::conformance {

namespace {

/// A contact of two neighbours on the line, or of one and a wall.
struct Touch {
  enum class Mode {
    apart,
    pressing,
    held  ///< they overlap, and the force of a contact that ends by force has fallen to 0
  };
  std::size_t below = 0, above = 0;  ///< bodies; `wall` for the wall
  double reach = 0;                  ///< distance of the places at touch
  double place = 0;                  ///< of the wall
  const Meeting* meeting = nullptr;
  Mode mode = Mode::apart;
};

constexpr std::size_t wall = static_cast<std::size_t>(-1);

/// The law's own formula, which may attract. Laws with a memory have no place here.
double force(const AnyLaw& law, Approach a) {
  return std::visit(
      [&](const auto& l) -> double {
        if constexpr (requires { l.force(a, {}); }) {
          if constexpr (std::is_empty_v<typename std::decay_t<decltype(l)>::Memory>) return l.force(a, {});
        }
        throw std::logic_error("a law with a memory on a line");
      },
      law);
}

class Line {
 public:
  explicit Line(const Case& of) : gravity_(dot(of.gravity, axis_of(of))) {
    const Vec3 axis = axis_of(of);
    for (const Body& b : of.bodies) masses_.push_back(b.mass);
    const std::size_t n = of.bodies.size();
    for (std::size_t i = 0; i + 1 < n && of.law; ++i)
      touches_.push_back({i, i + 1, of.bodies[i].radius + of.bodies[i + 1].radius, 0, &*of.law});
    for (const Plane& plane : of.walls) {
      const bool floor = dot(plane.normal, axis) > 0;
      const std::size_t who = floor ? 0 : n - 1;
      touches_.push_back({floor ? wall : who, floor ? who : wall, of.bodies[who].radius, dot(plane.point, axis),
                          &of.wall_law.value()});
    }
  }
  static Vec3 axis_of(const Case& of) {
    if (!of.walls.empty()) return of.walls.front().normal;
    const Vec3 branch = of.bodies.at(1).position - of.bodies.front().position;
    return branch / norm(branch);
  }

  /// Bodies that touch and approach, or overlap, have a contact from the start.
  void begin(const State& x) {
    for (Touch& t : touches_) {
      const Approach a = approach(t, x);
      if (a.overlap > 1e-12 * t.reach || (a.overlap > -1e-12 * t.reach && a.rate > 0)) t.mode = Touch::Mode::pressing;
    }
  }
  void rate(const State& x, State& dxdt) const {
    const std::size_t n = masses_.size();
    for (std::size_t i = 0; i < n; ++i) dxdt[i] = x[n + i], dxdt[n + i] = gravity_;
    for (const Touch& t : touches_) {
      if (t.mode != Touch::Mode::pressing) continue;
      const double f = force(t.meeting->law, approach(t, x));
      if (t.below != wall) dxdt[n + t.below] -= f / masses_[t.below];
      if (t.above != wall) dxdt[n + t.above] += f / masses_[t.above];
    }
  }
  bool happened(const State& x) const {
    return std::any_of(touches_.begin(), touches_.end(), [&](const Touch& t) { return mode_at(t, x) != t.mode; });
  }
  void change(const State& x) {
    for (Touch& t : touches_) t.mode = mode_at(t, x);
  }

 private:
  Approach approach(const Touch& t, const State& x) const {
    const std::size_t n = masses_.size();
    const double low = t.below == wall ? t.place : x[t.below], high = t.above == wall ? t.place : x[t.above];
    const double v_low = t.below == wall ? 0 : x[n + t.below], v_high = t.above == wall ? 0 : x[n + t.above];
    return {t.reach - (high - low), v_low - v_high};
  }
  Touch::Mode mode_at(const Touch& t, const State& x) const {
    using Mode = Touch::Mode;
    const Approach a = approach(t, x);
    if (a.overlap <= 0 && !(t.mode == Mode::pressing && a.rate > 0)) return Mode::apart;
    if (t.meeting->end == ContactEnd::overlap) return Mode::pressing;
    // Just begun, the overlap is 0 to rounding and the spring with it.
    if (t.mode != Mode::held && a.rate > 0) return Mode::pressing;
    return force(t.meeting->law, a) > 0 ? Mode::pressing : Mode::held;
  }

  std::vector<double> masses_;
  std::vector<Touch> touches_;
  double gravity_;
};

std::vector<Body> end_of(const Case& of, double tolerance) {
  const Vec3 axis = Line::axis_of(of);
  Line line(of);
  State x, scale;
  double speed = norm(of.gravity) * of.time_scale, length = 0;
  for (const Body& b : of.bodies) x.push_back(dot(b.position, axis)), speed = std::max(speed, norm(b.velocity));
  for (const Body& b : of.bodies) x.push_back(dot(b.velocity, axis));
  length = speed * of.time_scale;
  scale.assign(of.bodies.size(), length);
  scale.resize(x.size(), speed);
  line.begin(x);
  const State end = follow_located(line, x, of.duration, scale, tolerance, 1e-4 * of.time_scale);
  std::vector<Body> bodies = of.bodies;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies[i].position += (end[i] - x[i]) * axis;
    bodies[i].velocity += (end[bodies.size() + i] - x[bodies.size() + i]) * axis;
  }
  return bodies;
}

}  // namespace

Solution on_a_line(const Case& of, ContactArm) {
  Solution solution{.bodies = end_of(of, 1e-14)};
  const Solution coarser{.bodies = end_of(of, 1e-11)};
  for (const Asked& asked : of.asked)
    solution.error = std::max(solution.error, std::abs(number(solution, asked) - number(coarser, asked)) / asked.scale);
  return solution;
}

}  // namespace ricochet::verify::conformance
