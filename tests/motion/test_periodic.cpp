#include "scenes.hpp"

#include <ricochet/motion/periodic.hpp>

#include <catch2/catch.hpp>

using namespace ricochet;
using namespace ricochet::test;

TEST_CASE("pairs across borders are all that a look at every pair finds") {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> place(-2, 3), size(0.03, 0.06);
  std::vector<Vec3> positions;
  std::vector<double> radii;
  for (int k = 0; k < 600; ++k) {
    positions.push_back({place(random), place(random), place(random)});
    radii.push_back(size(random));
  }
  const double skin = 0.02;
  for (const Vec3 period : {Vec3{0.7, 0, 0}, Vec3{0, 0.4, 1}, Vec3{0.5, 0.6, 0.7}, Vec3{}}) {
    const Periodic space{period};
    std::vector<NearPair> expected;
    for (std::uint32_t i = 0; i < positions.size(); ++i)
      for (std::uint32_t j = i + 1; j < positions.size(); ++j)
        if (norm(space.shortest(positions[j] - positions[i])) <= radii[i] + radii[j] + skin) expected.push_back({i, j});
    CHECK(expected.size() > 40 * (period.x > 0));
    CHECK(near_pairs(positions, radii, skin, space) == expected);
  }
  CHECK_THROWS_WITH(near_pairs(positions, radii, skin, Periodic{{0.2, 0, 0}}),
                    Catch::Contains("period = 0.2: must be 0 or more than 4 of the greatest radius"));
  CHECK(near_pairs({}, {}, skin, Periodic{{1, 1, 1}}).empty());
}

TEST_CASE("a pair meets across a border as it does inside") {
  // Numbers of few bits: where the border lies rounds nothing but the places themselves.
  const auto meet = [](Vec3 at, Vec3 back) {
    ClusterSetup setup = with_springs(with_law(Linear(4000, 0.5), Friction(0.4, 0.4, 0, 0)));
    setup.periodic.period = {1, 1, 1};
    Sphere a{.radius = 0.0625, .density = 1000}, b = a;
    a.position = at - Vec3{0.0703125, 0.03125, 0.015625}, a.velocity = {1, 0.25, 0}, a.spin = {8, 16, -4};
    b.position = at + Vec3{0.0703125, 0.03125, 0.015625} - back, b.velocity = {-1, -0.25, 0.5};
    setup.spheres = {a, b};
    ClusterOptions options;
    options.step = 1.0 / 65536;
    Cluster cluster(setup, options);
    cluster.advance(4096);
    return cluster;
  };
  Cluster inside = meet({0.5, 0.5, 0.5}, {}), across = meet({1, 1, 0.5}, {1, 1, 0});
  REQUIRE(inside.take_finished().size() == 1);
  REQUIRE(across.take_finished().size() == 1);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(norm(inside.velocity(i) - across.velocity(i)) < 1e-12);
    CHECK(norm(inside.spin(i) - across.spin(i)) < 1e-11);
  }
  CHECK(norm(inside.momentum() - across.momentum()) < 1e-14);
  CHECK(across.energy().lost_friction == Approx(inside.energy().lost_friction).epsilon(1e-11));
}

TEST_CASE("a gas in a periodic box keeps its momentum to rounding and its energy with order 2") {
  const auto gas = [](double step) {
    ClusterSetup setup = with_springs(random_clump(3, Linear(2e4, 0), Friction(0.4, 0.4, 0, 0), 27));
    setup.periodic.period = {0.08, 0.08, 0.08};
    setup.spheres.resize(27);
    ClusterOptions options;
    options.step = step;
    Cluster cluster(setup, options);
    const Vec3 before = cluster.momentum();
    double scale = 0;
    for (const Sphere& s : setup.spheres) scale += s.mass() * norm(s.velocity);
    cluster.advance(std::uint64_t(std::llround(0.02 / step)));
    CHECK(norm(cluster.momentum() - before) < 1e-12 * scale);
    return cluster;
  };
  const auto at = [&](double h) { return gas(h).position(0); };
  const Vec3 a = at(4e-6), b = at(2e-6), c = at(1e-6);
  const double order = std::log2(norm(a - b) / norm(b - c));
  CHECK(order > 1.6);
  CHECK(order < 2.4);
}

TEST_CASE("finite walls, and planes across a periodic axis, are refused") {
  ClusterSetup setup = with_law(Linear(1e4, 0));
  setup.spheres = {{.radius = 0.01, .density = 1000}};
  setup.periodic.period = {0.1, 0, 0};
  const auto complaint = [&](const Wall& wall) {
    setup.walls = {wall};
    try {
      check(setup);
    } catch (const std::invalid_argument& wrong) {
      return std::string(wrong.what());
    }
    return std::string();
  };
  CHECK(complaint({}).empty());
  CHECK(complaint({.inward = {1, 0, 0}, .form = surface::Cylinder{1}}).empty());
  for (const Wall& wall : {Wall{.inward = {1, 0, 1}}, Wall{.form = surface::Cylinder{1}},
                           Wall{.inward = {1, 0, 0}, .form = surface::Cone{.length = 1, .first = 1, .last = 1}}})
    CHECK(complaint(wall).find("wall 1: must be the same all along a periodic axis") == 0);
  setup.walls.clear();
  setup.periodic.period = {0.03, 0, 0};
  CHECK_THROWS_WITH(check(setup), Catch::StartsWith("period = 0.03: must be 0 or more than 4"));
}
