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
      : root_(root),
        scene_(scene),
        setup_(scene.setup),
        duration_(root.at("duration").positive()),
        insists_(root.has("insist") && root.at("insist").yes_or_no()) {
    for (double Vec3::*const axis : {&Vec3::x, &Vec3::y, &Vec3::z}) {
      const double period = setup_.periodic.period.*axis;
      for (std::size_t n = images_.size(); period > 0 && n-- > 0;)
        for (const double way : {-period, period}) {
          images_.push_back(images_[n]);
          images_.back().*axis += way;
        }
    }
  }

  std::string remark;

  void at_wall(std::size_t i, std::size_t w) {
    const Sphere& s = setup_.spheres[i];
    const motion::Surface wall(setup_.walls[w]);
    const Vec3 flight = s.velocity - setup_.walls[w].motion.velocity;
    const double fastest = norm(flight);
    if (!(fastest > 0)) return;
    // From place to place: as far as the surface is, nobody can meet it before.
    constexpr int most_places = 100;
    double when = 0;
    for (int k = 0; k < most_places; ++k) {
      const ContactGeometry g = wall.meet(s.position + when * flight, s.radius, 0);
      const double speed = dot(flight, g.normal);
      if (g.overlap > -1e-9 * s.radius) {
        if (speed > 0)
          judge(i, scene_.wall_names[w], speed, depth(law_of(s.material, setup_.walls[w].material), s.mass(), speed),
                s.radius, wall.two_sided() ? 1 : Breakthrough::share);
        return;
      }
      when += wall.flat() ? -g.overlap / std::max(speed, 1e-12 * fastest) : -g.overlap / fastest;
      if (when > duration_) return;
    }
  }

  void at_each_other(std::size_t i, std::size_t j) {
    const Vec3 d = setup_.periodic.shortest(setup_.spheres[j].position - setup_.spheres[i].position);
    for (const Vec3 image : images_) at_image(i, j, d + image);
  }

 private:
  /// Of a sphere and another at d from it.
  void at_image(std::size_t i, std::size_t j, Vec3 d) {
    const Sphere &a = setup_.spheres[i], &b = setup_.spheres[j];
    const Vec3 v = b.velocity - a.velocity;
    const double reach = a.radius + b.radius, rate = -dot(d, v), square = dot(v, v);
    if (!(rate > 0)) return;
    const double miss = dot(d, d) - rate * rate / square;  // square of the least distance
    if (miss > reach * reach) return;
    const double back = std::sqrt(reach * reach - std::max(0.0, miss)), speed = std::sqrt(square);
    if (rate / square - back / speed > duration_) return;
    const double along = speed * back / reach, mass = 1 / (1 / a.mass() + 1 / b.mass());
    judge(j, name(i), along, depth(law_of(a.material, b.material), mass, along), std::min(a.radius, b.radius),
          Breakthrough::share);
  }
  const Interaction& law_of(std::size_t a, std::size_t b) const { return setup_.interactions.at(std::minmax(a, b)); }
  std::size_t given() const { return root_.has("spheres") ? root_.at("spheres").size() : 0; }
  std::string name(std::size_t i) const {
    return i < given() ? fmt::format("/spheres/{}", i) : fmt::format("sphere {}", i + 1);
  }
  void judge(std::size_t i, const std::string& other, double speed, double deep, double radius, double share) {
    if (deep < radius) return;
    const std::string found =
        fmt::format("meets {} at {} m/s and would go {} m into it (v t_col/pi), past a radius of {} m", other,
                    significant(speed, 3), significant(deep, 3), significant(radius, 3));
    if (deep > share * radius && !insists_) {
      const std::string what = fmt::format("{}; it must be slower, or their law stiffer, or \"insist\" true", found);
      if (i < given()) root_.at("spheres").at(i).complain(what);
      root_.complain(fmt::format("{} {}", name(i), what));
    }
    if (remark.empty()) remark = fmt::format("{} {}", name(i), found);
  }

  const Node& root_;
  const Scene& scene_;
  const ClusterSetup& setup_;
  double duration_;
  bool insists_;
  std::vector<Vec3> images_{Vec3{}};  ///< those next to a sphere, with itself
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
