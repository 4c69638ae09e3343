#include "numerical_collision.hpp"
#include "steps.hpp"

#include <cmath>
#include <optional>

namespace ricochet::collision {
namespace {

constexpr double first_step = 0.05;
/// Slower than this and still overlapping, under an attractive force: bodies creep under Kuwabara and Kono's law, and
/// count as never parting. The overlap of the other two returns, or does not, by its damping ratio.
constexpr double creeping = 1e-13;
/// A rebound slower than this is not followed: powers of y leave the range of a double.
constexpr double slowest = 1e-150;
/// From this γ on the reduced force is followed instead of the velocity.
constexpr double strong = 2;

double position(const std::array<double, 3>& s) { return s[0]; }

/// Notes the greatest overlap and force of the last step, if they lie in its first `limit`: only what is in contact
/// counts, though within one step, a small part of a collision, nothing greater comes past the end.
template <class Motion>
void note_extremes(Collision& out, const Motion& motion, Steps<Motion>& steps, double limit) {
  if (const auto peak = steps.fall([&](const auto& s) { return motion.force_slope(s); }, limit)) {
    const auto state = steps.at(*peak);
    if (motion.force(state) > out.max_force) {
      out.max_force = motion.force(state);
      out.time_max_force = state[2];
    }
  }
  if (const auto turn = steps.fall([&](const auto& s) { return motion.rate(s); }, limit)) {
    const auto state = steps.at(*turn);
    out.max_overlap = motion.overlap(state);
    out.time_max_overlap = state[2];
  }
}

/// Ends the collision in `state`, at the end that was asked for. An elastic contact loses force and overlap together.
template <class Motion>
void end_at(Collision& out, const Motion& motion, const typename Motion::State& state, ContactEnd end) {
  const bool by_force = end == ContactEnd::force;
  out.status = by_force ? CollisionStatus::ended_by_force : CollisionStatus::ended_by_overlap;
  out.tcol = state[2];
  out.en = -motion.rate(state);
  out.overlap_end = by_force && !motion.elastic() ? motion.overlap(state) : 0;
}

/// The end, if the last step holds it. The step is first cut where the overlap returns to zero: the polynomial motion
/// goes on beyond, but the bodies do not.
template <class Motion>
std::optional<double> end_in_step(const Motion& motion, Steps<Motion>& steps, ContactEnd end) {
  const auto apart = steps.fall(position, steps.taken());
  if (end == ContactEnd::overlap || motion.elastic()) return apart;
  const double limit = apart.value_or(steps.taken());
  const auto slack = steps.fall([&](const auto& s) { return motion.reduced_force(s); }, limit);
  return slack ? slack : apart;
}

template <class Motion>
double first_length(const Motion& motion) {
  const auto start = motion.start();
  typename Motion::State change;
  motion(start, change, 0.0);
  return first_step / (1 + std::abs(change[1] / start[1]));
}

/// Follows the motion to its end, or to where it is slower than `least_speed` under an attractive force.
template <class Motion>
Collision follow_down_to(double least_speed, const Motion& motion, const CollideOptions& options) {
  Steps<Motion> steps(motion, motion.start(), options.max_evaluations, first_length(motion));
  Collision out;
  out.max_force = motion.force(steps.after());
  while (steps.advance()) {
    const auto end = end_in_step(motion, steps, options.end);
    note_extremes(out, motion, steps, end.value_or(steps.taken()));
    if (end) end_at(out, motion, steps.at(*end), options.end);
    out.evaluations = steps.evaluations();
    const bool slow = motion.reduced_force(steps.after()) < 0 && std::abs(motion.rate(steps.after())) < least_speed;
    if (end || slow) return out;
  }
  out.status = CollisionStatus::budget_spent;
  out.evaluations = steps.evaluations();
  return out;
}

}  // namespace

template <int P, int Q, int R>
Collision follow(const DampedPower<P, Q, R>& motion, const CollideOptions& options) {
  using Motion = DampedPower<P, Q, R>;
  const bool by_overlap = options.end == ContactEnd::overlap;
  const bool stays = by_overlap && motion.gamma >= overdamped_from<Motion>;
  const bool returns = by_overlap && !stays && std::isfinite(overdamped_from<Motion>);
  CollideOptions asked = options;
  if (stays) asked.end = ContactEnd::force;  // for the extremes
  const double least_speed = returns ? slowest : creeping;
  Collision out = motion.gamma > strong ? follow_down_to(least_speed, StronglyDampedPower<P, Q, R>(motion), asked)
                                        : follow_down_to(least_speed, motion, asked);
  if (stays && out.separated()) {
    out.status = CollisionStatus::no_separation;
    out.tcol = out.en = out.overlap_end = 0;
  }
  if (returns && out.status == CollisionStatus::no_separation) out.status = CollisionStatus::out_of_range;
  return out;
}

template Collision follow(const LinearMotion&, const CollideOptions&);
template Collision follow(const KuwabaraKonoMotion&, const CollideOptions&);
template Collision follow(const TsujiMotion&, const CollideOptions&);

namespace {

/// ζ'' = −ζ up to the turning point.
struct Loading {
  using State = std::array<double, 3>;
  static double rate(const State& s) { return s[1]; }
  void operator()(const State& s, State& change, double) const { change = {s[1], -s[0], 1.0}; }
};

/// ζ'' = −k₂(ζ − ζ₀) from there on, in δ = ζ − ζ₀: of ζ itself only the last k₁/k₂ would be left.
struct Unloading {
  using State = std::array<double, 3>;
  double stiffening, rest;  // k₂/k₁ and ζ₀

  bool elastic() const { return stiffening == 1; }
  double overlap(const State& s) const { return rest + s[0]; }
  static double rate(const State& s) { return s[1]; }
  void operator()(const State& s, State& change, double) const { change = {s[1], -stiffening * s[0], 1.0}; }
};

using Point = std::optional<Loading::State>;

/// Loads to the turning point; none when the budget is spent.
Point load(Steps<Loading>& steps) {
  while (steps.advance())
    if (const auto turn = steps.fall(Loading::rate, steps.taken())) return steps.at(*turn);
  return std::nullopt;
}

/// Unloads to the asked end, or to where the motion turns inwards again about ζ₀; false when the budget is spent.
bool unload(const Unloading& motion, Steps<Unloading>& steps, ContactEnd end, Collision& out) {
  const auto value = [&](const auto& s) { return end == ContactEnd::force ? s[0] : motion.overlap(s); };
  while (steps.advance()) {
    const auto inwards = steps.fall([](const auto& s) { return -s[1]; }, steps.taken());
    const auto found = steps.fall(value, inwards.value_or(steps.taken()));
    if (found) end_at(out, motion, steps.at(*found), end);
    if (found || inwards) return true;
  }
  return false;
}

}  // namespace

Collision follow_hysteretic(double stiffening, const CollideOptions& options) {
  Collision out{.status = CollisionStatus::budget_spent};
  const Loading loading;
  Steps<Loading> up(loading, {0.0, 1.0, 0.0}, options.max_evaluations, first_step);
  const Point turn = load(up);
  out.evaluations = up.evaluations();
  if (!turn || out.evaluations >= options.max_evaluations) return out;
  out.max_overlap = out.max_force = (*turn)[0];
  out.time_max_overlap = out.time_max_force = (*turn)[2];
  const double reach = (*turn)[0] / stiffening;
  const Unloading unloading{stiffening, (*turn)[0] - reach};
  Steps<Unloading> down(unloading, {reach, 0.0, (*turn)[2]}, options.max_evaluations - out.evaluations,
                        first_step / std::sqrt(stiffening));
  if (unload(unloading, down, options.end, out)) {
    if (!out.separated()) out.status = CollisionStatus::no_separation;
  }
  out.evaluations += down.evaluations();
  return out;
}

}  // namespace ricochet::collision
