#pragma once

#include <ricochet/contact/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::collision {

/// a/|a|, or `otherwise` of 0.
inline Vec3 direction(Vec3 a, Vec3 otherwise) noexcept {
  const double size = norm(a);
  return size > 0 ? a / size : otherwise;
}

/// Spring and dashpot side by side with a slider behind both, at one instant (contact/tangential.hpp): the force q
/// against the motion, whose velocity is v, and p = k ξ the spring's part of it. Torsion is the x component alone.
struct Element {
  double stiffness = 0, stiffness_rate = 0;  ///< k and dk/dt; where k grows p stays as it is, where it falls ξ
  double damping = 0;                        ///< c
  double limit = 0;                          ///< of |q|

  bool present() const noexcept { return stiffness > 0; }
  Vec3 wanted(Vec3 p, Vec3 v) const noexcept { return p + damping * v; }
};

/// What an element does over time while it sticks or slides.
struct ElementRates {
  Vec3 strain;         ///< how fast spring and dashpot are strained: v while it sticks, less what the slider takes
  double dashpot = 0;  ///< power burnt, ≥ 0
  double slider = 0;   ///< the same of the slider, and of a k that changes under strain
  double margin = 0;   ///< falls through 0 where the phase ends: |q| under its limit, or the slider's speed
};

/// ½|dk/dt|ξ².
inline double burnt_by_area(const Element& e, Vec3 p) noexcept {
  return 0.5 * std::abs(e.stiffness_rate) * dot(p, p) / (e.stiffness * e.stiffness);
}

inline ElementRates stuck(const Element& e, Vec3 p, Vec3 v) noexcept {
  return {v, e.damping * dot(v, v), burnt_by_area(e, p), e.limit - norm(e.wanted(p, v))};
}

/// Under the force L n, n the direction of what is wanted. With a dashpot the rate of strain is (q − p)/c. Without,
/// p = q stays on its limit, p' = L' n + L n': in strain n (L' − L k'/k)/k (k' counts where the contact shrinks), and
/// `sideways`; the rest of v is the slider's, along n.
inline ElementRates slides(const Element& e, double limit_rate, Vec3 n, Vec3 sideways, Vec3 p, Vec3 v) noexcept {
  if (e.damping > 0) {
    const Vec3 strain = (e.limit * n - p) / e.damping;
    const double speed = (norm(e.wanted(p, v)) - e.limit) / e.damping;
    return {strain, e.damping * dot(strain, strain), e.limit * speed + burnt_by_area(e, p), speed};
  }
  const double shrinking = std::min(0.0, e.stiffness_rate) / e.stiffness;
  const double follows = (limit_rate - e.limit * shrinking) / e.stiffness, speed = dot(n, v) - follows;
  return {follows * n + sideways, 0, e.limit * speed + burnt_by_area(e, p), speed};
}

}  // namespace ricochet::collision
