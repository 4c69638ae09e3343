#include "numerical_collision.hpp"

#include <boost/math/tools/toms748_solve.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>

namespace ricochet::motion {
namespace {

namespace odeint = boost::numeric::odeint;

// Local error a step, relative to the component and to its change over the step: the change keeps the scale where the
// velocity passes through zero, and nothing absolute spoils the small velocities of a strongly damped rebound. A collision
// takes some tens of steps.
constexpr double tolerance = 3e-15;
constexpr double first_step = 0.05;
/// Slower than this and still overlapping, under an attractive force: the bodies creep and count as never parting.
constexpr double creeping = 1e-13;

/// One-step integration whose steps can be redone at any shorter length: events are located to the method's own order.
template <class System>
class Steps {
 public:
  using State = typename System::State;

  Steps(const System& system, const State& start, std::size_t budget)
      : system_(system), before_(start), after_(start), budget_(budget),
        length_(first_step / (1 + first_deceleration(system, start))) {}

  /// One accepted step; false when the budget is spent.
  bool advance() {
    before_ = after_;
    while (evaluations_ < budget_) {
      evaluations_ += stages;
      State error;
      stepper_.do_step(std::cref(system_), before_, 0.0, after_, length_, error);
      const double excess = relative_to_tolerance(error, before_, after_);
      taken_ = length_;
      length_ *= std::clamp(0.9 * std::pow(excess, -1.0 / 8), 0.2, 4.0);
      if (excess <= 1) return true;
    }
    return false;
  }

  /// The state `length` into the last step.
  State at(double length) {
    if (length <= 0) return before_;
    State state = before_;
    evaluations_ += stages;
    stepper_.do_step(std::cref(system_), state, 0.0, length);
    return state;
  }

  /// Where in (0, limit] of the last step `value` falls through zero; none when it does not.
  template <class Value>
  std::optional<double> fall(Value value, double limit) {
    const double left = value(before_), right = value(limit == taken_ ? after_ : at(limit));
    if (!(left > 0 && right <= 0)) return std::nullopt;
    if (right == 0) return limit;
    std::uintmax_t trials = 60;
    const auto [low, high] = boost::math::tools::toms748_solve(
        [&](double length) { return value(at(length)); }, 0.0, limit, left, right,
        boost::math::tools::eps_tolerance<double>(), trials);
    return 0.5 * (low + high);
  }

  const State& before() const { return before_; }
  const State& after() const { return after_; }
  double taken() const { return taken_; }
  std::size_t evaluations() const { return evaluations_; }
  /// Goes on from a point inside the last step, with a system that has changed there.
  void resume(const State& state) { after_ = state; }

 private:
  static constexpr std::size_t stages = 13;
  using Stepper = odeint::runge_kutta_fehlberg78<State>;

  static double first_deceleration(const System& system, const State& s) {
    State rate;
    system(s, rate, 0.0);
    return std::abs(rate[1]);
  }

  /// The largest component of the error estimate, in tolerances; NaN and infinity count as large.
  static double relative_to_tolerance(const State& error, const State& before, const State& after) {
    double largest = 1e-10;
    for (std::size_t i = 0; i < after.size(); ++i) {
      const double scale = std::abs(after[i]) + std::abs(after[i] - before[i]);
      const double share = error[i] == 0 ? 0 : std::abs(error[i]) / (tolerance * scale);
      if (!(share <= largest)) largest = std::isfinite(share) ? share : 1e30;
    }
    return largest;
  }

  const System& system_;
  State before_, after_;
  std::size_t budget_, evaluations_ = 0;
  double length_, taken_ = 0;
  Stepper stepper_;
};

double position(const std::array<double, 3>& s) { return s[0]; }
double velocity(const std::array<double, 3>& s) { return s[1]; }

/// Notes the greatest overlap and force of the last step, if they lie in its first `limit`.
template <class Motion>
void note_extremes(Collision& out, const Motion& motion, Steps<Motion>& steps, double limit) {
  if (const auto peak = steps.fall([&](const auto& s) { return motion.force_slope(s); }, limit)) {
    const auto state = steps.at(*peak);
    if (motion.force(state) > out.max_force) {
      out.max_force = motion.force(state);
      out.time_max_force = state[2];
    }
  }
  if (const auto turn = steps.fall(velocity, limit)) {
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
  out.en = -state[1];
  out.overlap_end = by_force && !motion.elastic() ? Motion::overlap(state) : 0;
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

}  // namespace

template <class Motion>
Collision follow(const Motion& motion, const CollideOptions& options) {
  Steps<Motion> steps(motion, {0.0, 1.0, 0.0}, options.max_evaluations);
  Collision out;
  out.max_force = motion.force(steps.after());
  while (steps.advance()) {
    const auto end = end_in_step(motion, steps, options.end);
    note_extremes(out, motion, steps, end.value_or(steps.taken()));
    if (end) end_at(out, motion, steps.at(*end), options.end);
    out.evaluations = steps.evaluations();
    const bool creeps = motion.reduced_force(steps.after()) < 0 && std::abs(steps.after()[1]) < creeping;
    if (end || creeps) return out;
  }
  out.status = CollisionStatus::budget_spent;
  out.evaluations = steps.evaluations();
  return out;
}

template Collision follow(const LinearMotion&, const CollideOptions&);
template Collision follow(const KuwabaraKonoMotion&, const CollideOptions&);
template Collision follow(const TsujiMotion&, const CollideOptions&);

namespace {

/// ζ'' = −force of the law as engines run it, its memory fixed while one branch lasts.
// NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init): a Hysteretic without parameters cannot be made.
struct HystereticMotion {
  using State = std::array<double, 3>;

  bool elastic() const { return law.k1() == law.k2(); }
  static double overlap(const State& s) { return s[0]; }
  double force(const State& s) const { return law.force({s[0], s[1]}, memory); }
  void operator()(const State& s, State& rate, double) const { rate = {s[1], -force(s), 1.0}; }

  Hysteretic law;
  Hysteretic::Memory memory;
};

/// Loads to the turning point, where the memory learns the greatest overlap; false when the budget is spent.
bool load(HystereticMotion& motion, Steps<HystereticMotion>& steps, Collision& out) {
  while (steps.advance()) {
    const auto turn = steps.fall(velocity, steps.taken());
    if (!turn) continue;
    const auto state = steps.at(*turn);
    out.max_overlap = state[0];
    out.max_force = motion.force(state);
    out.time_max_overlap = out.time_max_force = state[2];
    motion.law.advance(motion.memory, {}, {state[0], state[1]}, 0);
    steps.resume({state[0], 0.0, state[2]});
    return true;
  }
  return false;
}

/// Unloads to the asked end, or to where the motion turns inwards again about ζ₀; false when the budget is spent.
bool unload(const HystereticMotion& motion, Steps<HystereticMotion>& steps, ContactEnd end, Collision& out) {
  const auto value = [&](const auto& s) { return end == ContactEnd::force ? motion.force(s) : s[0]; };
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
  HystereticMotion motion{Hysteretic(1, stiffening), {}};
  Steps<HystereticMotion> steps(motion, {0.0, 1.0, 0.0}, options.max_evaluations);
  Collision out;
  if (!load(motion, steps, out) || !unload(motion, steps, options.end, out)) out.status = CollisionStatus::budget_spent;
  out.evaluations = steps.evaluations();
  return out;
}

}  // namespace ricochet::motion
