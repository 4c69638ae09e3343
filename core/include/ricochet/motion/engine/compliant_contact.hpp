#pragma once

#include <ricochet/contact/geometry.hpp>
#include <ricochet/contact/tangential.hpp>
#include <ricochet/motion/contact_state.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::motion {

// A contact with springs in its tangent plane over one step of the leapfrog scheme. Elongations live where positions
// do, in the middle of the steps, velocities between them:
//
//   ξ_{n+1/2} = ξ_{n−1/2} + h u_n,  P = −h (k ξ_{n+1/2} + c (u_n + u_{n+1})/2),  |P| ≤ μ ∫R dt.
//
// The spring is explicit, so contacts at rest on each other ask for no sweeps; the dashpot is implicit, so it does not
// limit the step. Order 2 while it sticks (Störmer-Verlet, the dashpot by the midpoint rule).
//
// While it slides, q = k ξ + c ξ' has the limit's length and the direction of k ξ + c u. The midpoint rule on ξ' over
// the step from n−1/2 is a radial return at its middle, q_n ∥ k ξ_{n−1/2} + (k h/2 + c) u_n, and q goes on through it:
// q_{n+1/2} ∥ 2 q_n − q_{n−1/2}, |q_n| being the mean of the two limits. ξ then follows its load by the exact solution
// for loads linear in time. Switches between stick and slip are O(1) steps with a local error O(h²): order 2 as a
// whole. A stiffness that starts like √t (Mindlin's), and torsion that shares the disc's limit with a slide whose λ
// changes, have order 1.5 and 1 in the limit, the latter as the cut to the curve is a first-order return.

// All of it stands in the engine's innermost loop; `Turns`: some spring resists torsion or rolling.
#define RICOCHET_INNERMOST [[gnu::always_inline]] inline

/// How the contact comes into the middle of the step.
struct CompliantApproach {
  Vec3 normal_then, normal;  ///< at the time of the memory and now
  SlipMotion motion;         ///< mean since then
  Pressing pressing;         ///< in the middle; its force is that of the answer
  double step = 0;           ///< Δt [s]
  double since_touch = 0;    ///< of a fresh contact, at the step's end [s]
};

/// What is known of the contact before the step's impulses are sought, and the answer found last.
struct CompliantRow {
  CompliantApproach approach;
  Elongation before;               ///< at the time of the memory, turned to the present normal
  Elongation held;                 ///< in the middle of the step, should the contact stick
  Spring spring_then, spring_now;  ///< against sliding, at the time of the memory and in the middle
  double span = 0;      ///< from the memory to the middle; of a fresh contact from the touch to the step's end [s]
  double duration = 0;  ///< over which the impulse acts [s]
  bool fresh = false;
  LimitedTraction answer;
};

/// The memory after the step, in its middle (of a fresh contact at its end), and what its springs hold at the step's
/// end [J].
struct CompliantEnd {
  Elongation elongation;
  double stored = 0;
};

namespace compliant {

RICOCHET_INNERMOST Vec3 unit(Vec3 a) noexcept {
  const double length = norm(a);
  return length > 0 ? a / length : Vec3{};
}

/// Whether any spring resists torsion or rolling.
inline bool turns(const TangentialContact& law) noexcept {
  return law.torsion.spring.stiffness > 0 || law.rolling.spring.stiffness > 0;
}

/// Direction of the traction −q halfway since the memory, should the contact slide: q_n ∥ k ξ + (k span/2 + c) u.
RICOCHET_INNERMOST Vec3 halfway(Spring s, Vec3 elongation, Vec3 rate, double span) noexcept {
  return -unit(s.stiffness * elongation + (0.5 * span * s.stiffness + s.damping) * rate);
}

/// A growing contact keeps its force: (kξ)' = k u; a shrinking one its strain: ξ' = u.
struct Carried {
  double strain = 1, motion = 1;  ///< ξ = strain·ξ_then + motion·∫u dt
};
RICOCHET_INNERMOST Carried carried(double k_then, double k_now) noexcept {
  if (k_now <= k_then || k_now <= 0) return {};
  return {k_then / k_now, 0.5 * (k_then + k_now) / k_now};
}

/// ξ after `span` under a load from `first` to `last`, linear in time: k ξ + c ξ' = load.
inline Vec3 relaxed(Spring s, Vec3 elongation, Vec3 first, Vec3 last, double span) noexcept {
  if (!(s.stiffness > 0)) return {};
  if (s.damping == 0) return last / s.stiffness;
  const double z = s.stiffness * span / s.damping, decay = std::exp(-z), share = -std::expm1(-z) / z;
  return decay * elongation + (last - decay * first - share * (last - first)) / s.stiffness;
}

/// The same of a spring that changes: a growing contact's force relaxes, (kξ)' = k (load − kξ)/c, a shrinking one's
/// strain towards load/k. Order 2, and exact where k is constant.
inline Vec3 slid(Spring then, Spring now, Vec3 elongation, Vec3 first, Vec3 last, double span) noexcept {
  if (now.stiffness == then.stiffness) return relaxed(now, elongation, first, last, span);
  if (!(now.stiffness > 0)) return {};
  const Spring mean{0.5 * (then.stiffness + now.stiffness), now.damping};
  const double shrunk = mean.stiffness / now.stiffness;
  if (now.stiffness < then.stiffness)
    return relaxed(mean, elongation, mean.stiffness / then.stiffness * first, shrunk * last, span);
  return shrunk * relaxed(mean, then.stiffness / mean.stiffness * elongation, first, last, span);
}

/// The impulse that spring and dashpot pass while nothing gives way; `free` is the motion at the step's end without it.
/// Of a fresh contact ∫kξ dt = ½k t² u.
RICOCHET_INNERMOST Vec3 held_impulse(Spring s, Vec3 elongation, Vec3 before, Vec3 free, double mobility,
                                     const CompliantRow& row) noexcept {
  const double t = row.duration, drag = t * (s.damping + (row.fresh ? 0.5 * t * s.stiffness : 0));
  return -1.0 / (1 + 0.5 * drag * mobility) * (t * s.stiffness * elongation + 0.5 * drag * (before + free));
}

inline Vec3 scalar(double x) noexcept { return {x, 0, 0}; }

/// Tractions at the time of the memory, turned. The first step's impulse was not that of a whole step: there what the
/// springs hold has to do.
inline Traction last_tractions(const TangentialContact& law, const ContactState& c, const CompliantRow& row) noexcept {
  const CompliantApproach& a = row.approach;
  if (c.lag < a.step)
    return {-row.spring_then.stiffness * row.before.slide, -law.torsion.spring.stiffness * row.before.twist,
            -law.rolling.spring.stiffness * row.before.roll};
  const Elongation passed =
      turned({c.friction.sliding, c.friction.torsion, c.friction.rolling}, a.normal_then, a.normal);
  return {passed.slide / a.step, passed.twist / a.step, passed.roll / a.step};
}

/// A traction over its limit points where the slide leads it: on through `between`, where its length was the mean of
/// that before and of the limit.
RICOCHET_INNERMOST Vec3 led(Vec3 wanted, double limit, Vec3 before, Vec3 between) noexcept {
  if (between == Vec3{}) return wanted;
  const Vec3 after = unit((norm(before) + limit) * between - before);
  return norm(wanted) * (dot(after, between) > 0 ? after : between);
}
RICOCHET_INNERMOST bool over(Vec3 wanted, double limit) noexcept { return dot(wanted, wanted) > limit * limit; }

/// What the contact's loads −T were at the memory and are at its next time.
struct Loads {
  Traction first, last;
};

inline Loads loads_of(const TangentialContact& law, const ContactState& c, const CompliantRow& row,
                      double force) noexcept {
  const Traction& t = row.answer.traction;
  if (!row.fresh) {
    const Traction last = last_tractions(law, c, row);
    return {{-last.sliding, -last.torsion, -last.rolling}, {-t.sliding, -t.torsion, -t.rolling}};
  }
  // Of a fresh contact the traction is a mean; at the end it has grown with the force that limits it.
  const double pressed = row.approach.pressing.force, growth = pressed > 0 ? std::max(0.0, force) / pressed : 0;
  const Traction end{growth * t.sliding, growth * t.torsion, growth * t.rolling};
  return {{end.sliding - 2 * t.sliding, end.torsion - 2 * t.torsion, end.rolling - 2 * t.rolling},
          {-end.sliding, -end.torsion, -end.rolling}};
}

RICOCHET_INNERMOST bool yields(const CompliantRow& row) noexcept {
  return row.answer.slides || row.answer.twists || row.answer.rolls;
}

template <bool Turns>
RICOCHET_INNERMOST Elongation elongation_after(const TangentialContact& law, const ContactState& c,
                                               const CompliantRow& row, const TangentialState& s,
                                               const SlipMotion& mean, double force) noexcept {
  const double t = row.duration;
  Elongation e = row.held;
  if (row.fresh) e.slide = t * mean.slip;
  if (Turns && row.fresh) e.twist = t * mean.spin, e.roll = t * mean.roll;
  if (!yields(row)) return e;
  const Loads q = loads_of(law, c, row, force);
  const Spring then = row.fresh ? s.sliding : row.spring_then;
  if (row.answer.slides) e.slide = slid(then, s.sliding, row.before.slide, q.first.sliding, q.last.sliding, row.span);
  if (!Turns) return e;
  if (row.answer.twists)
    e.twist = relaxed(s.torsion, scalar(row.before.twist), scalar(q.first.torsion), scalar(q.last.torsion), row.span).x;
  if (row.answer.rolls) e.roll = relaxed(s.rolling, row.before.roll, q.first.rolling, q.last.rolling, row.span);
  return e;
}

}  // namespace compliant

template <bool Turns>
RICOCHET_INNERMOST CompliantRow compliant_row(const TangentialContact& law, const ContactState& c,
                                              const CompliantApproach& a) noexcept {
  CompliantRow row;
  row.approach = a;
  row.spring_now = spring(law.law, a.pressing.overlap);
  row.span = c.lag, row.duration = a.step;
  row.fresh = c.fresh;
  if (c.fresh) {
    row.span = row.duration = a.since_touch;
    return row;
  }
  row.spring_then = spring(law.law, c.approach.overlap);
  const Spring slide = row.spring_now;
  if (Turns)
    row.before = turned(c.elongation, a.normal_then, a.normal);
  else
    row.before.slide = turned({c.elongation.slide, 0, {}}, a.normal_then, a.normal).slide;
  const double t = row.span;
  const compliant::Carried over = compliant::carried(row.spring_then.stiffness, slide.stiffness);
  row.held.slide = tangential(over.strain * row.before.slide + over.motion * t * a.motion.slip, a.normal);
  if (!Turns) return row;
  row.held.twist = row.before.twist + t * a.motion.spin;
  row.held.roll = tangential(row.before.roll + t * a.motion.roll, a.normal);
  return row;
}

/// As friction_impulse, of springs. `sticks`: neither sliding nor torsion are at their limit.
template <bool Turns>
RICOCHET_INNERMOST FrictionSolution compliant_impulse(const TangentialContact& law, const ContactState& c,
                                                      CompliantRow& row, const FrictionProblem& p,
                                                      const FrictionImpulse& guess) noexcept {
  const double t = row.duration, per_time = 1 / t;
  const SlipMobility& m = p.mobility;
  const SlipMotion& motion = row.approach.motion;
  const Vec3 slip = p.free.slip + m.cross * guess.rolling;
  const double speed =
      law.friction.depends_on_speed() ? norm(0.5 * (p.before.slip + slip + m.slip * guess.sliding)) : 0;
  row.approach.pressing.force = p.normal_impulse * per_time;
  const TangentialState s = tangential_state(law, row.approach.pressing, speed, row.spring_now);
  Traction wanted;
  wanted.sliding = per_time * compliant::held_impulse(s.sliding, row.held.slide, p.before.slip, slip, m.slip, row);
  const bool slides = !row.fresh && compliant::over(wanted.sliding, s.sliding_limit);
  if (slides)
    wanted.sliding = compliant::led(wanted.sliding, s.sliding_limit, compliant::last_tractions(law, c, row).sliding,
                                    compliant::halfway(row.spring_then, row.before.slide, motion.slip, row.span));
  if (Turns && s.torsion.stiffness > 0)
    wanted.torsion = per_time * compliant::held_impulse(s.torsion, compliant::scalar(row.held.twist),
                                                        compliant::scalar(p.before.spin),
                                                        compliant::scalar(p.free.spin), m.roll, row)
                                    .x;
  if (Turns && s.rolling.stiffness > 0) {
    const Vec3 roll = p.free.roll + m.cross * guess.sliding;
    wanted.rolling = per_time * compliant::held_impulse(s.rolling, row.held.roll, p.before.roll, roll, m.roll, row);
    if (!row.fresh && compliant::over(wanted.rolling, s.rolling_limit))
      wanted.rolling = compliant::led(wanted.rolling, s.rolling_limit, compliant::last_tractions(law, c, row).rolling,
                                      compliant::halfway(s.rolling, row.before.roll, motion.roll, row.span));
  }
  if constexpr (Turns) {
    row.answer = limited(s, wanted, t);
  } else {
    const contact::Cut sliding = contact::cut(wanted.sliding, s.sliding_limit);
    row.answer.traction.sliding = sliding.traction, row.answer.slides = sliding.limit;
  }
  const Traction& found = row.answer.traction;
  return {.impulse = {t * found.sliding, t * found.torsion, t * found.rolling},
          .sticks = !row.answer.slides && !row.answer.twists,
          .holds_roll = !row.answer.rolls,
          .slip_fraction = 0};
}

/// `mean` is the motion halfway between before and after the impulse, `force` the R at the end of a fresh contact's
/// step [N]. To be asked before the contact's own impulse of the last step is forgotten.
template <bool Turns>
RICOCHET_INNERMOST CompliantEnd compliant_end(const TangentialContact& law, const CompliantRow& row,
                                              const ContactState& contact, const SlipMotion& mean,
                                              double force) noexcept {
  const TangentialState s = tangential_state(law, row.approach.pressing, 0, row.spring_now);
  CompliantEnd end{.elongation = compliant::elongation_after<Turns>(law, contact, row, s, mean, force)};
  end.stored = stored_energy(s, end.elongation).sum();
  if (!row.fresh) {
    TangentialState then = s;
    then.sliding = row.spring_then;
    // From the middle on to the end, as since the memory.
    const double change = end.stored - stored_energy(then, row.before).sum();
    end.stored = std::max(0.0, end.stored + 0.5 * row.duration / row.span * change);
  }
  return end;
}

/// How a contact's loss over a step is told.
struct CompliantLoss {
  double released = 0;  ///< by which what its springs hold has fallen [J]
  double duration = 0;  ///< over which the impulse acts [s]; 0: nothing to tell
  double damping = 0;   ///< against sliding [N s/m]
  bool sticks = false;  ///< throughout, on springs of constant stiffness
};

RICOCHET_INNERMOST CompliantLoss compliant_loss(const CompliantRow& row, double released) noexcept {
  const Spring now = row.spring_now;
  const bool constant = now.stiffness == row.spring_then.stiffness;
  return {released, row.duration, now.damping, !compliant::yields(row) && !row.fresh && constant};
}

/// What a contact that sticks loses is its dashpots' c u²; else the work that the springs have not stored [J].
inline double lost(const CompliantLoss& l, const TangentialContact& law, const FrictionImpulse& impulse,
                   const SlipMotion& mean) noexcept {
  if (l.sticks)
    return l.duration * (l.damping * dot(mean.slip, mean.slip) + law.torsion.spring.damping * mean.spin * mean.spin +
                         law.rolling.spring.damping * dot(mean.roll, mean.roll));
  return l.released - (dot(impulse.sliding, mean.slip) + impulse.torsion * mean.spin + dot(impulse.rolling, mean.roll));
}

}  // namespace ricochet::motion
