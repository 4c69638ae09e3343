#include "scenes.hpp"

#include <catch2/catch.hpp>

using namespace ricochet;
using namespace ricochet::test;

namespace {

ClusterSetup heap() {
  ClusterSetup setup = with_springs(random_clump(5, Linear(2e4, 0.5), Friction(0.4, 0.4, 0, 0)));
  setup.gravity = {0, 0, -9.81};
  setup.walls = {{.point = {0, 0, -0.05}}, {.point = {-0.04, 0, 0}, .inward = {1, 0, 0}}};
  return setup;
}

ClusterOptions options() {
  ClusterOptions o;
  o.step = 1e-5;
  return o;
}

}  // namespace

TEST_CASE("spheres that come and go far away change no bit of the others, and the balance counts them") {
  Cluster alone(heap(), options()), visited(heap(), options());
  Sphere far = heap().spheres[0];
  far.position = {3, 3, 3}, far.velocity = {0, 0, 1};
  alone.advance(1500), visited.advance(700);
  REQUIRE_FALSE(visited.contacts().empty());
  const double total = visited.energy().total();
  Sphere farther = far;
  farther.position.x = 4;
  visited.add(std::vector{far, farther});
  CHECK(visited.energy().total() == Approx(total).epsilon(1e-13));
  CHECK(visited.size() == 14);
  visited.advance(400);
  const double before = visited.energy().total();
  visited.remove(std::vector<std::uint32_t>{12, 13});
  CHECK(visited.energy().total() == Approx(before).epsilon(1e-13));
  visited.advance(400);
  REQUIRE(visited.size() == alone.size());
  for (std::size_t i = 0; i < alone.size(); ++i) {
    CHECK(visited.position(i) == alone.position(i));
    CHECK(visited.spin(i) == alone.spin(i));
  }
  REQUIRE(visited.contacts().size() == alone.contacts().size());
  for (std::size_t k = 0; k < alone.contacts().size(); ++k)
    CHECK(visited.contacts()[k].record == alone.contacts()[k].record);
}

TEST_CASE("who leaves takes its contacts along, and the others move up") {
  Cluster cluster(heap(), options());
  while (cluster.contacts().size() < 4) cluster.step();
  std::vector<Encounter> open;
  for (const ContactState& c : cluster.contacts()) open.push_back(c.record);
  REQUIRE(open.size() > 2);
  cluster.take_finished();
  const std::uint32_t gone = open[1].i;
  const Vec3 next = cluster.position(gone + 1);
  const double total = cluster.energy().total();
  cluster.remove(std::vector{gone});
  CHECK(cluster.position(gone) == next);
  CHECK(cluster.energy().total() == Approx(total).epsilon(1e-12));
  std::size_t ended = 0;
  for (const Encounter& e : open) ended += e.i == gone || e.j == gone;
  const auto finished = cluster.take_finished();
  CHECK(finished.size() == ended);
  CHECK(finished[0].separation == Encounter::never);
  CHECK(cluster.contacts().size() == open.size() - ended);
  CHECK(cluster.advance(500));
  const ClusterState state = cluster.state();
  CHECK(cluster.advance(200));
  Cluster other(heap(), options());
  other.remove(std::vector{gone});
  other.restore(state);
  other.advance(200);
  for (std::size_t i = 0; i < other.size(); ++i) CHECK(other.velocity(i) == cluster.velocity(i));
}

TEST_CASE("only spheres that there are can be removed, only possible ones added") {
  Cluster cluster(heap(), options());
  CHECK_THROWS_AS(cluster.remove(std::vector<std::uint32_t>{12}), std::invalid_argument);
  CHECK_THROWS_AS(cluster.remove(std::vector<std::uint32_t>{2, 2}), std::invalid_argument);
  Sphere s = heap().spheres[0];
  s.material = 1;
  CHECK_THROWS_WITH(cluster.add(std::vector{s}), Catch::Contains("must be of a material that the setup has"));
  s.material = 0, s.radius = -1;
  CHECK_THROWS_WITH(cluster.add(std::vector{s}), Catch::StartsWith("sphere 13 radius = -1"));
  CHECK(cluster.size() == 12);
}

TEST_CASE("what an overlap at the start stores is there from time 0, and comes out as speed") {
  ClusterSetup setup = with_law(Linear(1e4, 0));
  Sphere a{.radius = 0.01, .density = 2000}, b = a;
  b.position = {0.018, 0, 0};
  setup.spheres = {a, b};
  setup.walls = {{.point = {0, 0, -0.009}}};
  Cluster cluster(setup, options());
  const double held = 0.5 * 1e4 * (0.002 * 0.002 + 2 * 0.001 * 0.001);
  CHECK(cluster.contacts().size() == 3);
  CHECK(cluster.energy().total() == Approx(held).epsilon(1e-12));
  CHECK(cluster.contacts()[0].record.begin == 0);
  cluster.advance(3000);
  CHECK(cluster.contacts().empty());
  CHECK(cluster.energy().kinetic == Approx(held).epsilon(1e-4));  // (h ω)²/12 = 2e-5 of it
}

TEST_CASE("a contact with a wall goes on while the spheres before it become more and fewer") {
  ClusterSetup setup = with_springs(with_law(Linear(1e4, 0.5), Friction(0.4, 0.4, 0, 0)));
  setup.gravity = {3, 0, -9.81};
  setup.walls = {{.point = {0, 0, -0.01}}};
  setup.spheres = {{.radius = 0.01, .density = 2000}};
  Cluster alone(setup, options()), visited(setup, options());
  alone.advance(300), visited.advance(100);
  Sphere far = setup.spheres[0];
  far.position = {1, 0, 5};
  visited.add(std::vector{far, far});
  REQUIRE(visited.contacts().size() >= 1);
  CHECK(visited.contacts()[0].record.j == 3);
  visited.remove(std::vector<std::uint32_t>{1, 2});
  REQUIRE(visited.contacts().size() == 1);
  CHECK(visited.contacts()[0].record.j == 1);
  visited.advance(200);
  CHECK(visited.position(0) == alone.position(0));
  CHECK(visited.contacts()[0].elongation == alone.contacts()[0].elongation);
}
