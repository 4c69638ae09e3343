#pragma once

#include <ricochet/contact/vec3.hpp>

#include <optional>

namespace ricochet::contact {

/// Speeds at the edge of the contact disc, both ≥ 0: x of sliding, y of spinning, λ = x/y.
struct Speeds {
  double x, y;
};

/// The speeds with x = X − αF(x/y), y = Y − β𝒯(x/y), the implicit step of friction. Nothing if there are none above
/// zero: then (X/α, Y/β) lies inside the limit curve and the contact sticks. The root is unique as (F, 𝒯) is the
/// gradient of a convex function.
std::optional<Speeds> resisted(Speeds start, double alpha, double beta) noexcept;

/// Whether the limit curve holds (force, torque), both in units of the sliding limit.
bool admits_stick(double force, double torque) noexcept;

/// a/|a|; 0 of 0.
inline Vec3 unit(Vec3 a) noexcept {
  const double length = norm(a);
  return length > 0 ? a / length : Vec3{};
}

}  // namespace ricochet::contact
