#include "scaled_contact.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::collision {

Approach ScaledContact::in_units(double x, double w) const noexcept {
  return {std::max(0.0, x) * impact_.velocity * unit_, w * impact_.velocity};
}

Instant ScaledContact::touch() {
  law_.touch();
  stiffness_ = 0;
  ++evaluations_;
  return {0, 0, 1, scaled(law_.force(in_units(0, 1)))};
}

Instant ScaledContact::step(const Instant& now, double h) {
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  constexpr int most_trials = 30;
  Instant next = now;
  next.time = now.time + h;
  const auto residual = [&](double w) {
    next.rate = w;
    next.overlap = now.overlap + 0.5 * h * (now.rate + w);
    next.force = scaled(law_.try_step(in_units(now.overlap, now.rate), in_units(next.overlap, w), h * unit_));
    ++evaluations_;
    return w - now.rate + h * (0.5 * (now.force + next.force) - load_);
  };
  // Secants, the first with the slope of the step before.
  double slope = 1 + 0.5 * h * stiffness_;
  double w = now.rate + h * (load_ - now.force) / slope, off = residual(w);
  for (int trial = 1; trial < most_trials; ++trial) {
    const double change = -off / slope;
    if (!(std::abs(change) > rounding * (std::abs(w) + std::abs(now.rate) * 0.5))) break;
    const double before = off;
    off = residual(w + change);
    const double secant = (off - before) / change;
    w += change;
    if (secant > 0.5 && std::isfinite(secant)) slope = secant;
  }
  stiffness_ = std::max(0.0, 2 * (slope - 1) / h);
  return next;
}

std::optional<double> time_scale(DrivenLaw& law, const Impact& impact) {
  const Approach start{0, impact.velocity};
  double t = 1e-100;
  for (int n = 0; n < 222; ++n, t *= 8) {  // up to 1e100
    law.touch();
    const double force = law.try_step(start, {impact.velocity * t, impact.velocity}, t);
    if (!(force * t <= 0.03 * impact.mass_eff * impact.velocity)) return t;  // a force that is no number shows later
  }
  return std::nullopt;
}

}  // namespace ricochet::collision
