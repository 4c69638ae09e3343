#include "passage.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::simulate {
namespace {

using console::Node;
using console::significant;

constexpr std::size_t most_spheres = 5000;  // of which every pair is looked at

/// How deep bodies would go that meet with a speed under a law.
double depth(const Interaction& interaction, double mass, double speed) {
  return speed * interaction.law.resolved_time(mass, speed) / std::numbers::pi;
}

class Flights {
 public:
  Flights(const Node& root, const Scene& scene)
      : spheres_(root.at("spheres")), setup_(scene.setup), duration_(root.at("duration").positive()) {}

  std::string remark;

  void at_wall(std::size_t i, std::size_t w) {
    const Sphere& s = setup_.spheres[i];
    const Wall& wall = setup_.walls[w];
    const Vec3 normal = wall.inward / norm(wall.inward);
    const double speed = -dot(s.velocity, normal), gap = dot(s.position - wall.point, normal) - s.radius;
    if (!(speed > 0) || gap > speed * duration_) return;
    judge(i, fmt::format("wall{}", w + 1), speed, depth(law_of(s.material, wall.material), s.mass(), speed), s.radius);
  }

  void at_each_other(std::size_t i, std::size_t j) {
    const Sphere &a = setup_.spheres[i], &b = setup_.spheres[j];
    const Vec3 d = b.position - a.position, v = b.velocity - a.velocity;
    const double reach = a.radius + b.radius, rate = -dot(d, v), square = dot(v, v);
    if (!(rate > 0)) return;
    const double miss = dot(d, d) - rate * rate / square;  // square of the least distance
    if (miss > reach * reach) return;
    const double back = std::sqrt(reach * reach - std::max(0.0, miss)), speed = std::sqrt(square);
    if (rate / square - back / speed > duration_) return;
    const double along = speed * back / reach, mass = 1 / (1 / a.mass() + 1 / b.mass());
    judge(j, fmt::format("/spheres/{}", i), along, depth(law_of(a.material, b.material), mass, along),
          std::min(a.radius, b.radius));
  }

 private:
  const Interaction& law_of(std::size_t a, std::size_t b) const { return setup_.interactions.at(std::minmax(a, b)); }
  void judge(std::size_t i, const std::string& other, double speed, double deep, double radius) {
    if (deep < radius) return;
    const std::string found =
        fmt::format("meets {} at {} m/s and would go {} m into it (v t_col/pi), past a radius of {} m", other,
                    significant(speed, 3), significant(deep, 3), significant(radius, 3));
    if (deep > Breakthrough::share * radius)
      spheres_.at(i).complain(fmt::format("{}; it must be slower, or their law stiffer", found));
    if (remark.empty()) remark = fmt::format("/spheres/{} {}", i, found);
  }

  Node spheres_;
  const ClusterSetup& setup_;
  double duration_;
};

}  // namespace

std::string look_ahead(const Node& root, const Scene& scene) {
  Flights flights(root, scene);
  const std::size_t n = scene.setup.spheres.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t w = 0; w < scene.setup.walls.size(); ++w) flights.at_wall(i, w);
  for (std::size_t i = 0; i < n && n <= most_spheres; ++i)
    for (std::size_t j = i + 1; j < n; ++j) flights.at_each_other(i, j);
  return flights.remark;
}

}  // namespace ricochet::simulate
