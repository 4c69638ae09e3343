#pragma once

#include <cmath>

namespace ricochet {

/// A vector of space, no more than the engine needs. Aggregate: Vec3{x, y, z}.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  bool operator==(const Vec3&) const = default;
  constexpr Vec3& operator+=(Vec3 o) noexcept { return x += o.x, y += o.y, z += o.z, *this; }
  constexpr Vec3& operator-=(Vec3 o) noexcept { return x -= o.x, y -= o.y, z -= o.z, *this; }
  constexpr Vec3& operator*=(double s) noexcept { return x *= s, y *= s, z *= s, *this; }
};

constexpr Vec3 operator+(Vec3 a, Vec3 b) noexcept { return a += b; }
constexpr Vec3 operator-(Vec3 a, Vec3 b) noexcept { return a -= b; }
constexpr Vec3 operator-(Vec3 a) noexcept { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double s, Vec3 a) noexcept { return a *= s; }
constexpr Vec3 operator*(Vec3 a, double s) noexcept { return a *= s; }
constexpr Vec3 operator/(Vec3 a, double s) noexcept { return {a.x / s, a.y / s, a.z / s}; }

constexpr double dot(Vec3 a, Vec3 b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr Vec3 cross(Vec3 a, Vec3 b) noexcept {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(Vec3 a) noexcept { return std::sqrt(dot(a, a)); }
/// The part of `a` in the plane normal to the unit vector `e`.
constexpr Vec3 tangential(Vec3 a, Vec3 e) noexcept { return a - dot(a, e) * e; }

}  // namespace ricochet
