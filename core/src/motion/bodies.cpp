#include <ricochet/motion/bodies.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>

namespace ricochet {

double Sphere::mass() const noexcept { return 4.0 / 3 * std::numbers::pi * radius * radius * radius * density; }
double Sphere::inertia() const noexcept { return 0.4 * mass() * radius * radius; }

namespace {

void require_finite(const std::string& what, Vec3 v) {
  if (!(std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z)))
    throw std::invalid_argument(what + ": must be three finite numbers");
}

// Greatest approach speed of two bodies, gravity having acted over the greatest diameter.
double approach_speed(const ClusterSetup& setup) {
  double fastest = 0, second = 0, radius = 0;
  const auto flies = [&](double v) {
    if (v > fastest)
      second = fastest, fastest = v;
    else
      second = std::max(second, v);
  };
  for (const Sphere& s : setup.spheres) flies(norm(s.velocity)), radius = std::max(radius, s.radius);
  for (const Wall& w : setup.walls)
    flies(norm(w.motion.velocity) + 2 * std::numbers::pi * w.motion.frequency * norm(w.motion.amplitude));
  return fastest + second + std::sqrt(4 * norm(setup.gravity) * radius);
}

// The lightest body of each material: with a given law the collision of the lightest pair is the shortest.
struct Lightest {
  std::optional<std::size_t> first, second;  // spheres
  std::optional<std::size_t> wall;
};

std::map<std::size_t, Lightest> lightest_of(const ClusterSetup& setup) {
  std::map<std::size_t, Lightest> all;
  const auto& s = setup.spheres;
  for (std::size_t i = 0; i < s.size(); ++i) {
    Lightest& l = all[s[i].material];
    if (!l.first || s[i].mass() < s[*l.first].mass())
      l.second = l.first, l.first = i;
    else if (!l.second || s[i].mass() < s[*l.second].mass())
      l.second = i;
  }
  for (std::size_t w = 0; w < setup.walls.size(); ++w) all[setup.walls[w].material].wall = w;
  return all;
}

struct Resolved {
  double time;
  bool tangential;
};

// The shorter of what the normal law and what a tangential spring take.
Resolved resolved_time(const Interaction& interaction, double mass, double speed) {
  const double normal = interaction.law.resolved_time(mass, speed);
  if (!std::isfinite(normal)) return {normal, false};
  const double stiffness = spring(interaction.tangential, speed * normal / std::numbers::pi).stiffness;
  if (!(stiffness > 0)) return {normal, false};
  const double across = std::numbers::pi * std::sqrt(2.0 / 7 * mass / stiffness);
  return {std::min(normal, across), across < normal};
}

void check_room(const ClusterSetup& setup) {
  double radius = 0;
  for (const auto* const spheres : {&setup.spheres, &setup.later})
    for (const Sphere& s : *spheres) radius = std::max(radius, s.radius);
  for (const double period : {setup.periodic.period.x, setup.periodic.period.y, setup.periodic.period.z})
    support::require(period == 0 || (period > 4 * radius && std::isfinite(period)), "period", period,
                     "0 or more than 4 of the greatest radius");
  for (const Wall& wall : setup.walls)
    support::require(radius < narrowest(wall), "radius of a cylinder or cone", narrowest(wall),
                     "greater than that of every sphere");
}

}  // namespace

bool same_along(const Wall& wall, const Periodic& periodic) noexcept {
  const Vec3 period = periodic.period;
  const Vec3 axis = wall.inward / norm(wall.inward);
  const auto same = [&](Vec3 along) {
    if (std::holds_alternative<surface::Plane>(wall.form)) return std::abs(dot(axis, along)) <= 1e-12;
    return std::holds_alternative<surface::Cylinder>(wall.form) && norm(tangential(along, axis)) <= 1e-12;
  };
  return (period.x == 0 || same({1, 0, 0})) && (period.y == 0 || same({0, 1, 0})) && (period.z == 0 || same({0, 0, 1}));
}

StiffestContact stiffest_contact(const ClusterSetup& setup) {
  const double speed = approach_speed(setup);
  const auto lightest = lightest_of(setup);
  StiffestContact stiffest;
  const auto meet = [&](const Interaction& interaction, std::size_t i, std::size_t j, double mass) {
    const auto [t, tangential] = resolved_time(interaction, mass, speed);
    if (std::isfinite(t) && (stiffest.tcol == 0 || t < stiffest.tcol)) stiffest = {i, j, t, tangential};
  };
  const auto& s = setup.spheres;
  for (const auto& [pair, interaction] : setup.interactions) {
    const auto a = lightest.find(pair.first), b = lightest.find(pair.second);
    if (a == lightest.end() || b == lightest.end()) continue;
    const auto first = a->second.first, other = a == b ? a->second.second : b->second.first;
    if (first && other) {
      const double mi = s[*first].mass(), mj = s[*other].mass();
      meet(interaction, *first, *other, mi * mj / (mi + mj));
    }
    for (const auto& [sphere, wall] :
         {std::pair(a->second.first, b->second.wall), std::pair(b->second.first, a->second.wall)})
      if (sphere && wall) meet(interaction, *sphere, s.size() + *wall, s[*sphere].mass());
  }
  return stiffest;
}

void check(const Sphere& s, std::size_t number) {
  const std::string who = "sphere " + std::to_string(number);
  support::require_positive((who + " radius").c_str(), s.radius);
  support::require_positive((who + " density").c_str(), s.density);
  require_finite(who + " position", s.position);
  require_finite(who + " velocity", s.velocity);
  require_finite(who + " spin", s.spin);
}

void check(const ClusterSetup& setup) {
  for (std::size_t i = 0; i < setup.spheres.size(); ++i) check(setup.spheres[i], i + 1);
  for (std::size_t w = 0; w < setup.walls.size(); ++w) {
    const std::string who = "wall " + std::to_string(w + 1);
    try {
      check(setup.walls[w]);
    } catch (const std::invalid_argument& wrong) {
      throw std::invalid_argument(who + " " + wrong.what());
    }
    if (!same_along(setup.walls[w], setup.periodic))
      throw std::invalid_argument(who +
                                  ": must be the same all along a periodic axis, so a plane or cylinder along it");
  }
  require_finite("gravity", setup.gravity);
  check_room(setup);
  const auto meets = [&](std::size_t a, std::size_t b) {
    const auto found = setup.interactions.find(std::minmax(a, b));
    if (found == setup.interactions.end())
      throw std::invalid_argument("materials " + std::to_string(a) + " and " + std::to_string(b) +
                                  " can meet: must have an interaction");
    found->second.law.require_motion();
    const Interaction& i = found->second;
    check(TangentialContact{i.tangential, i.friction, i.torsion, i.rolling});
    const double breakage = i.breakage_energy;
    support::require(breakage >= 0, "breakage_energy", breakage, ">= 0");
  };
  ClusterSetup all;
  all.spheres = setup.spheres, all.walls = setup.walls;
  all.spheres.insert(all.spheres.end(), setup.later.begin(), setup.later.end());
  const auto lightest = lightest_of(all);
  for (const auto& [a, of_a] : lightest)
    for (const auto& [b, of_b] : lightest) {
      if (b < a || !(of_a.first || of_b.first)) continue;
      const bool spheres = a == b ? of_a.second.has_value() : of_a.first && of_b.first;
      if (spheres || (of_a.first && of_b.wall) || (of_b.first && of_a.wall)) meets(a, b);
    }
}

}  // namespace ricochet
