#pragma once

#include <calibrate/calibration.hpp>
#include <ricochet/collision/oblique.hpp>
#include <ricochet/collision/tangential_restitution.hpp>
#include <ricochet/contact/tangential.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace ricochet::calibration {

/// Friction that never slides, but where R itself vanishes.
inline constexpr double endless_friction = 1e9;

/// A sphere of the effective mass against a wall: the relative motion of any two homogeneous spheres. Its radius has no
/// part in velocities.
inline ObliqueImpact impact_at(const Impact& impact, double tangential) {
  return {.i = {.mass = impact.mass_eff, .radius = 1, .velocity = {tangential, 0, impact.velocity}}};
}

inline TangentialContact contact_of(const TangentialLaw& law, double mu) {
  return {.law = law, .friction = {mu, mu, 0}};
}

/// What a contact that sticks throughout does: β₀, and the strain that is left over, in u_t t_col.
struct Stuck {
  double beta = 0, strain = 0;
};

/// The contact that sticks, under one normal law at one impact, in units of m_t = 2m/7 and t_col.
class Sticking {
 public:
  Sticking(const AnyLaw& normal, ContactEnd end, const Impact& impact, double tcol)
      : normal_(normal), end_(end), impact_(impact), tcol_(tcol) {}

  double mass() const { return tangential_mass_ratio * impact_.mass_eff; }
  double tcol() const { return tcol_; }
  std::size_t evaluations() const { return evaluations_; }

  Stuck operator()(const TangentialLaw& law) const {
    ++evaluations_;
    const double slip = impact_.velocity;
    const auto out = collide(normal_, contact_of(law, endless_friction), impact_at(impact_, slip), {.end = end_});
    if (!out.separated() || !out.beta) throw NotConverged("the oblique collision could not be followed");
    const double k = spring(law, out.normal.max_overlap).stiffness;
    return {*out.beta, std::sqrt(2 * std::max(0.0, out.lost.stored) / k) / (slip * tcol_)};
  }

 private:
  const AnyLaw& normal_;
  ContactEnd end_;
  Impact impact_;
  double tcol_;
  mutable std::size_t evaluations_ = 0;
};

}  // namespace ricochet::calibration
