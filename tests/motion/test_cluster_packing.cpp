// Many contacts at once, on springs: what a packing keeps, and how it comes to rest.
#include <catch2/catch.hpp>

#include <ricochet/motion/cluster.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace ricochet;

namespace {

constexpr double radius = 0.003, density = 2500, tcol = 4e-4, step = tcol / 50;

double grain_mass() { return Sphere{.radius = radius, .density = density}.mass(); }

// Restitution 0.5 between two grains of that size.
Interaction grains(const TangentialLaw& tangential) {
  const double m = 0.5 * grain_mass(), loss = std::log(0.5), pi = std::acos(-1.0);
  return {.law = Linear(m * (pi * pi + loss * loss) / (tcol * tcol), -2 * m * loss / tcol),
          .friction = Friction(0.5, 0.5, 0),
          .tangential = tangential};
}

// The same, held against torsion and rolling too.
Interaction held_grains() {
  const Spring turns{2.5e-3, 1e-6};
  Interaction held = grains(LinearTangential(2.5e3, 0.28));
  held.torsion = {Torsion::Limit::separate, turns};
  held.rolling = {0.2, turns};
  return held;
}

LinearTangential springs() { return LinearTangential(2.5e3, 0.28); }

// Layers thrown together a little apart, of radii from 0.8 of the greatest.
ClusterSetup thrown(int across, int layers, const Interaction& interaction) {
  ClusterSetup setup;
  setup.gravity = {0, 0, -9.81};
  setup.interactions.insert({{0, 0}, interaction});
  const double spacing = 2.1 * radius;
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.8, 1);
  for (int k = 0; k < layers; ++k)
    for (int i = 0; i < across; ++i)
      for (int j = 0; j < across; ++j)
        setup.spheres.push_back({share(random) * radius,
                                 density,
                                 {(i + 0.5) * spacing, (j + 0.5) * spacing, (k + 0.5) * spacing},
                                 {share(random) - 0.9, share(random) - 0.9, 0}});
  setup.walls = box_walls({0, 0, 0}, {across * spacing, across * spacing, 1});
  return setup;
}

double fastest(const Cluster& cluster) {
  double speed = 0;
  for (std::size_t i = 0; i < cluster.size(); ++i)
    speed = std::max(speed, norm(cluster.velocity(i)) + radius * norm(cluster.spin(i)));
  return speed;
}

}  // namespace

TEST_CASE("a packing on springs comes to rest: its energy only falls, then it does not creep") {
  const ClusterSetup setup = thrown(3, 4, held_grains());
  Cluster cluster(setup, {.step = step});
  const double start = cluster.energy().mechanical();
  double last = start, rise = 0;
  for (int n = 0; n < 300; ++n) {
    REQUIRE(cluster.advance(250));
    const double now = cluster.energy().mechanical();
    rise = std::max(rise, now - last);
    last = now;
  }
  CHECK(cluster.last_sweeps() == 1);
  // Of the energy that an impact swaps, at most that of a grain, leapfrog is off by (w h)²/24, w = π/t_col.
  const double swapped = std::pow(std::acos(-1.0) * step / tcol, 2) / 24;
  CHECK(rise < swapped * start / static_cast<double>(cluster.size()));
  CHECK(fastest(cluster) < 1e-9 * radius);
  const Vec3 there = cluster.position(17);
  REQUIRE(cluster.advance(5000));
  CHECK(norm(cluster.position(17) - there) < 1e-9 * radius * 5000 * step);
  // Floor and walls bear the weight.
  double weight = 0, borne = 0;
  for (const Sphere& s : setup.spheres) weight += 9.81 * s.mass();
  for (const ContactState& c : cluster.contacts()) {
    if (c.record.j < cluster.size()) continue;
    borne += c.friction.sliding.z / step;
    if (setup.walls[c.record.j - cluster.size()].inward.z > 0) borne += c.normal_impulse / step;
  }
  CHECK(borne == Approx(weight).epsilon(1e-8));
}

TEST_CASE("a cloud of grains on springs keeps its momentum and its angular momentum to rounding") {
  ClusterSetup setup = thrown(4, 4, grains(springs()));
  setup.gravity = {}, setup.walls.clear();
  for (Sphere& s : setup.spheres)
    s.velocity = -20.0 * (s.position - Vec3{0.0126, 0.0126, 0.0126}), s.spin = {50, -20, 10};
  Cluster cluster(setup, {.step = step});
  const Vec3 momentum = cluster.momentum(), angular = cluster.angular_momentum();
  double scale = 0, turning = 0;
  for (const Sphere& s : setup.spheres)
    scale += s.mass() * norm(s.velocity), turning += s.mass() * norm(s.position) * norm(s.velocity);
  std::size_t most = 0;
  for (int n = 0; n < 3000; ++n) cluster.step(), most = std::max(most, cluster.contacts().size());
  CHECK(most > 30);
  CHECK(norm(cluster.momentum() - momentum) < 1e-12 * scale);
  CHECK(norm(cluster.angular_momentum() - angular) < 1e-12 * turning);
}

TEST_CASE("dashpots that a step does not resolve are met by sweeps") {
  Interaction stiff = grains(LinearTangential(2.5e3, 40));
  ClusterSetup setup = thrown(2, 2, stiff);
  Cluster cluster(setup, {.step = step});
  int most = 0;
  for (int n = 0; n < 4000; ++n) cluster.step(), most = std::max(most, cluster.last_sweeps());
  CHECK(most > 1);
  CHECK(fastest(cluster) < 1);
}

TEST_CASE("a contact's dashpots count by the greater of what they brake along the normal and across it") {
  // Shares of its speed, and of its turning too, that a grain on the floor loses in half a step.
  const auto sweeps = [](double along, double across) {
    const double m = grain_mass(), k = m * std::pow(std::acos(-1.0) / tcol, 2), arm = 1 / 0.4;
    ClusterSetup setup;
    setup.interactions.insert({{0, 0},
                               {.law = Linear(k, 2 * along * m / step),
                                .friction = Friction(0.5, 0.5, 0),
                                .tangential = LinearTangential(k, 2 * across * m / step / (1 + arm))}});
    setup.spheres.push_back({radius, density, {0, 0, radius}, {0.01, 0, -0.1}});
    setup.walls = box_walls({-1, -1, 0}, {1, 1, 1});
    Cluster cluster(setup, {.step = step});
    for (int n = 0; n < 3; ++n) cluster.step();
    REQUIRE(cluster.contacts().size() == 1);
    return cluster.last_sweeps();
  };
  CHECK(sweeps(0.24, 0.24) == 1);
  CHECK(sweeps(0.26, 0) > 1);
  CHECK(sweeps(0, 0.26) > 1);
}

TEST_CASE("threads change no bit of a packing") {
  ClusterSetup setup = thrown(6, 5, held_grains());
  setup.gravity = {0, 0, -98.1};  // so that they lie soon
  const auto after = [&](int threads) {
    Cluster cluster(setup, {.step = step, .threads = threads});
    REQUIRE(cluster.advance(2500));
    return cluster.state();
  };
  const ClusterState alone = after(1);
  CHECK(alone.contacts.size() > 200);
  for (const int threads : {2, 3}) {
    const ClusterState shared = after(threads);
    CHECK(shared.half_positions == alone.half_positions);
    CHECK(shared.velocities == alone.velocities);
    CHECK(shared.spins == alone.spins);
    CHECK(shared.lost_normal == alone.lost_normal);
    CHECK(shared.lost_friction == alone.lost_friction);
    REQUIRE(shared.contacts.size() == alone.contacts.size());
    for (std::size_t k = 0; k < alone.contacts.size(); ++k) {
      CHECK(shared.contacts[k].record == alone.contacts[k].record);
      CHECK(shared.contacts[k].elongation == alone.contacts[k].elongation);
    }
  }
  CHECK_THROWS_AS(Cluster(setup, {.step = step, .threads = 0}), std::invalid_argument);
}

namespace {

// Two materials in turn, thrown about so fast that contacts come and go all the time.
ClusterSetup shaken() {
  ClusterSetup setup = thrown(5, 5, grains(springs()));
  setup.interactions.insert({{0, 1}, grains(MindlinTangential(4e4, 0.28))});
  setup.interactions.insert({{1, 1}, grains(LinearTangential(1e3, 0.1))});
  for (std::size_t i = 0; i < setup.spheres.size(); ++i) {
    setup.spheres[i].velocity = 20 * setup.spheres[i].velocity;
    setup.spheres[i].material = i % 2;
  }
  for (Wall& wall : setup.walls) wall.material = 0;
  return setup;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_of(const ClusterState& state) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  for (const ContactState& c : state.contacts) pairs.emplace_back(c.record.i, c.record.j);
  return pairs;
}

}  // namespace

TEST_CASE("contacts that come and go stay in order, each with its law, as if the cluster had just been restored") {
  const ClusterOptions options{.step = step};
  Cluster going(shaken(), options), restored(shaken(), options);
  std::size_t came = 0, went = 0, both = 0;
  auto before = pairs_of(going.state());
  for (int n = 0; n < 1500; ++n) {
    restored.restore(going.state());
    going.step(), restored.step();
    const ClusterState one = going.state(), other = restored.state();
    REQUIRE(one.half_positions == other.half_positions);
    REQUIRE(one.spins == other.spins);
    REQUIRE(one.lost_normal == other.lost_normal);
    REQUIRE(one.lost_friction == other.lost_friction);
    const auto now = pairs_of(one);
    REQUIRE(now == pairs_of(other));
    REQUIRE(std::is_sorted(now.begin(), now.end()));
    std::vector<std::pair<std::uint32_t, std::uint32_t>> born, gone;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(born));
    std::set_difference(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(gone));
    came += born.size(), went += gone.size(), both += !born.empty() && !gone.empty() ? 1 : 0;
    before = now;
  }
  CHECK(came > 300);
  CHECK(went > 300);
  CHECK(both > 20);
}
