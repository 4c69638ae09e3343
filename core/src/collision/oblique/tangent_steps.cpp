// The way of a compliant contact that shares the disc's limit: by steps of the contact's own.

#include "tangent_motion.hpp"

#include <utility>

namespace ricochet::collision {
namespace {

using State = TangentMotion::State;

void add(State& y, std::size_t part, Vec3 a) noexcept {
  y[part] += a.x;
  y[part + 1] += a.y;
}

Vec3 plane(const State& y, std::size_t part) noexcept { return {y[part], y[part + 1], 0}; }

}  // namespace

/// One step: the contact's answer to the motion at its start, with the pressing at its end.
struct TangentMotion::Walk {
  Elongation elongation{};
  Pressing before{};
  double stored = 0;
  bool slid = false;
};

void TangentMotion::step(Stepped& out, Walk& walk, double from, double to, bool loading) const {
  State& y = out.state;
  const NormalInstant normal = path_.at(to, loading);
  const Lever l = lever(i_, j_, arm_, normal.overlap);
  const double dt = path_.at(0.5 * (from + to), loading).pace * (to - from), arm_j = j_.is_wall() ? 0 : j_.radius;
  const Vec3 turn = plane(y, turn_i), turn_of_j = plane(y, turn_j), roll_i = roll_i_ + turn,
             roll_j = roll_j_ + turn_of_j;
  const SlipMotion motion{slip_ + plane(y, velocity) + l.arm_i * turn + l.arm_j * turn_of_j +
                              (l.arm_i - i_.radius) * roll_i_ + (l.arm_j - arm_j) * roll_j_,
                          spin_ + y[spin], roll_i - roll_j};
  const Pressing after{normal.force, normal.overlap, l.radius, radius_eff_};
  const TangentialStep s = tangential_step(contact_, walk.elongation, motion, walk.before, after, dt);
  const Traction& t = s.answer.traction;
  add(y, velocity, dt * inverse_mass_ * t.sliding);
  add(y, turn_i, dt * inverse_i_ * (l.arm_i * t.sliding + t.rolling));
  add(y, turn_j, dt * inverse_j_ * (l.arm_j * t.sliding - t.rolling));
  y[spin] += dt * (inverse_i_ + inverse_j_) * t.torsion;
  y[clock] += dt;
  y[burnt] += s.dashpots.sum();
  y[slid + sliding] += s.sliders.sliding, y[slid + torsion] += s.sliders.torsion,
      y[slid + rolling] += s.sliders.rolling;
  if (!s.answer.slides) out.stick_time += dt;
  out.switches += s.answer.slides != walk.slid ? 1 : 0;
  walk = {s.elongation, after, s.stored.sum(), s.answer.slides};
}

TangentMotion::Stepped TangentMotion::stepped(int steps) const {
  Stepped out;
  Walk walk{.before = {.radius_eff = radius_eff_}};
  for (const bool loading : {true, false}) {
    const double start = loading ? 0 : path_.turn(), way = (loading ? path_.turn() : path_.length()) - start;
    for (int n = 0; n < steps; ++n) step(out, walk, start + way * n / steps, start + way * (n + 1) / steps, loading);
  }
  out.state[place] = path_.length();
  out.state[slid + sliding] += walk.stored;
  return out;
}

}  // namespace ricochet::collision
