#include "closed_forms.hpp"

#include <cmath>
#include <numbers>

namespace ricochet::collision {
namespace {

using std::numbers::pi;

/// The damping ratio as an angle: D = cos ψ, or cosh ψ when overdamped. Formed from (1−D)(1+D), so that ψ and sin ψ
/// (sinh ψ) keep their ratio through D = 1.
struct DampingAngle {
  explicit DampingAngle(double ratio)
      : overdamped(ratio > 1),
        sine(std::sqrt(std::abs((1 - ratio) * (1 + ratio)))),
        angle(overdamped ? std::asinh(sine) : std::atan2(sine, ratio)) {}

  double angle_over_sine() const { return sine == 0 ? 1 : angle / sine; }

  bool overdamped;
  double sine, angle;
};

/// Scaled ζ = exp(−D t) sin(θ)/sin ψ, θ = sin ψ · t, has its maximum at θ = ψ; its force exp(−D t) sin(2ψ−θ)/sin ψ has
/// the maximum at θ = 3ψ − π where that is positive, else at the first touch, and its zero at 2ψ.
Collision linear_extremes(double ratio, const DampingAngle& psi) {
  Collision out;
  out.time_max_overlap = psi.angle_over_sine();
  out.max_overlap = std::exp(-ratio * out.time_max_overlap);
  const bool rises = !psi.overdamped && 3 * psi.angle > pi;
  out.time_max_force = rises ? (3 * psi.angle - pi) / psi.sine : 0;
  out.max_force = rises ? std::exp(-ratio * out.time_max_force) : 2 * ratio;
  return out;
}

/// Where a fast-unloading spring that has lost its force at ζ₀ carries on to ζ = 0: it swings about ζ₀ with the
/// amplitude ζ_max k₁/k₂, which reaches 0 only for k₂ ≤ 2k₁.
void carry_on_to_zero_overlap(Collision& out, double ratio) {
  const double sine = (1 - ratio) / ratio;
  if (sine > 1) {
    out.status = CollisionStatus::no_separation;
    out.tcol = out.en = out.overlap_end = 0;
    return;
  }
  out.status = CollisionStatus::ended_by_overlap;
  out.tcol += std::sqrt(ratio) * std::asin(sine);
  out.en *= std::sqrt((1 - sine) * (1 + sine));
  out.overlap_end = 0;
}

}  // namespace

Collision closed_form(const Linear& law, const Impact& impact, ContactEnd end) {
  const double unit = std::sqrt(impact.mass_eff / law.k());
  const double ratio = 0.5 * law.c() / impact.mass_eff * unit;
  if (!std::isfinite(ratio)) return {.status = CollisionStatus::out_of_range};
  const DampingAngle psi(ratio);
  Collision out = linear_extremes(ratio, psi);
  if (end == ContactEnd::force) {
    out.status = CollisionStatus::ended_by_force;
    out.tcol = 2 * psi.angle_over_sine();
    out.en = std::exp(-ratio * out.tcol);
    out.overlap_end = 2 * ratio * out.en;
  } else if (ratio < 1) {
    out.status = CollisionStatus::ended_by_overlap;
    out.tcol = pi / psi.sine;
    out.en = std::exp(-ratio * out.tcol);
  }
  return in_units(out, impact, unit);
}

Collision closed_form(const Hysteretic& law, const Impact& impact, ContactEnd end) {
  const double unit = std::sqrt(impact.mass_eff / law.k1());
  const double ratio = law.k1() / law.k2();
  Collision out;
  out.status = CollisionStatus::ended_by_force;
  out.max_overlap = out.max_force = 1;
  out.time_max_overlap = out.time_max_force = 0.5 * pi;
  out.en = std::sqrt(ratio);
  out.tcol = 0.5 * pi * (1 + out.en);
  out.overlap_end = 1 - ratio;
  if (end == ContactEnd::overlap) carry_on_to_zero_overlap(out, ratio);
  return in_units(out, impact, unit);
}

}  // namespace ricochet::collision
