#include "state_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::simulate {
namespace {

// Sums of many roundings stay far below this share.
constexpr double rounding = 1e-6;

// Of the box's farthest corner from the origin.
double farthest_corner(Vec3 low, Vec3 high) {
  const auto greater = [](double a, double b) { return std::max(std::abs(a), std::abs(b)); };
  return norm(Vec3{greater(low.x, high.x), greater(low.y, high.y), greater(low.z, high.z)});
}

}  // namespace

StateBounds::StateBounds(const Scene& scene, std::uint64_t steps)
    : step_(scene.options.step),
      latest_(static_cast<double>(steps + 1) * step_),
      moves_(static_cast<double>(steps) + 1) {
  double first_move = 0;
  for (const Sphere& s : scene.setup.spheres) farthest_ = std::max(farthest_, norm(s.position));
  for (const Pour& pour : scene.pours)
    farthest_ = std::max(farthest_, farthest_corner(pour.region.low(), pour.region.high()));
  for (std::size_t k = 0; k < scene.sphere_count(); ++k)
    first_move = std::max(first_move, step_ * norm(scene.sphere(k).velocity));
  farthest_ += first_move;
}

double StateBounds::speed(const Sphere& sphere) const noexcept {
  return std::max(sphere.radius / step_, norm(sphere.velocity)) * (1 + rounding);
}

double StateBounds::distance(const Sphere& sphere) const noexcept {
  return (farthest_ + moves_ * sphere.radius) * (1 + rounding);
}

double StateBounds::spin(const Sphere& sphere) noexcept {
  const double inertia = 0.4 * sphere.mass() * sphere.radius * sphere.radius;
  return std::sqrt(std::numeric_limits<double>::max() / std::max(inertia, 1.0)) / 2;
}

}  // namespace ricochet::simulate
