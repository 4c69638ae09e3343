#include "disc_resistance.hpp"

#include <ricochet/contact/friction.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>
#include <utility>

namespace ricochet {

using contact::admits_stick, contact::resisted, contact::unit;

Friction::Friction(double mu_static, double mu_dynamic, double decay, double rolling_arm)
    : mu_static_(mu_static), mu_dynamic_(mu_dynamic), decay_(decay), rolling_arm_(rolling_arm) {
  support::require_not_negative("mu_static", mu_static);
  support::require_not_negative("mu_dynamic", mu_dynamic);
  support::require(mu_dynamic <= mu_static, "mu_dynamic", mu_dynamic, "at most mu_static");
  support::require_not_negative("decay", decay);
  support::require_not_negative("rolling_arm", rolling_arm);
}

namespace {

struct Slide {
  Vec3 impulse;
  double torsion = 0;
  bool sticks = false;
};

// Friction of the disc against a motion, with impulse limit μN.
Slide against(Vec3 direction, double spin_sign, DiscFriction f, double limit, double radius) noexcept {
  return {-limit * f.force * direction, -limit * radius * f.torque * spin_sign, false};
}

// Sliding and torsion, the rolling impulse given (within `free`).
Slide slide(const Friction& friction, const FrictionProblem& p, const SlipMotion& free, Slide guess) noexcept {
  const double a = p.contact_radius, N = p.normal_impulse;
  const Vec3 to_stop = free.slip + p.turning;
  const double hold = friction.mu_static() * N;
  if (!(hold > 0)) return {};
  if (admits_stick(norm(to_stop) / (p.mobility.slip * hold),
                   a > 0 ? std::abs(free.spin) / (p.mobility.roll * hold * a) : 0))
    return {-to_stop / p.mobility.slip, a > 0 ? -free.spin / p.mobility.roll : 0, true};

  const Vec3 middle = 0.5 * (p.before.slip + free.slip);
  const double limit = friction.coefficient(norm(middle + 0.5 * p.mobility.slip * guess.impulse)) * N;
  const double alpha = limit * p.mobility.slip, beta = limit * p.mobility.roll * a * a;
  // Midpoint rule: the impulse is that of the motion in the middle of the step.
  const double spin = 0.5 * (p.before.spin + free.spin);
  const double like = guess.torsion != 0 ? contact::ratio_of({norm(guess.impulse), std::abs(guess.torsion) / a}) : 0;
  if (const auto f = resisted({norm(middle), a * std::abs(spin)}, 0.5 * alpha, 0.5 * beta, like)) {
    const Slide s = against(unit(middle), std::copysign(1.0, spin), *f, limit, a);
    const double end_spin = free.spin + p.mobility.roll * s.torsion;
    if (dot(free.slip + p.mobility.slip * s.impulse, middle) >= 0 && end_spin * spin >= 0) return s;
  }
  // Implicit Euler: the impulse is that of the motion at the end.
  if (const auto f = resisted({norm(to_stop), a * std::abs(free.spin)}, alpha, beta, like))
    return against(unit(to_stop), std::copysign(1.0, free.spin), *f, limit, a);
  return {-to_stop / p.mobility.slip, a > 0 ? -free.spin / p.mobility.roll : 0, true};  // μ(u) > its value at the guess
}

struct Roll {
  Vec3 impulse;
  bool holds = false;
};

// Rolling resistance, the sliding impulse given (within `free`): |impulse| ≤ ρ(w/2)N, Eq. (46).
Roll roll(const FrictionProblem& p, Vec3 free, double limit) noexcept {
  const double reach = p.mobility.roll * limit;
  if (norm(free) <= reach) return {-free / p.mobility.roll, limit > 0};
  const Vec3 middle = 0.5 * (p.before.roll + free);
  if (norm(middle) > 0.5 * reach) return {-limit * unit(middle), false};
  return {-limit * unit(free), false};
}

// Where in the step the slip reached zero, had the contact gone on sliding.
double slip_fraction(const Friction& friction, const FrictionProblem& p, const SlipMotion& free) noexcept {
  const double start = norm(p.before.slip);
  if (start == 0) return 0;
  const double limit = friction.coefficient(0.5 * start) * p.normal_impulse;
  const Vec3 direction = p.before.slip / start;
  const double end = dot(free.slip, direction) - limit * p.mobility.slip;
  return end < 0 ? start / (start - end) : 1.0;
}

}  // namespace

FrictionSolution friction_impulse(const Friction& friction, const FrictionProblem& p,
                                  const FrictionImpulse& guess) noexcept {
  FrictionSolution s;
  if (p.normal_impulse <= 0) return s;
  const SlipMobility& m = p.mobility;
  const double roll_limit = friction.rolling_arm() * p.contact_radius * p.normal_impulse;
  // Sliding and rolling act on each other. Try first that both end, which a sphere at rest needs: one 2×2 system.
  const Vec3 to_stop = p.free.slip + p.turning;
  const double determinant = m.slip * m.roll - m.cross * m.cross;
  const Vec3 held_roll = (m.cross * to_stop - m.slip * p.free.roll) / determinant;
  if (roll_limit > 0 && norm(held_roll) <= roll_limit)
    s.impulse.rolling = held_roll;
  else
    s.impulse.rolling = guess.rolling;

  const bool constant_mu = friction.decay() == 0 || friction.mu_dynamic() == friction.mu_static();
  SlipMotion free = p.free;
  Slide slid{guess.sliding, guess.torsion, false};
  for (int pass = 0; pass < 50; ++pass) {
    free.slip = p.free.slip + m.cross * s.impulse.rolling;
    const Slide before = std::exchange(slid, slide(friction, p, free, slid));
    const Roll rolled = roll(p, p.free.roll + m.cross * slid.impulse, roll_limit);
    // What the new rolling impulse would change in the slip, against what sliding friction can change.
    const double rolling_change = std::abs(m.cross) * norm(rolled.impulse - s.impulse.rolling);
    const double sliding_change = norm(slid.impulse - before.impulse);
    s.impulse = {slid.impulse, slid.torsion, rolled.impulse};
    s.sticks = slid.sticks;
    s.holds_roll = rolled.holds;
    const bool slide_settled = slid.sticks || constant_mu || sliding_change <= 1e-14 * norm(slid.impulse);
    if (rolling_change <= 1e-13 * m.slip * p.normal_impulse && slide_settled) break;
  }
  if (s.sticks) s.slip_fraction = slip_fraction(friction, p, free);
  return s;
}

}  // namespace ricochet
