#pragma once

#include <ricochet/support/root.hpp>

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

namespace ricochet::collision {

/// One-step integration by Runge-Kutta-Fehlberg 7(8) whose steps can be redone at any shorter length: events are
/// located to the method's own order. A system has a State, an array, and its rate of change, which knows no time.
///
/// The method's own estimate of its error is h(k₁ + k₁₁ − k₁₂ − k₁₃)·41/840, the difference of rates at the same two
/// times: of a rate that depends on time alone, as one along a given motion may, it sees nothing. A system that says
/// `scale(i)`, how large an error a step may make in a component, is therefore stepped by halves as well, and the
/// difference to the whole is the estimate; for one that does not, see `relative`.
template <class System>
class Steps {
 public:
  using State = typename System::State;

  Steps(const System& system, const State& start, std::size_t budget, double first_length)
      : system_(system), before_(start), after_(start), budget_(budget), length_(first_length) {}

  /// One accepted step of at most that length; false when the budget is spent.
  bool advance(double longest = std::numeric_limits<double>::infinity()) {
    before_ = after_;
    while (evaluations_ < budget_) {
      taken_ = std::min(length_, longest);
      const double excess = try_step();
      const double next = taken_ * std::clamp(0.9 * std::pow(excess, -1.0 / 8), 0.2, 4.0);
      length_ = excess <= 1 && taken_ < length_ ? std::max(length_, next) : next;
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
    return support::root([&](double length) { return value(at(length)); }, 0.0, limit, left, right);
  }

  const State& before() const { return before_; }
  const State& after() const { return after_; }
  double taken() const { return taken_; }
  std::size_t evaluations() const { return evaluations_; }

 private:
  static constexpr std::size_t stages = 13;
  using Stepper = boost::numeric::odeint::runge_kutta_fehlberg78<State>;

  static constexpr bool by_halves = requires(const System& system) { system.scale(0); };

  /// Takes a step to `after_`; how many tolerances its error is.
  double try_step() {
    State error;
    evaluations_ += stages;
    stepper_.do_step(std::cref(system_), before_, 0.0, after_, taken_, error);
    if constexpr (by_halves) {
      const State whole = after_;
      after_ = at(0.5 * taken_);
      evaluations_ += stages;
      stepper_.do_step(std::cref(system_), after_, 0.0, 0.5 * taken_);
      for (std::size_t i = 0; i < error.size(); ++i) error[i] = after_[i] - whole[i];
    }
    return in_tolerances(error);
  }

  /// Local error a step, relative to the component and to its change over the step: the change keeps the scale where a
  /// velocity passes through zero, and nothing absolute spoils the small velocities of a strongly damped rebound. A
  /// collision takes some tens of steps.
  static double relative(double before, double after) { return 3e-15 * (std::abs(after) + std::abs(after - before)); }

  /// The largest component of the error estimate, in tolerances; NaN and infinity count as large.
  double in_tolerances(const State& error) const {
    double largest = 1e-10;
    for (std::size_t i = 0; i < error.size(); ++i) {
      if (error[i] == 0) continue;
      double scale = relative(before_[i], after_[i]);
      if constexpr (by_halves) scale = system_.scale(i);
      const double share = std::abs(error[i]) / scale;
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

}  // namespace ricochet::collision
