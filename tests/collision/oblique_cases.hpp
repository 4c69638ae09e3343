#pragma once

#include <ricochet/collision/oblique.hpp>

#include <cmath>
#include <numbers>

namespace oblique {

using namespace ricochet;

/// The aluminium oxide sphere of Kharaz, Gorham and Salman against a wall, with the linear laws that engines give it.
inline constexpr double radius = 2.5e-3, speed = 3.9;
inline ImpactBody sphere(Vec3 velocity, Vec3 spin = {}) {
  return {4.0 / 3 * std::numbers::pi * radius * radius * radius * 4000, radius, velocity, spin};
}
inline ObliqueImpact at_angle(double degrees, Vec3 spin = {}) {
  const double angle = degrees * std::numbers::pi / 180;
  return {.i = sphere({speed * std::sin(angle), 0, speed * std::cos(angle)}, spin)};
}

inline double inertia(const ImpactBody& b) { return b.inertia_ratio * b.mass * b.radius * b.radius; }
inline double energy(const ImpactBody& b) {
  return b.is_wall() ? 0 : 0.5 * b.mass * dot(b.velocity, b.velocity) + 0.5 * inertia(b) * dot(b.spin, b.spin);
}
/// Kinetic energy, of a moving wall in its own frame.
inline double energy(const ObliqueImpact& impact) {
  if (!impact.j.is_wall()) return energy(impact.i) + energy(impact.j);
  ImpactBody i = impact.i;
  i.velocity -= impact.j.velocity;
  return energy(i);
}
/// The same bodies after the collision.
inline ObliqueImpact after(ObliqueImpact impact, const ObliqueCollision& out) {
  impact.i.velocity = out.velocity_i, impact.i.spin = out.spin_i;
  if (!impact.j.is_wall()) impact.j.velocity = out.velocity_j, impact.j.spin = out.spin_j;
  return impact;
}

/// R = kζ^{3/2}(1 + c ζ'), K. H. Hunt and F. R. E. Crossley: a law of one's own, which only the generic path knows.
class HuntCrossley {
 public:
  using Memory = NoMemory;
  static constexpr std::string_view name = "hunt-crossley";
  HuntCrossley(double k, double c) : k_(k), c_(c) {}
  double force(Approach a, const Memory&) const noexcept {
    return k_ * a.overlap * std::sqrt(std::max(0.0, a.overlap)) * (1 + c_ * a.rate);
  }
  void advance(Memory&, Approach, Approach, double) const noexcept {}
  double stored_energy(Approach a, const Memory&) const noexcept {
    return 0.4 * k_ * a.overlap * a.overlap * std::sqrt(std::max(0.0, a.overlap));
  }
  double dissipated_power(Approach a, const Memory&) const noexcept {
    return k_ * a.overlap * std::sqrt(std::max(0.0, a.overlap)) * c_ * a.rate * a.rate;
  }

 private:
  double k_, c_;
};

/// f(law) of a law of every kind, each with a restitution of its own and about the same duration.
template <class F>
void each_law(const F& f) {
  f(Linear(1.72e7, 0));
  f(Linear(1.72e7, 12));
  f(KuwabaraKono(4e9, 1500));
  f(Tsuji(4e9, 150));
  f(Hysteretic(1.2e7, 2.4e7));
  f(Fractional(1.5e7, 60, 0.2));
  f(HuntCrossley(4e9, 0.1));
}

}  // namespace oblique
