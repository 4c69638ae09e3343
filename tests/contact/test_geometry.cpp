#include <catch2/catch.hpp>
#include <ricochet/contact/geometry.hpp>

using namespace ricochet;

TEST_CASE("two spheres: the lens's chord and centre plane agree with plane geometry") {
  // In the plane: circles of radii 3 and 4 at distance 5 meet at a right angle, at 9/5 from the first centre.
  const ContactGeometry g = sphere_sphere({1, 2, 3}, 3, {1, 2, 8}, 4);
  CHECK(g.normal == Vec3{0, 0, 1});
  CHECK(g.overlap == Approx(2).epsilon(1e-15));
  CHECK(g.arm_i == Approx(1.8).epsilon(1e-15));
  CHECK(g.arm_j == Approx(3.2).epsilon(1e-15));
  CHECK(g.radius == Approx(2.4).epsilon(1e-15));
}

TEST_CASE("apart, a sphere within a sphere and coincident centres leave no NaN") {
  CHECK(sphere_sphere({0, 0, 0}, 1, {3, 0, 0}, 1).overlap == -1);
  CHECK(sphere_sphere({0, 0, 0}, 1, {3, 0, 0}, 1).radius == 0);
  CHECK(sphere_sphere({0, 0, 0}, 3, {0.5, 0, 0}, 1).radius == 0);
  const ContactGeometry same = sphere_sphere({1, 1, 1}, 1, {1, 1, 1}, 1);
  CHECK(same.overlap == 2);
  CHECK(same.normal == Vec3{0, 0, 1});
  CHECK(same.arm_i == 0);
}

TEST_CASE("a sphere on a wall") {
  const ContactGeometry g = sphere_wall({5, 1, 0.9}, 1, {0, 0, 0}, {0, 0, 1});
  CHECK(g.normal == Vec3{0, 0, -1});
  CHECK(g.overlap == Approx(0.1).epsilon(1e-14));
  CHECK(g.radius == Approx(std::sqrt(1 - 0.81)).epsilon(1e-14));
  CHECK(g.arm_i == Approx(0.95).epsilon(1e-15));
}
