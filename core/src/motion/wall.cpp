#include <ricochet/motion/wall.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace ricochet {

std::vector<Wall> box_walls(Vec3 low, Vec3 high, std::size_t material) {
  if (!(low.x < high.x && low.y < high.y && low.z < high.z))
    throw std::invalid_argument("box: low must be below high in x, y and z");
  std::vector<Wall> walls;
  for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
    walls.push_back({.point = low, .inward = axis, .material = material});
    walls.push_back({.point = high, .inward = -axis, .material = material});
  }
  return walls;
}

namespace {

using support::require;

void require_finite(const char* what, Vec3 v) {
  if (!(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)))
    throw std::invalid_argument(std::string(what) + ": must be three finite numbers");
}

struct CheckForm {
  void operator()(const surface::Plane&) const noexcept {}
  void operator()(const surface::Cylinder& c) const { support::require_positive("radius", c.radius); }
  void operator()(const surface::Cone& c) const {
    support::require_not_negative("length", c.length);
    for (const double radius : {c.first, c.last}) {
      support::require_not_negative("radius", radius);
      require(radius > 0 || c.length == 0, "radius", radius, "> 0 where the surface is no disc");
    }
    require(c.length > 0 || c.first != c.last, "radius", c.last, "other than the first of a ring");
  }
  void operator()(const surface::Plate& p) const {
    for (const Vec3 edge : {p.first, p.second}) {
      require_finite("edge", edge);
      support::require_positive("|edge|", norm(edge));
    }
    const double cosine = dot(p.first, p.second) / (norm(p.first) * norm(p.second));
    require(std::abs(cosine) <= 1e-6, "cosine of the edges", cosine, "0, as of a rectangle");
  }
};

}  // namespace

double narrowest(const Wall& wall) noexcept {
  if (const auto* cylinder = std::get_if<surface::Cylinder>(&wall.form)) return cylinder->radius;
  const auto* cone = std::get_if<surface::Cone>(&wall.form);
  return cone && cone->length > 0 ? std::min(cone->first, cone->last) : std::numeric_limits<double>::infinity();
}

void check(const Wall& wall) {
  require_finite("point", wall.point);
  require_finite("inward", wall.inward);
  support::require_positive("|inward|", norm(wall.inward));
  std::visit(CheckForm{}, wall.form);
  require_finite("velocity", wall.motion.velocity);
  require_finite("amplitude", wall.motion.amplitude);
  support::require_not_negative("frequency", wall.motion.frequency);
  require(std::isfinite(wall.motion.spin), "spin", wall.motion.spin, "finite");
  require(wall.motion.spin == 0 || !std::holds_alternative<surface::Plate>(wall.form), "spin", wall.motion.spin,
          "0 of a plate");
}

}  // namespace ricochet
