#include "half_step.hpp"

#include "solvers.hpp"

#include <ricochet/contact/geometry.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet::verify::conformance {

namespace {

/// What bodies i and j (the wall of that number, where `wall`) remember of their contact.
struct Pair {
  std::size_t i = 0, j = 0;
  bool wall = false;
  const Meeting* meeting = nullptr;
  double max_overlap = 0;
};

std::optional<double> force(const AnyLaw& law, Approach a, double max_overlap) {
  return std::visit(
      [&](const auto& l) -> std::optional<double> {
        using Law = std::decay_t<decltype(l)>;
        if constexpr (std::is_same_v<Law, Hysteretic>)
          return l.force(a, {max_overlap});
        else if constexpr (ContactLaw<Law>)
          return l.force(a, {});
        else
          return std::nullopt;
      },
      law);
}

bool is_stepped(const std::optional<Meeting>& meeting) { return !meeting || force(meeting->law, {}, 0).has_value(); }

std::vector<Pair> pairs_of(const Case& of) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < of.bodies.size(); ++i) {
    for (std::size_t j = i + 1; of.law && j < of.bodies.size(); ++j) pairs.push_back({i, j, false, &*of.law});
    for (std::size_t w = 0; of.wall_law && w < of.walls.size(); ++w) pairs.push_back({i, w, true, &*of.wall_law});
  }
  return pairs;
}

/// The bodies' accelerations at these places and velocities; every contact notes how deep it is.
std::vector<Vec3> accelerations(const Case& of, const std::vector<Body>& bodies, std::vector<Pair>& pairs) {
  std::vector<Vec3> all(bodies.size(), of.gravity);
  for (Pair& p : pairs) {
    const Body& a = bodies[p.i];
    Vec3 normal{}, velocity = a.velocity;
    double overlap = 0;
    if (p.wall) {
      normal = -of.walls[p.j].normal;
      overlap = a.radius - dot(a.position - of.walls[p.j].point, of.walls[p.j].normal);
    } else {
      const Vec3 branch = bodies[p.j].position - a.position;
      normal = branch / norm(branch), overlap = a.radius + bodies[p.j].radius - norm(branch);
      velocity -= bodies[p.j].velocity;
    }
    if (overlap <= 0) {
      p.max_overlap = 0;
      continue;
    }
    double f = force(p.meeting->law, {overlap, dot(velocity, normal)}, p.max_overlap).value();
    p.max_overlap = std::max(p.max_overlap, overlap);
    if (p.meeting->end == ContactEnd::force) f = std::max(0.0, f);
    all[p.i] -= f / a.mass * normal;
    if (!p.wall) all[p.j] += f / bodies[p.j].mass * normal;
  }
  return all;
}

void kick(std::vector<Body>& bodies, const std::vector<Vec3>& by, double time) {
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].velocity += time * by[i];
}

/// Bodies that meet once, along their first normal and across it.
struct Oblique {
  double mass[2]{}, radius[2]{};  // the wall's mass is infinite
  double rate = 0;                // of the overlap
  double across[2]{}, turning[2]{};
  double spinning[2]{};  // about the normal
};

/// How one such contact is made in an engine.
struct Made {
  const Meeting& meeting;
  const TangentialContact& contact;
  Rule rule;
  Places places = {};
  Rubs rubs = Rubs::repulsion;

  /// What acts, and what limits friction.
  std::pair<double, double> forces(Approach a) const {
    const double whole = force(meeting.law, a, 0).value();
    const double acts = meeting.end == ContactEnd::force ? std::max(0.0, whole) : whole;
    switch (rubs) {
      case Rubs::repulsion: break;
      case Rubs::size: return {acts, std::abs(acts)};
      case Rubs::unclipped: return {acts, std::abs(whole)};
      case Rubs::spring: return {acts, force(meeting.law, {a.overlap, 0}, 0).value()};
    }
    return {acts, std::max(0.0, acts)};
  }
  double torsion_limit(const Oblique& at, double overlap) const {
    if (contact.torsion.limit == Torsion::Limit::none) return 0;
    const double r = at.radius[0], other = at.radius[1];
    const ContactGeometry g = other > 0 ? sphere_sphere({}, r, {r + other - overlap, 0, 0}, other)
                                        : sphere_wall({r - overlap, 0, 0}, r, {}, {1, 0, 0});
    return contact.torsion.arm * g.radius;
  }
};

double inverse(double mass) { return std::isfinite(mass) ? 1 / mass : 0; }

/// Velocity Verlet by half-step velocities, from the touch on; the turning of the normal left out.
Oblique stepped(Oblique at, const Made& made, double duration, double step) {
  const TangentialContact& contact = made.contact;
  const double mu = contact.friction.mu_static(), mass_eff = 1 / (inverse(at.mass[0]) + inverse(at.mass[1]));
  double overlap = -0.5 * step * at.rate;
  Slider slider(made.rule), twister(made.rule);
  const long count = std::lround(duration / step);
  for (long n = 0; n < count; ++n) {
    overlap += at.rate * step;
    // Of the step from half a one before to half a one after, what is before the overlap's end: forces may jump there.
    const double held = at.rate < 0 ? std::clamp(0.5 - overlap / (at.rate * step), 0.0, 1.0) * step : step;
    if (held == 0 || (overlap <= 0 && at.rate >= 0)) continue;
    const double now = std::max(0.0, overlap), inside = made.places.force * now, there = made.places.slip * now;
    const auto [acts, rubs] = made.forces({now, at.rate});
    const double slip =
        at.across[0] - at.across[1] - (at.radius[0] - there) * at.turning[0] - (at.radius[1] - there) * at.turning[1];
    const double traction = slider.act(spring(contact.law, now), slip, held, mu * rubs);
    const double moment = twister.act(contact.torsion.spring, at.spinning[0] - at.spinning[1], held,
                                      made.torsion_limit(at, now) * mu * rubs);
    at.rate -= acts / mass_eff * held;
    for (std::size_t k = 0; k < 2; ++k) {
      at.across[k] += (k == 0 ? traction : -traction) * inverse(at.mass[k]) * held;
      if (!(at.mass[k] < HUGE_VAL)) continue;
      const double inertia = 0.4 * at.mass[k] * at.radius[k] * at.radius[k];
      at.turning[k] -= (at.radius[k] - inside) * traction / inertia * held;
      at.spinning[k] += (k == 0 ? moment : -moment) / inertia * held;
    }
  }
  return at;
}

}  // namespace

std::optional<Run> half_step_run(const Case& of, int steps, Velocities velocities) {
  if (of.tangential || !is_stepped(of.law) || !is_stepped(of.wall_law)) return std::nullopt;
  Run run{steps, of.start(steps)};
  std::vector<Pair> pairs = pairs_of(of);
  const double h = of.step(steps), before = velocities == Velocities::at_steps ? 0.5 * h : h;
  std::vector<Vec3> acceleration = accelerations(of, run.bodies, pairs);
  for (long n = 0; n < of.steps_of_run(steps); ++n) {
    kick(run.bodies, acceleration, before);
    for (Body& b : run.bodies) b.position += h * b.velocity;
    acceleration = accelerations(of, run.bodies, pairs);
    kick(run.bodies, acceleration, h - before);
  }
  return run;
}

std::optional<Solution> by_rule(const Case& of, Rule rule, Places places, Rubs rubs) {
  const Meeting& meeting = of.walls.empty() ? of.law.value() : of.wall_law.value();
  const bool sprung = of.tangential && compliant(of.tangential->law) && of.solver == one_collision;
  if (!sprung || of.tangential->torsion.limit == Torsion::Limit::disc || !is_stepped(meeting)) return std::nullopt;
  const Made made{meeting, *of.tangential, rule, places, rubs};
  // Every such case has its normal along x and its slip along y, spins about z and x.
  const Body& a = of.bodies.front();
  Oblique at{{a.mass, HUGE_VAL}, {a.radius, 0}, 0, {a.velocity.y, 0}, {a.spin.z, 0}, {a.spin.x, 0}};
  double sign = 1;  // of the spin that moves the contact point against y
  if (of.walls.empty()) {
    const Body& b = of.bodies.at(1);
    at.mass[1] = b.mass, at.radius[1] = b.radius, at.across[1] = b.velocity.y;
    at.turning[0] = -a.spin.z, at.turning[1] = -b.spin.z, at.spinning[1] = b.spin.x, sign = -1;
    at.rate = a.velocity.x - b.velocity.x;
  } else {
    at.rate = -a.velocity.x;
  }
  constexpr int fine = 8000;
  const Oblique coarse = stepped(at, made, of.duration, of.time_scale / fine),
                finer = stepped(at, made, of.duration, of.time_scale / (2 * fine));
  Solution solution{.bodies = of.bodies, .error = 1e-6};
  const auto limit = [](double c, double f) { return 2 * f - c; };
  const double centre =
      of.walls.empty() ? (a.mass * a.velocity.x + at.mass[1] * of.bodies[1].velocity.x) / (a.mass + at.mass[1]) : 0;
  const double rate = limit(coarse.rate, finer.rate);
  const double mass_eff = 1 / (inverse(at.mass[0]) + inverse(at.mass[1]));
  for (std::size_t k = 0; k < solution.bodies.size(); ++k) {
    Body& body = solution.bodies[k];
    body.velocity.x = of.walls.empty() ? centre + (k == 0 ? 1 : -1) * mass_eff / at.mass[k] * rate : -rate;
    body.velocity.y = limit(coarse.across[k], finer.across[k]);
    body.spin.z = sign * limit(coarse.turning[k], finer.turning[k]);
    body.spin.x = limit(coarse.spinning[k], finer.spinning[k]);
  }
  return solution;
}

}  // namespace ricochet::verify::conformance
