#include <catch2/catch.hpp>

#include "scenes.hpp"

#include <algorithm>

using namespace ricochet;
using namespace ricochet::test;

namespace {

// Friction without and with springs.
ClusterSetup compliant_or_not(const ClusterSetup& setup) {
  const int kind = GENERATE(0, 1, 2);
  CAPTURE(kind);
  return kind == 0 ? setup : kind == 1 ? with_springs(setup) : with_springs(setup, MindlinTangential(4e5, 0.3));
}

constexpr double step = 2e-6;
constexpr int steps = 4000;

const Friction rough(0.5, 0.3, 2.0, 1.0);

// Rows of a rotation by about 1 rad around an oblique axis; exactly orthogonal to rounding.
Vec3 rotate(Vec3 v) {
  const Vec3 axis = Vec3{1, 2, -3} / std::sqrt(14.0);
  const double c = std::cos(1.1), s = std::sin(1.1);
  return c * v + s * cross(axis, v) + (1 - c) * dot(axis, v) * axis;
}

Cluster run(const ClusterSetup& setup) {
  Cluster cluster(setup, {.step = step, .solver_tolerance = 1e-14});
  REQUIRE(cluster.advance(steps));
  return cluster;
}

double scale(const ClusterSetup& setup) {
  double speed = 0;
  for (const Sphere& s : setup.spheres) speed = std::max(speed, norm(s.velocity));
  return speed;
}

// Multiparticle collisions amplify rounding: a tolerance of 1e-9 leaves 10⁶ for that.
void check_same(const Cluster& a, const Cluster& b, double speed, auto&& map_vector, auto&& map_spin,
                auto&& map_index) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    CHECK(norm(map_vector(a.velocity(i)) - b.velocity(map_index(i))) < 1e-9 * speed);
    CHECK(norm(map_spin(a.spin(i)) - b.spin(map_index(i))) < 1e-9 * 100);
  }
}

const auto same_vector = [](Vec3 v) { return v; };
const auto same_index = [](std::size_t i) { return i; };

// The sums of the sizes of what adds up to the momentum and the angular momentum: rounding is relative to these.
struct MomentumScales {
  double momentum = 0, angular = 0;
};
MomentumScales momentum_scales(const ClusterSetup& setup) {
  MomentumScales sum;
  for (const Sphere& s : setup.spheres) {
    sum.momentum += s.mass() * norm(s.velocity);
    sum.angular += s.mass() * norm(s.position) * norm(s.velocity) + s.inertia() * norm(s.spin);
  }
  return sum;
}

}  // namespace

TEST_CASE("a free cluster with friction conserves momentum and angular momentum and closes its energy balance") {
  const AnyLaw law = GENERATE(AnyLaw(Linear(20000, 0.6)), AnyLaw(KuwabaraKono(2e6, 40)), AnyLaw(Tsuji(2e6, 4)),
                              AnyLaw(Hysteretic(15000, 25000)), AnyLaw(Fractional(20000, 1, 0.3)));
  CAPTURE(std::string(name(law)));
  const ClusterSetup setup = random_clump(7, law, rough);
  const auto [momentum_scale, angular_scale] = momentum_scales(setup);
  double drift[2] = {}, growth[2] = {};
  for (int k = 0; k < 2; ++k) {
    Cluster cluster(setup, {.step = step / (1 << k)});
    const Vec3 p = cluster.momentum(), l = cluster.angular_momentum();
    const double energy = cluster.energy().total();
    double least = cluster.energy().mechanical(), friction = 0;
    std::size_t touched = 0, most = 0;
    for (int n = 0; n < steps << k; ++n) {
      cluster.step();
      const ClusterEnergy e = cluster.energy();
      drift[k] = std::max(drift[k], std::abs(e.total() / energy - 1));
      growth[k] = std::max(growth[k], (e.mechanical() - least) / energy);
      least = std::min(least, e.mechanical());
      REQUIRE(e.lost_friction >= friction - 1e-6 * energy);
      friction = e.lost_friction;
      most = std::max(most, cluster.contacts().size());
      touched += cluster.take_finished().size();
    }
    CHECK(norm(cluster.momentum() - p) < 1e-12 * momentum_scale);
    CHECK(norm(cluster.angular_momentum() - l) < 1e-12 * angular_scale);
    CHECK(touched + cluster.contacts().size() >= 10);
    CHECK(most >= 5);
    CHECK(cluster.energy().lost_friction > 1e-3 * energy);
    CHECK(cluster.energy().mechanical() < energy);
  }
  CAPTURE(drift[0], drift[1], growth[0], growth[1]);
  // Order 2 asks for 1/4; the phases of the many events scatter it. The hysteretic law's burning starts at once where
  // reloading passes the old greatest overlap, which the ledger resolves to one step only.
  if (!std::holds_alternative<Hysteretic>(law)) CHECK(drift[1] < 0.4 * drift[0]);
  CHECK(drift[1] < 2e-5);
  CHECK(growth[1] < 1e-7);
}

TEST_CASE("springs in the tangent plane conserve what friction does, and never make energy") {
  const TangentialLaw law = GENERATE(TangentialLaw(LinearTangential(15000)), TangentialLaw(LinearTangential(15000, 1)),
                                     TangentialLaw(MindlinTangential(4e5)));
  CAPTURE(std::string(name(law)));
  const ClusterSetup setup = with_springs(random_clump(7, Linear(20000, 0.6), rough), law);
  const auto [momentum_scale, angular_scale] = momentum_scales(setup);
  double drift[2] = {}, growth[2] = {};
  for (int k = 0; k < 2; ++k) {
    Cluster cluster(setup, {.step = step / (1 << k)});
    const Vec3 p = cluster.momentum(), l = cluster.angular_momentum();
    const double energy = cluster.energy().total();
    double least = cluster.energy().mechanical();
    for (int n = 0; n < steps << k; ++n) {
      cluster.step();
      const ClusterEnergy e = cluster.energy();
      REQUIRE(e.strained >= 0);
      drift[k] = std::max(drift[k], std::abs(e.total() / energy - 1));
      growth[k] = std::max(growth[k], (e.mechanical() - least) / energy);
      least = std::min(least, e.mechanical());
    }
    CHECK(norm(cluster.momentum() - p) < 1e-12 * momentum_scale);
    CHECK(norm(cluster.angular_momentum() - l) < 1e-12 * angular_scale);
    CHECK(cluster.energy().lost_friction > 1e-3 * energy);
  }
  CAPTURE(drift[0], drift[1], growth[0], growth[1]);
  // Order 2, scattered by the phases of many events. A swing of ω h = 6e-3 is off by (ω h)²/8 of its energy.
  CHECK(drift[1] < 0.4 * drift[0]);
  CHECK(drift[1] < 2e-5);
  CHECK(growth[1] < 5e-6);
}

TEST_CASE("results do not depend on the inertial frame") {
  const ClusterSetup setup = compliant_or_not(random_clump(11, Linear(20000, 0.6), rough));
  ClusterSetup moving = setup;
  const Vec3 wind{1.5, -2.25, 0.5};
  for (Sphere& s : moving.spheres) s.velocity += wind;
  check_same(
      run(setup), run(moving), scale(setup), [&](Vec3 v) { return v + wind; }, same_vector, same_index);
}

TEST_CASE("results turn with the scene, gravity included") {
  ClusterSetup setup = compliant_or_not(random_clump(12, Fractional(20000, 1, 0.3), rough));
  setup.gravity = {0, 0, -9.81};
  setup.walls.push_back({{0, 0, -0.06}, {0, 0, 1}});
  ClusterSetup turned = setup;
  turned.gravity = rotate(setup.gravity);
  turned.walls[0] = {rotate(setup.walls[0].point), rotate(setup.walls[0].inward)};
  for (Sphere& s : turned.spheres)
    s.position = rotate(s.position), s.velocity = rotate(s.velocity), s.spin = rotate(s.spin);
  check_same(run(setup), run(turned), scale(setup), rotate, rotate, same_index);
}

TEST_CASE("results do not depend on the numbering") {
  const ClusterSetup setup = compliant_or_not(random_clump(13, Linear(20000, 0.6), rough));
  ClusterSetup reversed = setup;
  std::reverse(reversed.spheres.begin(), reversed.spheres.end());
  const std::size_t last = setup.spheres.size() - 1;
  check_same(run(setup), run(reversed), scale(setup), same_vector, same_vector,
             [&](std::size_t i) { return last - i; });
}

TEST_CASE("a mirrored scene gives the mirrored result") {
  const ClusterSetup setup = compliant_or_not(random_clump(14, Hysteretic(15000, 25000), rough));
  ClusterSetup mirrored = setup;
  const auto mirror = [](Vec3 v) { return Vec3{-v.x, v.y, v.z}; };
  const auto mirror_spin = [](Vec3 w) { return Vec3{w.x, -w.y, -w.z}; };  // spins are axial vectors
  for (Sphere& s : mirrored.spheres)
    s.position = mirror(s.position), s.velocity = mirror(s.velocity), s.spin = mirror_spin(s.spin);
  check_same(run(setup), run(mirrored), scale(setup), mirror, mirror_spin, same_index);
}

TEST_CASE("a restored state continues to the last bit") {
  const ClusterSetup setup = compliant_or_not(random_clump(15, Fractional(20000, 1, 0.3), rough));
  const ClusterOptions options{.step = step};
  Cluster whole(setup, options), half(setup, options), rest(setup, options);
  REQUIRE(whole.advance(steps));
  REQUIRE(half.advance(2000));
  CHECK(half.contacts().size() > 0);
  rest.restore(half.state());
  REQUIRE(rest.advance(steps - 2000));
  for (std::size_t i = 0; i < whole.size(); ++i) {
    CHECK(whole.velocity(i) == rest.velocity(i));
    CHECK(whole.position(i) == rest.position(i));
    CHECK(whole.spin(i) == rest.spin(i));
  }
  CHECK(whole.energy().lost_friction == rest.energy().lost_friction);
}
