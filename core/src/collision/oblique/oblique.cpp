#include <ricochet/collision/oblique.hpp>
#include <ricochet/support/require.hpp>

#include "../steps.hpp"
#include "tangent_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace ricochet::collision {
namespace {

using State = TangentMotion::State;

/// The contact's frame: x, y in the plane, z = e.
struct Frame {
  Vec3 x, y, z;

  /// x along the slip, so that a slide that stays straight stays on x to the last bit; anywhere for a slip that is 0 or
  /// what rounding leaves of it, which has no direction in the plane.
  Frame(Vec3 normal, Vec3 slip) : z(normal) {
    const Vec3 skew = std::abs(z.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0},
               in_plane = tangential(direction(slip, {}), z);
    x = direction(tangential(norm(in_plane) > 0.9 ? in_plane : skew, z), {});
    y = cross(z, x);
  }
  Vec3 into(Vec3 a) const noexcept { return {dot(a, x), dot(a, y), dot(a, z)}; }
  Vec3 out(Vec3 a) const noexcept { return a.x * x + a.y * y + a.z * z; }
  ImpactBody into(ImpactBody b) const noexcept {
    b.velocity = into(b.velocity);
    b.spin = into(b.spin);
    return b;
  }
};

/// The mechanism whose margin falls through 0 first in the last step, and where.
struct Event {
  Mechanism mechanism;
  double length;
};

std::optional<Event> first_event(const TangentMotion& motion, Steps<TangentMotion>& steps, bool may_fail_at_once) {
  std::optional<Event> first;
  for (const Mechanism m : mechanisms) {
    if (!motion.present(m)) continue;
    const double left = motion.margin(m, steps.before()), right = motion.margin(m, steps.after());
    std::optional<double> where;
    if (left > 0 && right <= 0)
      where = steps.fall([&](const State& y) { return motion.margin(m, y); }, steps.taken());
    else if (left <= 0 && right < -motion.rounding(m) && may_fail_at_once)
      where = 0;  // the phase never held
    if (where && (!first || *where < first->length)) first = Event{m, *where};
  }
  return first;
}

/// Follows the phases from touch to the end of the repulsion.
class Follower {
 public:
  Follower(TangentMotion& motion, const NormalPath& path, std::size_t budget)
      : motion_(motion), path_(path), budget_(budget), length_(1e-3 * path.turn()) {}

  /// False when the budget is spent.
  bool run() {
    if (!motion_.moves()) return true;
    if (motion_.shares_compliant_disc()) return extrapolate();
    begin();
    if (!stretch(path_.turn())) return false;
    motion_.turn(y_);
    return stretch(path_.length());
  }

  const State& state() const { return y_; }
  double stick_time() const { return stick_time_; }
  int switches() const { return switches_; }
  std::size_t evaluations() const { return evaluations_; }

 private:
  /// A contact begins to stick unless a first short trial of that goes beyond the limit; a rigid one slides if it
  /// moves.
  void begin() {
    motion_.phase.sticks.fill(true);
    if (motion_.rigid()) {
      motion_.head(y_);
      for (const Mechanism m : mechanisms) motion_.phase.sticks[m] = norm(motion_.phase.heading[m]) == 0;
      return;
    }
    Steps<TangentMotion> trial(motion_, y_, 1000, 1e-4 * path_.turn());
    trial.advance();
    std::array<bool, 3> sticks{};
    for (const Mechanism m : mechanisms) sticks[m] = !motion_.present(m) || motion_.margin(m, trial.after()) > 0;
    motion_.phase.sticks = sticks;
  }

  /// What is left of the way to `end`; 0 within rounding, and where nothing happens any more.
  double left(double end) const noexcept {
    const double way = end - y_[TangentMotion::place], rest = end < path_.length() ? 1e-14 : path_.margin();
    return way > rest * end ? way : 0;
  }

  /// The limit of steps whose error is of first order in their length.
  bool extrapolate() {
    constexpr int steps = 1 << 13;
    constexpr std::size_t all = std::size_t{6} * steps;
    evaluations_ = all;
    if (evaluations_ > budget_) return false;
    const auto coarse = motion_.stepped(steps), fine = motion_.stepped(2 * steps);
    for (std::size_t part = 0; part < y_.size(); ++part) y_[part] = 2 * fine.state[part] - coarse.state[part];
    stick_time_ = fine.stick_time;
    switches_ = fine.switches;
    return true;
  }

  bool stretch(double end) {
    while (left(end) > 0) {
      if (evaluations_ >= budget_) return false;
      Steps<TangentMotion> steps(motion_, y_, budget_ - evaluations_, length_);
      const std::optional<Mechanism> changed = walk(steps, end);
      evaluations_ += steps.evaluations();
      length_ = std::max(0.25 * steps.taken(), 1e-9 * end);
      if (changed)
        change(*changed);
      else if (left(end) > 0)
        return false;
    }
    return true;
  }

  /// To the next event, whose mechanism it gives, or to the end.
  std::optional<Mechanism> walk(Steps<TangentMotion>& steps, double end) {
    while (left(end) > 0) {
      motion_.head(y_);
      if (!steps.advance(left(end))) return std::nullopt;
      // Phases that end where they began may follow each other once a mechanism, before time has to go on.
      const auto event = first_event(motion_, steps, stalls_ < mechanisms.size());
      move_to(event ? steps.at(event->length) : steps.after());
      stalls_ = event && event->length == 0 ? stalls_ + 1 : 0;
      if (event) return event->mechanism;
    }
    return std::nullopt;
  }

  void move_to(const State& next) {
    if (motion_.phase.sticks[sliding]) stick_time_ += next[TangentMotion::clock] - y_[TangentMotion::clock];
    y_ = next;
  }

  void change(Mechanism m) {
    bool& sticks = motion_.phase.sticks[m];
    if (m == sliding) ++switches_;
    if (!sticks) motion_.settle(m, y_);
    sticks = !sticks;
    if (m == torsion && sticks && motion_.slip_dies_with_spin() && !motion_.phase.sticks[sliding]) change(sliding);
  }

  TangentMotion& motion_;
  const NormalPath& path_;
  std::size_t budget_, evaluations_ = 0;
  double length_, stick_time_ = 0;
  int switches_ = 0;
  std::size_t stalls_ = 0;  // events in a row at one and the same place
  State y_{};
};

void require_body(const ImpactBody& b) {
  support::require_positive("mass", b.mass);
  support::require_positive("radius", b.radius);
  support::require(b.inertia_ratio > 0 && b.inertia_ratio <= 2.0 / 3, "inertia_ratio", b.inertia_ratio,
                   "> 0 and <= 2/3");
}

void require_finite(Vec3 a, const char* name) {
  for (const double part : {a.x, a.y, a.z}) support::require(std::isfinite(part), name, part, "finite");
}

/// v'·v/v².
std::optional<double> share(Vec3 before, Vec3 after) {
  const double square = dot(before, before);
  return square > 0 ? std::optional(dot(before, after) / square) : std::nullopt;
}

/// u at a radius from the centres.
Vec3 slip(const ImpactBody& i, const ImpactBody& j, Vec3 e) {
  const Vec3 arms = i.radius * i.spin + (j.is_wall() ? Vec3{} : j.radius * j.spin);
  return tangential(i.velocity - j.velocity, e) + cross(arms, e);
}

/// Of any length, also where its square is no normal double.
Vec3 unit_normal(Vec3 normal) {
  const double greatest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
  return direction(normal / greatest, {});
}

bool finite(const ObliqueCollision& out) {
  const double spins = norm(out.spin_i) + norm(out.spin_j), velocities = norm(out.velocity_i) + norm(out.velocity_j);
  return std::isfinite(spins + velocities + norm(out.impulse) + out.lost.sum() + out.impulse_ratio +
                       out.et.value_or(0) + out.beta.value_or(0));
}

/// Adds what the impulse and the changes ΔW and ΔΩ make of the bodies: ω = e×W in the plane.
void move(ImpactBody& i, ImpactBody& j, const State& y, Vec3 impulse, const Frame& frame) {
  const auto turn = [&](ImpactBody& b, std::size_t part, double about) {
    b.spin += frame.out({-y[part + 1], y[part], about});
  };
  const auto inertia = [](const ImpactBody& b) { return b.inertia_ratio * b.mass * b.radius * b.radius; };
  const double spins = y[TangentMotion::spin];
  i.velocity += frame.out(impulse / i.mass);
  j.velocity -= frame.out(impulse / j.mass);
  if (j.is_wall()) return turn(i, TangentMotion::turn_i, spins);
  const double of_i = 1 / inertia(i), of_j = 1 / inertia(j);
  turn(i, TangentMotion::turn_i, spins * of_i / (of_i + of_j));
  turn(j, TangentMotion::turn_j, -spins * of_j / (of_i + of_j));
}

}  // namespace

Impact normal_impact(const ObliqueImpact& impact, const TangentialContact& tangential) {
  require_body(impact.i);
  if (!impact.j.is_wall()) require_body(impact.j);
  for (const auto& [vector, name] : {std::pair{impact.i.velocity, "velocity"},
                                     {impact.j.velocity, "velocity"},
                                     {impact.i.spin, "spin"},
                                     {impact.j.spin, "spin"},
                                     {impact.normal, "normal"}})
    require_finite(vector, name);
  support::require(impact.normal != Vec3{}, "normal", 0, "longer than 0");
  check(tangential);
  const double approach = dot(impact.i.velocity - impact.j.velocity, unit_normal(impact.normal));
  support::require(approach > 0, "speed of approach", approach, "> 0");
  return {approach, 1 / (1 / impact.i.mass + 1 / impact.j.mass)};
}

ObliqueCollision along(const NormalPath& path, const Collision& normal, const Collision& by_force,
                       const TangentialContact& tangential, const ObliqueImpact& impact,
                       const ObliqueOptions& options) {
  const Vec3 unit = unit_normal(impact.normal);
  const Frame frame(unit, slip(impact.i, impact.j, unit));
  const ObliqueImpact here{{0, 0, 1}, frame.into(impact.i), frame.into(impact.j)};
  TangentMotion motion(path, tangential, here, options, by_force);
  Follower follower(motion, path, options.max_evaluations);
  ObliqueCollision out{.status = normal.status, .normal = normal};
  const bool finished = path.complete() && follower.run();
  out.evaluations = follower.evaluations();
  if (!finished) {
    out.status = CollisionStatus::budget_spent;
    return out;
  }
  const State& y = follower.state();
  const double mass = 1 / (1 / here.i.mass + 1 / here.j.mass), approach = here.i.velocity.z - here.j.velocity.z;
  const Vec3 push{mass * y[TangentMotion::velocity], mass * y[TangentMotion::velocity + 1],
                  -mass * approach * (1 + normal.en)};
  ImpactBody i = impact.i, j = impact.j;
  move(i, j, y, push, frame);
  out.velocity_i = i.velocity, out.velocity_j = j.velocity;
  out.spin_i = i.spin, out.spin_j = j.spin;
  const auto centres = [&](const ImpactBody& a, const ImpactBody& b) {
    return ricochet::tangential(a.velocity - b.velocity, unit);
  };
  out.et = share(centres(impact.i, impact.j), centres(i, j));
  out.beta = share(slip(impact.i, impact.j, unit), slip(i, j, unit));
  if (out.beta) out.beta = -*out.beta;
  out.impulse = frame.out(push);
  out.impulse_ratio = std::hypot(push.x, push.y) / std::abs(push.z);
  out.stick_time = motion.moves() ? follower.stick_time() : out.beta ? 0 : by_force.tcol;
  out.slip_time = by_force.tcol - out.stick_time;
  out.switches = follower.switches();
  out.lost = {.normal = 0.5 * mass * approach * approach * (1 - normal.en) * (1 + normal.en),
              .dashpot = y[TangentMotion::burnt],
              .sliding = y[TangentMotion::slid + sliding],
              .torsion = y[TangentMotion::slid + torsion],
              .rolling = y[TangentMotion::slid + rolling]};
  if (!motion.shares_compliant_disc()) motion.give_up_strain(y, out.lost);
  return finite(out) ? out : ObliqueCollision{.status = CollisionStatus::out_of_range, .normal = normal};
}

}  // namespace ricochet::collision
