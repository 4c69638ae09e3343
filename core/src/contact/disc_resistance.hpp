#pragma once

#include <ricochet/contact/friction.hpp>
#include <ricochet/contact/vec3.hpp>

#include <optional>

namespace ricochet::contact {

/// As DiscFriction, with F'(λ): 𝒯' = −λF', as (F, 𝒯) is the gradient of a function of first degree.
struct DiscCurve {
  double force, torque, slope;
};
/// F' to 1e-9 of itself.
DiscCurve disc_curve(double lambda) noexcept;

/// Speeds at the edge of the contact disc, both ≥ 0: x of sliding, y of spinning, λ = x/y.
struct Speeds {
  double x, y;
};

/// Friction at the speeds x = X − αF(x/y), y = Y − β𝒯(x/y), the implicit step. Nothing if there are none above zero:
/// then (X/α, Y/β) lies inside the limit curve and the contact sticks. The root is unique as (F, 𝒯) is the gradient of
/// a convex function. `guess`: of x/y, where one is known; 0 and ∞ are none.
std::optional<DiscFriction> resisted(Speeds start, double alpha, double beta, double guess = 0) noexcept;

/// The ratio x/y at which the disc's friction is about `force` and `torque`, to 0.05 of itself.
double ratio_of(DiscFriction friction) noexcept;

/// Whether the limit curve holds (force, torque), both in units of the sliding limit.
bool admits_stick(double force, double torque) noexcept;

/// a/|a|; 0 of 0.
inline Vec3 unit(Vec3 a) noexcept {
  const double length = norm(a);
  return length > 0 ? a / length : Vec3{};
}

}  // namespace ricochet::contact
