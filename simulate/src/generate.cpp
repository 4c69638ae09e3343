#include "generate.hpp"

#include "crowd.hpp"
#include <simulate/region.hpp>
#include "sizes.hpp"

#include <console/bound.hpp>
#include <console/number.hpp>
#include <console/progress.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace ricochet::simulate {
namespace {

using console::Node;
using console::significant;

constexpr std::uint64_t most_spheres = 10'000'000;
constexpr int most_tries = 20'000;    // for the place of one sphere
constexpr double densest_pour = 0.4;  // random places without overlap fill 0.38 of a large region at most

// What lattices and pours say alike. Radii are drawn before places are sought.
struct Order {
  Node place;
  std::vector<Sphere> spheres;
  std::size_t material;
  std::uint64_t seed;
  double largest = 0;
};

Order read_order(const Node& entry, const Materials& materials) {
  const Material& material = material_of(entry.at("material"), materials);
  Order order{entry, {}, material.index, 1};
  if (entry.has("seed")) order.seed = entry.at("seed").integer(0, std::numeric_limits<std::int64_t>::max());
  Sphere s;
  s.density = density_of(entry, material);
  s.material = material.index;
  if (entry.has("velocity")) s.velocity = entry.at("velocity").vector();
  if (entry.has("spin")) s.spin = entry.at("spin").vector();
  const Sizes sizes(entry.at("radius"));
  Random random(order.seed, 0);
  order.spheres.assign(entry.at("number").integer(1, most_spheres), s);
  for (Sphere& sphere : order.spheres)
    sphere.radius = sizes.draw(random), order.largest = std::max(order.largest, sphere.radius);
  return order;
}

double solid(const std::vector<Sphere>& spheres) {
  double volume = 0;
  for (const Sphere& s : spheres) volume += 4.0 / 3 * std::numbers::pi * s.radius * s.radius * s.radius;
  return volume;
}

// Those that find room at random, the greatest first; numbers stay in the order in which radii were drawn.
void put_at_random(Order& order, const PourRegion& region, Crowd& crowd) {
  const double share = solid(order.spheres) / region.volume();
  if (share > densest_pour)
    order.place.at("number").reject(
        fmt::format("less: the spheres take {} of the region, and random places hold {} at most", significant(share, 3),
                    densest_pour));
  std::vector<std::size_t> by_size(order.spheres.size());
  std::iota(by_size.begin(), by_size.end(), std::size_t(0));
  std::stable_sort(by_size.begin(), by_size.end(),
                   [&](auto a, auto b) { return order.spheres[a].radius > order.spheres[b].radius; });
  Random random(order.seed, 1);
  console::Progress progress("place spheres", by_size.size());
  for (std::size_t placed = 0; placed < by_size.size(); ++placed, progress.advance()) {
    Sphere& s = order.spheres[by_size[placed]];
    bool found = false;
    for (int tries = 0; tries < most_tries && !found; ++tries) {
      s.position = region.somewhere(s.radius, random);
      found = crowd.room_for(s.position, s.radius);
    }
    if (!found)
      order.place.at("number").reject(
          fmt::format("less: {} found room, a sphere of {} m none at {} places; they would take {} of the region",
                      placed, significant(s.radius, 3), most_tries, significant(share, 3)));
    crowd.add(s.position, s.radius);
  }
}

// Sites of a simple cubic lattice, x first, then y, then z; each sphere somewhere about its site, as far as "jitter"
// says of what its cell leaves.
void put_on_lattice(Order& order, const PourRegion& region, Crowd& crowd) {
  const Node& entry = order.place;
  const double closest = 2 * order.largest;
  const double spacing = entry.has("spacing") ? entry.at("spacing").positive() : closest;
  if (spacing < closest)
    entry.at("spacing").reject(
        fmt::format("at least {} m, twice the greatest radius", console::bound_text(console::Bound::lower, closest)));
  const double jitter = entry.has("jitter") ? entry.at("jitter").not_negative() : 0;
  if (jitter > 1) entry.at("jitter").reject("in [0, 1]");
  const Vec3 size = region.high() - region.low();
  const auto sites = [&](double length) { return static_cast<std::uint64_t>(length / spacing * (1 + touching)); };
  const std::array<std::uint64_t, 3> n{sites(size.x), sites(size.y), sites(size.z)};
  Random random(order.seed, 1);
  console::Progress progress("place spheres", order.spheres.size());
  std::size_t placed = 0;
  for (std::uint64_t k = 0; k < n[0] * n[1] * n[2] && placed < order.spheres.size(); ++k) {
    Sphere& s = order.spheres[placed];
    const std::uint64_t row = k / n[0], layer = row / n[1];
    const Vec3 cell{double(k % n[0]), double(row % n[1]), double(layer)};
    const double free = jitter * (0.5 * spacing - s.radius);
    const Vec3 shift{random.between(-free, free), random.between(-free, free), random.between(-free, free)};
    s.position = region.low() + spacing * (cell + Vec3{0.5, 0.5, 0.5}) + shift;
    if (!region.holds(s.position, s.radius) || !crowd.room_for(s.position, s.radius)) continue;
    crowd.add(s.position, s.radius);
    ++placed, progress.advance();
  }
  if (placed < order.spheres.size())
    entry.at("number").reject(fmt::format("at most {}: as many of the {} x {} x {} sites, {} m apart, are free", placed,
                                          n[0], n[1], n[2], significant(spacing, 4)));
}

PourRegion region_for(const Order& order, const Scene& scene) {
  const Node place = order.place.at("region");
  PourRegion region(place, scene.setup.periodic);
  if (!region.fits(order.largest))
    place.complain(
        fmt::format("has no room for the sphere of radius {} m; it must be larger", significant(order.largest, 3)));
  return region;
}

Crowd crowd_of(const Scene& scene, double largest) {
  for (const Sphere& s : scene.setup.spheres) largest = std::max(largest, s.radius);
  Crowd crowd(largest, scene.setup.periodic, scene.setup.walls, 0);
  for (const Sphere& s : scene.setup.spheres) crowd.add(s.position, s.radius);
  return crowd;
}

void pour_over_time(const Node& entry, Order& order, Scene& scene) {
  const PourRegion region = region_for(order, scene);
  const double begin = entry.has("begin") ? entry.at("begin").not_negative() : 0;
  scene.pours.push_back(
      {region, scene.setup.later.size(), order.spheres.size(), entry.at("rate").positive(), begin, order.seed});
  scene.setup.later.insert(scene.setup.later.end(), order.spheres.begin(), order.spheres.end());
}

}  // namespace

void generate(const Node& root, const Materials& materials, Scene& scene) {
  const auto orders_of = [&](const char* key, auto&& place) {
    for (std::size_t k = 0; root.has(key) && k < root.at(key).size(); ++k) place(root.at(key).at(k));
  };
  const auto settle = [&](Order& order, auto&& put) {
    const PourRegion region = region_for(order, scene);
    Crowd crowd = crowd_of(scene, order.largest);
    put(order, region, crowd);
    scene.setup.spheres.insert(scene.setup.spheres.end(), order.spheres.begin(), order.spheres.end());
  };
  orders_of("lattice", [&](const Node& entry) {
    entry.allow({"number", "radius", "material", "density", "region", "seed", "spacing", "jitter", "velocity", "spin"});
    Order order = read_order(entry, materials);
    settle(order, put_on_lattice);
  });
  orders_of("pour", [&](const Node& entry) {
    entry.allow({"number", "radius", "material", "density", "region", "seed", "velocity", "spin", "rate", "begin"});
    Order order = read_order(entry, materials);
    if (entry.has("rate")) return pour_over_time(entry, order, scene);
    if (entry.has("begin")) entry.at("begin").complain("only of a pour with a \"rate\"; one of them must go");
    settle(order, put_at_random);
  });
}

}  // namespace ricochet::simulate
