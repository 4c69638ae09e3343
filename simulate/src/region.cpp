#include <simulate/region.hpp>

#include "crowd.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ricochet::simulate {

using console::Node;

PourRegion::PourRegion(const Node& node, const Periodic& periodic) {
  if (node.has("axis")) {
    node.allow({"point", "axis", "radius"});
    const Vec3 point = node.at("point").vector(), along = node.at("axis").vector();
    const double length = norm(along), radius = node.at("radius").positive();
    if (!(length > 0)) node.at("axis").reject("a direction as long as the cylinder, not zero");
    const Vec3 axis = along / length;
    tube_ = Tube{point, axis, length, radius};
    for (double Vec3::*const c : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const double aside = radius * std::sqrt(std::max(0.0, 1 - axis.*c * axis.*c));
      low_.*c = std::min(point.*c, point.*c + along.*c) - aside;
      high_.*c = std::max(point.*c, point.*c + along.*c) + aside;
    }
    return;
  }
  node.allow({"low", "high"});
  low_ = node.at("low").vector(), high_ = node.at("high").vector();
  if (!(low_.x < high_.x && low_.y < high_.y && low_.z < high_.z)) node.at("high").reject("above low in x, y and z");
  for (double Vec3::*const c : {&Vec3::x, &Vec3::y, &Vec3::z})
    if (periodic.period.*c > 0 && high_.*c - low_.*c >= periodic.period.*c * (1 - 1e-9)) {
      open_.*c = 1;
      high_.*c = low_.*c + periodic.period.*c;
    }
}

double PourRegion::volume() const noexcept {
  if (tube_) return std::numbers::pi * tube_->radius * tube_->radius * tube_->length;
  const Vec3 size = high_ - low_;
  return size.x * size.y * size.z;
}

double PourRegion::margin(double radius, double Vec3::*axis) const noexcept { return open_.*axis > 0 ? 0 : radius; }

bool PourRegion::holds(Vec3 x, double radius) const noexcept {
  radius *= 1 - touching;
  if (tube_) {
    const double along = dot(x - tube_->point, tube_->axis);
    return along >= radius && along <= tube_->length - radius &&
           norm(tangential(x - tube_->point, tube_->axis)) <= tube_->radius - radius;
  }
  return std::ranges::all_of(std::array{&Vec3::x, &Vec3::y, &Vec3::z}, [&](double Vec3::*c) {
    return x.*c >= low_.*c + margin(radius, c) && x.*c <= high_.*c - margin(radius, c);
  });
}

bool PourRegion::fits(double radius) const noexcept {
  if (tube_) return 2 * radius <= tube_->length && radius <= tube_->radius;
  return std::ranges::all_of(std::array{&Vec3::x, &Vec3::y, &Vec3::z},
                             [&](double Vec3::*c) { return 2 * margin(radius, c) <= high_.*c - low_.*c; });
}

Vec3 PourRegion::somewhere(double radius, Random& random) const noexcept {
  // Of a cylinder about half of the box around it, for most directions of its axis.
  for (;;) {
    Vec3 x;
    for (double Vec3::*const c : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const double room = margin(radius, c);
      x.*c = random.between(low_.*c + room, high_.*c - room);
    }
    if (!tube_ || holds(x, radius)) return x;
  }
}

}  // namespace ricochet::simulate
