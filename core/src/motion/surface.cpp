#include <ricochet/motion/engine/surface.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::motion {
namespace {

// A unit vector across another, the same for the same.
Vec3 across(Vec3 e) noexcept {
  const Vec3 other = std::abs(e.x) < 0.7 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 v = cross(e, other);
  return v / norm(v);
}

// The point of each form that is nearest to a sphere's centre, both from Wall::point.
struct Nearest {
  Vec3 x, axis;

  Vec3 operator()(const surface::Plane&) const noexcept { return x - dot(x, axis) * axis; }
  Vec3 operator()(const surface::Cylinder& c) const noexcept {
    return dot(x, axis) * axis + c.radius * radial().direction;
  }
  Vec3 operator()(const surface::Cone& c) const noexcept {
    const auto [direction, distance] = radial();
    // In the plane of axis and centre: the nearest point of the segment from (0, first) to (length, last).
    const double rise = c.last - c.first, square = c.length * c.length + rise * rise;
    const double share = std::clamp((dot(x, axis) * c.length + (distance - c.first) * rise) / square, 0.0, 1.0);
    return share * c.length * axis + (c.first + share * rise) * direction;
  }
  Vec3 operator()(const surface::Plate& p) const noexcept {
    const auto share = [&](Vec3 edge) { return std::clamp(dot(x, edge) / dot(edge, edge), 0.0, 1.0); };
    return share(p.first) * p.first + share(p.second) * p.second;
  }

 private:
  struct Radial {
    Vec3 direction;
    double distance = 0;
  };
  Radial radial() const noexcept {
    const Vec3 away = tangential(x, axis);
    const double distance = norm(away);
    return {distance > 0 ? away / distance : across(axis), distance};
  }
};

}  // namespace

Surface::Surface(const Wall& wall)
    : point_(wall.point),
      axis_(wall.inward / norm(wall.inward)),
      form_(wall.form),
      motion_(wall.motion),
      wall_spin_(wall.motion.spin),
      flat_(std::holds_alternative<surface::Plane>(wall.form)),
      travels_(wall.motion.velocity != Vec3{} || (wall.motion.amplitude != Vec3{} && wall.motion.frequency > 0)),
      swings_(wall.motion.amplitude != Vec3{} && wall.motion.frequency > 0),
      two_sided_(std::holds_alternative<surface::Cone>(wall.form) ||
                 std::holds_alternative<surface::Plate>(wall.form)) {}

Vec3 Surface::displacement(double time) const noexcept {
  const Vec3 straight = time * motion_.velocity;
  return swings_ ? straight + std::sin(2 * std::numbers::pi * motion_.frequency * time) * motion_.amplitude : straight;
}

Vec3 Surface::velocity(double time) const noexcept {
  if (!swings_) return motion_.velocity;
  const double rate = 2 * std::numbers::pi * motion_.frequency;
  return motion_.velocity + rate * std::cos(rate * time) * motion_.amplitude;
}

double Surface::moved(double from, double to) const noexcept {
  if (!travels_) return 0;
  const Vec3 way = displacement(to) - displacement(from);
  if (flat_) return std::abs(dot(way, axis_));
  return norm(std::holds_alternative<surface::Cylinder>(form_) ? tangential(way, axis_) : way);
}

// Of a cylinder the centre may be outside: the normal points out all the same.
ContactGeometry Surface::meet_curved(Vec3 x, double r) const noexcept {
  const Vec3 nearest = std::visit(Nearest{x, axis_}, form_);
  const Vec3 inward = x - nearest;
  const double distance = norm(inward);
  Vec3 unit = distance > 0 ? inward / distance : -axis_;
  if (const auto* cylinder = std::get_if<surface::Cylinder>(&form_))
    unit = -1 / cylinder->radius * tangential(nearest, axis_);
  return sphere_wall(x, r, nearest, unit);
}

Vec3 slip_gain(const Surface& surface, const SurfaceSlip& s, double time, double time_on) noexcept {
  const auto slip = [&](double later) {
    const Vec3 x = s.position + later * s.velocity;
    const ContactGeometry g = surface.meet(x, s.radius, time + later);
    const Vec3 v = s.velocity - s.wall_velocity - surface.swept(x + g.arm_i * g.normal, time + later);
    return tangential(v, g.normal) + g.arm_i * cross(s.spin, g.normal);
  };
  const ContactGeometry now = surface.meet(s.position, s.radius, time);
  return tangential(slip(time_on) - slip(0), now.normal);
}

}  // namespace ricochet::motion
