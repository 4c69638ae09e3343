#include <ricochet/motion/bodies.hpp>

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/collision.hpp>

#include <catch2/catch.hpp>

#include <numbers>

#include "scenes.hpp"

using namespace ricochet;
using namespace ricochet::test;

namespace {

/// Two spheres, the second the lighter, that meet at 0.5 m/s.
ClusterSetup pair_of(AnyLaw law) {
  ClusterSetup setup = with_law(std::move(law));
  setup.spheres.push_back({2e-3, 1000, {}, {0.5, 0, 0}});
  setup.spheres.push_back({1e-3, 2000, {0.01, 0, 0}});
  return setup;
}

double mass_eff(const ClusterSetup& setup) {
  const double a = setup.spheres[0].mass(), b = setup.spheres[1].mass();
  return a * b / (a + b);
}

}  // namespace

TEST_CASE("A box has six walls that all look inwards") {
  const std::vector<Wall> walls = box_walls({-1, -2, -3}, {1, 2, 3}, 4);
  REQUIRE(walls.size() == 6);
  Vec3 sum{};
  for (const Wall& wall : walls) {
    CHECK(dot(-wall.point, wall.inward) > 0);  // the centre lies inside
    CHECK(norm(wall.inward) == 1);
    CHECK(wall.material == 4);
    sum += wall.inward;
  }
  CHECK(norm(sum) == 0);
  CHECK_THROWS_WITH(box_walls({0, 0, 0}, {1, 0, 1}), Catch::Contains("low must be below high"));
}

TEST_CASE("The stiffest contact lasts as long as the collision without its damping") {
  const auto stiffest = [](const AnyLaw& law) {
    const StiffestContact s = stiffest_contact(pair_of(law));
    CHECK(s.i + s.j == 1);
    return s.tcol;
  };
  const double m = mass_eff(pair_of(Linear(1, 0)));
  CHECK(stiffest(Linear(5000, 0.1)) == Approx(collide(Linear(5000, 0), {0.5, m}).tcol).epsilon(1e-12));
  CHECK(stiffest(Hysteretic(4000, 9000)) == Approx(collide(Linear(9000, 0), {0.5, m}).tcol).epsilon(1e-12));
  // The Hertzian time is that of 2.943 (3 digits beyond which it is not needed), at the impact's speed.
  CHECK(stiffest(Tsuji(1e6, 0.3)) == Approx(collide(Tsuji(1e6, 1e-9), {0.5, m}).tcol).epsilon(2e-4));
  CHECK(stiffest(KuwabaraKono(1e6, 3)) == Approx(collide(Tsuji(1e6, 1e-9), {0.5, m}).tcol).epsilon(2e-4));
  const Fractional law(5000, 0.1, 0.3);
  const FractionalContact exact = fractional_contact(0.3);
  const double tcol = std::pow(exact.z_star * m / law.coefficient(), 1 / 1.7);
  CHECK(stiffest(law) == Approx(tcol).epsilon(0.04));  // (57) is an estimate
}

TEST_CASE("A tangential spring that swings faster than its contact lasts is the stiffest, and said to be") {
  for (const double k_t : {1400.0, 1450.0}) {  // two sevenths of the normal k are 1428.6
    CAPTURE(k_t);
    ClusterSetup setup = pair_of(Linear(5000, 0));
    for (auto& [pair, interaction] : setup.interactions) interaction.tangential = LinearTangential(k_t, 0);
    const StiffestContact s = stiffest_contact(setup);
    const double m = mass_eff(setup), across = std::numbers::pi * std::sqrt(2.0 / 7 * m / k_t);
    CHECK(s.tangential == (k_t > 10000.0 / 7));
    CHECK(s.tcol == Approx(std::min(std::numbers::pi * std::sqrt(m / 5000), across)).epsilon(1e-12));
  }
}

TEST_CASE("Walls, materials and gravity take part in the stiffest contact") {
  ClusterSetup setup = pair_of(Linear(5000, 0));
  setup.walls.push_back({{0, 0, -1}, {0, 0, 1}, 1});
  setup.interactions.insert({{0, 1}, {Linear(2e5, 0)}});
  const StiffestContact wall = stiffest_contact(setup);
  CHECK(wall.i == 1);  // the lighter
  CHECK(wall.j == 2);  // walls count after the spheres
  CHECK(wall.tcol == Approx(std::numbers::pi * std::sqrt(setup.spheres[1].mass() / 2e5)).epsilon(1e-12));

  // At rest a Hertzian pair never meets; gravity g over the greatest diameter d gives it sqrt(2 g d).
  ClusterSetup still = pair_of(Tsuji(1e6, 0.3));
  for (Sphere& s : still.spheres) s.velocity = {};
  CHECK(stiffest_contact(still).tcol == 0);
  still.gravity = {0, 0, -9.81};
  const double speed = std::sqrt(2 * 9.81 * 2 * 2e-3);
  CHECK(stiffest_contact(still).tcol == Approx(collide(Tsuji(1e6, 1e-9), {speed, mass_eff(still)}).tcol).epsilon(2e-4));
}

TEST_CASE("A setup that cannot run is named") {
  ClusterSetup setup = pair_of(Linear(5000, 0));
  setup.spheres[1].radius = 0;
  CHECK_THROWS_WITH(check(setup), Catch::Contains("sphere 2 radius = 0"));
  setup = pair_of(Linear(5000, 0));
  setup.spheres[0].spin.y = std::nan("");
  CHECK_THROWS_WITH(check(setup), "sphere 1 spin: must be three finite numbers");
  setup = pair_of(Linear(5000, 0));
  setup.walls.push_back({{}, {0, 0, 0}});
  CHECK_THROWS_WITH(check(setup), Catch::Contains("wall 1 |inward| = 0"));
  setup = pair_of(Linear(5000, 0));
  setup.spheres[1].material = 3;
  CHECK_THROWS_WITH(check(setup), "materials 0 and 3 can meet: must have an interaction");
  CHECK_THROWS_WITH(check(pair_of(Fractional(1, 1, 1.5))), Catch::Contains("alpha = 1.5"));
}
