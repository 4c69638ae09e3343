#include <ricochet/motion/engine/compliant_contact.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::motion {
namespace {

Vec3 unit(Vec3 a) noexcept {
  const double length = norm(a);
  return length > 0 ? a / length : Vec3{};
}

// Direction of the traction −q halfway since the memory, should the contact slide: q_n ∥ k ξ + (k span/2 + c) u.
Vec3 halfway(Spring s, Vec3 elongation, Vec3 rate, double span) noexcept {
  return -unit(s.stiffness * elongation + (0.5 * span * s.stiffness + s.damping) * rate);
}

// A growing contact keeps its force: (kξ)' = k u; a shrinking one its strain: ξ' = u.
Vec3 strained(double k_then, double k_now, Vec3 before, Vec3 moved) noexcept {
  if (k_now <= k_then || k_now <= 0) return before + moved;
  return (k_then * before + 0.5 * (k_then + k_now) * moved) / k_now;
}

// ξ after `span` under a load from `first` to `last`, linear in time: k ξ + c ξ' = load.
Vec3 relaxed(Spring s, Vec3 elongation, Vec3 first, Vec3 last, double span) noexcept {
  if (!(s.stiffness > 0)) return {};
  if (s.damping == 0) return last / s.stiffness;
  const double z = s.stiffness * span / s.damping, decay = std::exp(-z), share = -std::expm1(-z) / z;
  return decay * elongation + (last - decay * first - share * (last - first)) / s.stiffness;
}

// The impulse that spring and dashpot pass while nothing gives way; `free` is the motion at the step's end without it.
// Of a fresh contact ∫kξ dt = ½k t² u.
Vec3 held_impulse(Spring s, Vec3 elongation, Vec3 before, Vec3 free, double mobility,
                  const CompliantRow& row) noexcept {
  const double t = row.duration, drag = t * (s.damping + (row.fresh ? 0.5 * t * s.stiffness : 0));
  return -1.0 / (1 + 0.5 * drag * mobility) * (t * s.stiffness * elongation + 0.5 * drag * (before + free));
}

Vec3 scalar(double x) noexcept { return {x, 0, 0}; }

// A traction over its limit points where the slide leads it: on through `between`, where its length was the mean of
// that before and of the limit.
Vec3 led(Vec3 wanted, double limit, Vec3 before, Vec3 between) noexcept {
  const double size = norm(wanted);
  if (size <= limit || between == Vec3{}) return wanted;
  const Vec3 after = unit((norm(before) + limit) * between - before);
  return size * (dot(after, between) > 0 ? after : between);
}

}  // namespace

CompliantRow compliant_row(const TangentialContact& law, const ContactState& c, const CompliantApproach& a) noexcept {
  CompliantRow row;
  row.pressing = a.pressing;
  row.span = c.lag, row.duration = a.step;
  row.fresh = c.fresh;
  if (c.fresh) {
    row.span = row.duration = c.lag + 0.5 * a.step;
    return row;
  }
  row.before = turned(c.elongation, a.normal_then, a.normal);
  row.spring_then = spring(law.law, c.approach.overlap);
  const Spring slide = spring(law.law, a.pressing.overlap), roll = law.rolling.spring;
  const double t = row.span;
  row.held = {
      tangential(strained(row.spring_then.stiffness, slide.stiffness, row.before.slide, t * a.motion.slip), a.normal),
      row.before.twist + t * a.motion.spin, tangential(row.before.roll + t * a.motion.roll, a.normal)};
  // The first step's impulse was not that of a whole step: what the springs hold has to do.
  if (c.lag < a.step) {
    row.last = {-row.spring_then.stiffness * row.before.slide, -law.torsion.spring.stiffness * row.before.twist,
                -roll.stiffness * row.before.roll};
  } else {
    const Elongation passed =
        turned({c.friction.sliding, c.friction.torsion, c.friction.rolling}, a.normal_then, a.normal);
    row.last = {passed.slide / a.step, passed.twist / a.step, passed.roll / a.step};
  }
  row.slide = halfway(row.spring_then, row.before.slide, a.motion.slip, t);
  if (roll.stiffness > 0) row.roll = halfway(roll, row.before.roll, a.motion.roll, t);
  return row;
}

FrictionSolution compliant_impulse(const TangentialContact& law, CompliantRow& row, const FrictionProblem& p,
                                   const FrictionImpulse& guess) noexcept {
  const double t = row.duration;
  const SlipMobility& m = p.mobility;
  const Vec3 slip = p.free.slip + m.cross * guess.rolling;
  const double speed = norm(0.5 * (p.before.slip + slip + m.slip * guess.sliding));
  row.pressing.force = p.normal_impulse / t;
  const TangentialState s = tangential_state(law, row.pressing, speed);
  Traction wanted;
  wanted.sliding = led(held_impulse(s.sliding, row.held.slide, p.before.slip, slip, m.slip, row) / t, s.sliding_limit,
                       row.last.sliding, row.slide);
  if (s.torsion.stiffness > 0)
    wanted.torsion =
        held_impulse(s.torsion, scalar(row.held.twist), scalar(p.before.spin), scalar(p.free.spin), m.roll, row).x / t;
  if (s.rolling.stiffness > 0) {
    const Vec3 roll = p.free.roll + m.cross * guess.sliding;
    wanted.rolling = led(held_impulse(s.rolling, row.held.roll, p.before.roll, roll, m.roll, row) / t, s.rolling_limit,
                         row.last.rolling, row.roll);
  }
  row.answer = limited(s, wanted, t);
  const Traction& found = row.answer.traction;
  return {.impulse = {t * found.sliding, t * found.torsion, t * found.rolling},
          .sticks = !row.answer.slides && !row.answer.twists,
          .holds_roll = !row.answer.rolls,
          .slip_fraction = 0};
}

namespace {

// What the contact's loads −T were at the memory and are at its next time.
struct Loads {
  Traction first, last;
};

Loads loads_of(const CompliantRow& row, double force) noexcept {
  const Traction& t = row.answer.traction;
  if (!row.fresh)
    return {{-row.last.sliding, -row.last.torsion, -row.last.rolling}, {-t.sliding, -t.torsion, -t.rolling}};
  // Of a fresh contact the traction is a mean; at the end it has grown with the force that limits it.
  const double growth = row.pressing.force > 0 ? std::max(0.0, force) / row.pressing.force : 0;
  const Traction end{growth * t.sliding, growth * t.torsion, growth * t.rolling};
  return {{end.sliding - 2 * t.sliding, end.torsion - 2 * t.torsion, end.rolling - 2 * t.rolling},
          {-end.sliding, -end.torsion, -end.rolling}};
}

Elongation elongation_after(const CompliantRow& row, const TangentialState& s, const SlipMotion& mean,
                            double force) noexcept {
  const double t = row.duration;
  Elongation e = row.fresh ? Elongation{t * mean.slip, t * mean.spin, t * mean.roll} : row.held;
  if (!row.answer.slides && !row.answer.twists && !row.answer.rolls) return e;
  const Loads q = loads_of(row, force);
  if (row.answer.slides) e.slide = relaxed(s.sliding, row.before.slide, q.first.sliding, q.last.sliding, row.span);
  if (row.answer.twists)
    e.twist = relaxed(s.torsion, scalar(row.before.twist), scalar(q.first.torsion), scalar(q.last.torsion), row.span).x;
  if (row.answer.rolls) e.roll = relaxed(s.rolling, row.before.roll, q.first.rolling, q.last.rolling, row.span);
  return e;
}

}  // namespace

CompliantEnd compliant_end(const TangentialContact& law, const CompliantRow& row, const ContactState& contact,
                           const FrictionImpulse& impulse, const SlipMotion& mean, double force) noexcept {
  const double t = row.duration;
  const TangentialState s = tangential_state(law, row.pressing, 0);
  CompliantEnd end{.elongation = elongation_after(row, s, mean, force)};
  end.stored = stored_energy(s, end.elongation).sum();
  if (!row.fresh) {
    TangentialState then = s;
    then.sliding = row.spring_then;
    // From the middle on to the end, as since the memory.
    const double change = end.stored - stored_energy(then, row.before).sum();
    end.stored = std::max(0.0, end.stored + 0.5 * t / row.span * change);
  }
  const bool yields = row.answer.slides || row.answer.twists || row.answer.rolls;
  const bool constant = s.sliding.stiffness == row.spring_then.stiffness;
  const double work = dot(impulse.sliding, mean.slip) + impulse.torsion * mean.spin + dot(impulse.rolling, mean.roll);
  if (yields || row.fresh || !constant)
    end.lost = contact.strained - end.stored - work;
  else
    end.lost = t * (s.sliding.damping * dot(mean.slip, mean.slip) + s.torsion.damping * mean.spin * mean.spin +
                    s.rolling.damping * dot(mean.roll, mean.roll));
  return end;
}

}  // namespace ricochet::motion
