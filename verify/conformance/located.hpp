#pragma once

#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace ricochet::verify::conformance {

using State = std::vector<double>;

/// Motion in modes: x' = rate(x) is smooth as long as no event happens, an event changes the mode. `Motion` has
///   void rate(const State& x, State& dxdt) const;
///   bool happened(const State& x) const;     whether x lies beyond an event of the present mode
///   void change(const State& x);             to the mode of x, just beyond an event
/// Follows it to `duration`. Errors of a step are held below `tolerance` times `scale` each; an event is located by
/// halving the step that it lies in down to the rounding of the time.
template <class Motion>
State follow_located(Motion& motion, State x, double duration, const State& scale, double tolerance, double first) {
  boost::numeric::odeint::runge_kutta_fehlberg78<State> stepper;
  const auto rate = [&](const State& at, State& dxdt, double) { motion.rate(at, dxdt); };
  double time = 0, step = std::min(first, duration);
  State next(x.size()), error(x.size());
  const auto attempt = [&](double h) { stepper.do_step(rate, x, time, next, h, error); };
  while (duration - time > 1e-14 * duration) {
    step = std::min(step, duration - time);
    attempt(step);
    double worst = 0;
    for (std::size_t i = 0; i < x.size(); ++i) worst = std::max(worst, std::abs(error[i]) / scale[i]);
    if (worst > tolerance && step > 1e-13 * first) {
      step *= std::max(0.2, 0.9 * std::pow(tolerance / worst, 1.0 / 8));
      continue;
    }
    double taken = step;
    if (motion.happened(next)) {
      double before = 0;
      while (taken - before > 1e-15 * (time + taken)) {
        const double middle = 0.5 * (before + taken);
        if (middle <= before || middle >= taken) break;
        attempt(middle);
        (motion.happened(next) ? taken : before) = middle;
      }
      attempt(taken);
      motion.change(next);
      step = first;
    } else {
      step *= std::min(3.0, 0.9 * std::pow(tolerance / std::max(worst, 1e-30), 1.0 / 8));
    }
    time += taken;
    x = next;
  }
  return x;
}

}  // namespace ricochet::verify::conformance
