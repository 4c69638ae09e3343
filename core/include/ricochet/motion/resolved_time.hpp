#pragma once

#include <ricochet/contact/laws.hpp>

#include <cmath>
#include <limits>
#include <numbers>

namespace ricochet::motion {

// About how long a binary collision of a law lasts at `mass` [kg] and `speed` [m/s], the time that a step has to
// resolve [s]: never much more than what the collision takes, and less where the law is damped so strongly that the
// velocity is gone long before. Infinite where nothing would ever push back.

double resolved_time(const Linear& law, double mass, double speed);
double resolved_time(const KuwabaraKono& law, double mass, double speed);
double resolved_time(const Tsuji& law, double mass, double speed);
double resolved_time(const Hysteretic& law, double mass, double speed);
double resolved_time(const Fractional& law, double mass, double speed);
double resolved_time(const FractionalKelvinVoigt& law, double mass, double speed);
double resolved_time(const FractionalHertz& law, double mass, double speed);
double resolved_time(const FractionalZener& law, double mass, double speed);
template <ArmsLaw Law>
double resolved_time(const Law& law, double mass, double speed) {
  return resolved_time(law.law(), mass, speed);
}

/// The greatest |R| [N] of a law while a mass that meets it at a speed comes to rest, to some 10 %: steps that change
/// the speed by no more than a 30th, the force at their end standing for all of them.
template <ContactLaw Law>
double greatest_force(const Law& law, double mass, double speed) {
  constexpr int most_steps = 20'000;
  constexpr double part = 1.0 / 30;
  typename Law::Memory memory{};
  Approach a{0, speed};
  double greatest = 0, dt = 1;
  for (int n = 0; n < most_steps && a.rate > 0 && dt > 0; ++n) {
    typename Law::Memory trial = memory;
    Approach next{a.overlap + a.rate * dt, a.rate};
    law.advance(trial, a, next, dt);
    const double force = law.force(next, trial);
    if (!(std::abs(force) * dt <= part * mass * speed)) {
      dt *= 0.5;
      continue;
    }
    greatest = std::max(greatest, std::abs(force));
    memory = trial;
    next.rate -= force * dt / mass;
    a = next;
    if (std::abs(force) * dt < 0.25 * part * mass * speed) dt *= 2;
    if (!std::isfinite(a.overlap)) break;
  }
  return greatest;
}

/// Any other law: π m v/R_max, the time of a linear collision without damping that has the same greatest force. As the
/// force must take at least m v, it is at most π times what the collision lasts; a dashpot alone gives π m/c.
template <ContactLaw Law>
double resolved_time(const Law& law, double mass, double speed) {
  const double force = speed > 0 ? greatest_force(law, mass, speed) : 0;
  return force > 0 ? std::numbers::pi * mass * speed / force : std::numeric_limits<double>::infinity();
}

}  // namespace ricochet::motion
