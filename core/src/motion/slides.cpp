#include "slides.hpp"

#include <algorithm>

namespace ricochet::motion {
namespace {

RICOCHET_INNERMOST void hold_lanes(Slides& s, double step) noexcept {
  for (std::size_t k = 0; k < Slides::lanes; ++k) {
    const ContactGeometry g{.normal = s.normal[k], .arm_i = s.arm_i[k], .arm_j = s.arm_j[k]};
    const bool wall = s.wall[k] != 0;
    const Vec3 n = g.normal, v = s.velocity[k], wi = s.spin_i[k], wj = s.spin_j[k];
    const double span = s.span[k], m = s.mobility[k], drag = step * s.damping[k];
    const Vec3 then = normal_before(g, v, wall ? 0 : span);
    const Vec3 moved =
        slip_between(n, v, g.arm_i * wi + g.arm_j * wj) - span / step * turning(g, v, wi, wj, wall, 0.5 * step);
    const Vec3 start = turned(s.elongation[k], then, n);
    const Vec3 strain = tangential(s.of_strain[k] * start + s.of_motion[k] * span * moved, n);
    const Vec3 foreseen = slip_between(n, s.velocity_mid[k], s.swing[k]);
    const Vec3 free = foreseen - 0.5 * m * tangential(s.last[k], n);
    s.then.set(k, then), s.moved.set(k, moved), s.start.set(k, start), s.strain.set(k, strain);
    s.foreseen.set(k, foreseen), s.free.set(k, free);
    s.impulse.set(k, -1.0 / (1 + 0.5 * drag * m) * (step * s.stiffness[k] * strain + drag * free));
  }
}

RICOCHET_INNERMOST void conclude_lanes(Slides& s, double step) noexcept {
  for (std::size_t k = 0; k < Slides::lanes; ++k) {
    const Vec3 impulse = s.impulse[k], start = s.start[k], strain = s.strain[k];
    const Vec3 mean = s.free[k] + 0.5 * s.mobility[k] * impulse;
    const double middle = 0.5 * s.stiffness[k] * dot(strain, strain);
    const double change = middle - 0.5 * s.stiffness_then[k] * dot(start, start);
    const double stored = std::max(0.0, middle + 0.5 * step / s.span[k] * change);
    const double burnt = step * s.damping[k] * dot(mean, mean);
    const double released = s.strained[k] - stored - dot(impulse, mean);
    const bool sticks = (s.slides[k] == 0) & (s.stiffness[k] == s.stiffness_then[k]);
    s.stored[k] = stored, s.lost[k] = sticks ? burnt : released;
    const Vec3 lever = cross(s.normal[k], impulse);
    s.mean.set(k, mean), s.on_i.set(k, s.arm_i[k] * lever), s.on_j.set(k, s.arm_j[k] * lever);
  }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void hold_avx2(Slides& s, double step) noexcept { hold_lanes(s, step); }
[[gnu::target("avx2")]] void conclude_avx2(Slides& s, double step) noexcept { conclude_lanes(s, step); }
#endif

}  // namespace

void hold(Slides& s, double step, [[maybe_unused]] Instructions by) noexcept {
#if defined(__x86_64__)
  if (by == Instructions::avx2) return hold_avx2(s, step);
#endif
  hold_lanes(s, step);
}

void conclude(Slides& s, double step, [[maybe_unused]] Instructions by) noexcept {
#if defined(__x86_64__)
  if (by == Instructions::avx2) return conclude_avx2(s, step);
#endif
  conclude_lanes(s, step);
}

}  // namespace ricochet::motion
