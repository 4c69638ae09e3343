#include <catch2/catch.hpp>
#include <ricochet/motion/linked_cells.hpp>

#include <algorithm>
#include <cmath>
#include <random>

using namespace ricochet;

namespace {

struct Spheres {
  std::vector<Vec3> positions;
  std::vector<double> radii;
};

Spheres random_spheres(std::mt19937_64& random, std::size_t count, double extent) {
  std::uniform_real_distribution<double> place(-extent, extent), size(0.02, 0.2);
  Spheres s;
  for (std::size_t k = 0; k < count; ++k) {
    s.positions.push_back({place(random), place(random), place(random)});
    s.radii.push_back(size(random));
  }
  return s;
}

std::vector<NearPair> all_pairs(const Spheres& s, double skin) {
  std::vector<NearPair> pairs;
  for (std::uint32_t i = 0; i < s.radii.size(); ++i)
    for (std::uint32_t j = i + 1; j < s.radii.size(); ++j)
      if (norm(s.positions[j] - s.positions[i]) <= s.radii[i] + s.radii[j] + skin) pairs.push_back({i, j});
  return pairs;
}

}  // namespace

TEST_CASE("linked cells find the pairs that comparing all finds, on thousands of random scenes") {
  std::mt19937_64 random(1);
  std::uniform_int_distribution<std::size_t> counts(0, 60);
  std::uniform_real_distribution<double> extents(0.05, 3), skins(0, 0.1);
  std::size_t found = 0;
  for (int scene = 0; scene < 5000; ++scene) {
    const Spheres s = random_spheres(random, counts(random), extents(random));
    const double skin = scene % 5 == 0 ? 0.0 : skins(random);
    const auto ours = near_pairs(s.positions, s.radii, skin);
    REQUIRE(ours == all_pairs(s, skin));
    found += ours.size();
  }
  CHECK(found > 100'000);
}

TEST_CASE("linked cells find the pairs of grains beside boulders") {
  std::mt19937_64 random(3);
  for (const double smallest : {0.25, 0.05, 1e-3}) {
    std::uniform_real_distribution<double> place(-0.5, 0.5), logarithm(std::log(smallest), 0);
    std::size_t found = 0;
    for (int scene = 0; scene < 200; ++scene) {
      Spheres s;
      for (int k = 0; k < 80; ++k) {
        s.positions.push_back({place(random), place(random), place(random)});
        s.radii.push_back(0.2 * std::exp(logarithm(random)));
      }
      const double skin = scene % 2 == 0 ? 0.0 : 0.2 * smallest / 3;
      const auto ours = near_pairs(s.positions, s.radii, skin);
      REQUIRE(ours == all_pairs(s, skin));
      found += ours.size();
    }
    CHECK(found > 1000);
  }
  // Of sizes whose ratio is no double.
  const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}};
  CHECK(near_pairs(positions, std::vector<double>{1e-320, 1, 1e-310}, 0) == std::vector<NearPair>{{0, 1}, {1, 2}});
}

TEST_CASE("spheres may fly anywhere") {
  const std::vector<double> radii{1, 1, 1, 1, 1};
  const std::vector<Vec3> positions{{0, 0, 0}, {1e30, 0, 0}, {1e30, 0.5, 0}, {-1e18, 1e18, 3}, {1.5, 0, 0}};
  CHECK(near_pairs(positions, radii, 0.1) == std::vector<NearPair>{{0, 4}, {1, 2}});
}

TEST_CASE("the neighbour list never misses an overlap while spheres move, and is rarely rebuilt") {
  std::mt19937_64 random(2);
  std::normal_distribution<double> kick(0, 0.004);
  for (int scene = 0; scene < 40; ++scene) {
    Spheres s = random_spheres(random, 50, 0.6);
    NeighbourList list(s.radii, 0.05);
    int rebuilt = 0;
    for (int step = 0; step < 100; ++step) {
      for (Vec3& p : s.positions) p += Vec3{kick(random), kick(random), kick(random)};
      rebuilt += list.update(s.positions);
      const auto listed = list.pairs();
      for (const NearPair& pair : all_pairs(s, 0)) REQUIRE(std::binary_search(listed.begin(), listed.end(), pair));
    }
    CHECK(rebuilt < 60);
  }
}

TEST_CASE("the neighbour list says which spheres have moved by more than half its skin, sphere by sphere") {
  const std::vector<double> radii{1, 1, 1, 1};
  std::vector<Vec3> positions{{0, 0, 0}, {2.05, 0, 0}, {4.2, 0, 0}, {9, 0, 0}};
  NeighbourList list(radii, 0.2);
  CHECK_FALSE(list.lists(positions, 0, 4));  // not made yet
  REQUIRE(list.update(positions));
  CHECK(list.lists(positions, 0, 4));
  positions[2] += Vec3{0.06, 0.06, 0.06};  // by 0.104
  positions[3] += Vec3{0.099, 0, 0};
  CHECK(list.lists(positions, 0, 2));
  CHECK_FALSE(list.lists(positions, 2, 3));
  CHECK(list.lists(positions, 3, 4));
  CHECK_FALSE(list.lists(positions, 0, 4));
  CHECK(list.update(positions));
  CHECK(list.lists(positions, 2, 3));
  CHECK_FALSE(list.lists(std::vector<Vec3>(5), 0, 4));  // of others
}

TEST_CASE("near_pairs rejects what is no sphere") {
  const std::vector<Vec3> one{{0, 0, 0}};
  CHECK_THROWS_WITH(near_pairs(one, std::vector<double>{-1}, 0), "radius = -1: must be finite and > 0");
  CHECK_THROWS_WITH(near_pairs(one, std::vector<double>{1}, -0.5), "skin = -0.5: must be finite and >= 0");
  CHECK_THROWS_AS(near_pairs(one, std::vector<double>{}, 0), std::invalid_argument);
}
