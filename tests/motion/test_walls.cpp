#include "scenes.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <functional>
#include <numbers>

using namespace ricochet;
using namespace ricochet::test;

namespace {

constexpr double r = 0.01, rho = 2500, g = 9.81;

// A sphere that rests on a wall below it, as deep as its weight presses a linear spring of stiffness k.
Sphere resting(Vec3 below, double k) {
  Sphere s{.radius = r, .density = rho};
  s.position = below + Vec3{0, 0, r - s.mass() * g / k};
  return s;
}

ClusterSetup on_wall(const Wall& wall, Vec3 below, double k, Friction friction, double c = 0) {
  ClusterSetup setup = with_law(Linear(k, c), friction);
  setup.gravity = {0, 0, -g};
  setup.walls = {wall};
  setup.spheres = {resting(below, k)};
  return setup;
}

ClusterOptions steps_of(double step) {
  ClusterOptions options;
  options.step = step;
  return options;
}

// Of a quantity at a time, from three steps that halve: what remains when it is computed by Richardson's table.
double order(const std::function<double(double)>& at, double step) {
  const double a = at(step), b = at(step / 2), c = at(step / 4);
  return std::log2(std::abs((a - b) / (b - c)));
}

}  // namespace

TEST_CASE("a sphere laid on a belt slides, then rolls along, from the time that friction needs") {
  const double k = 1e7, mu = 0.3, V = 0.7;
  Wall belt{.motion = {.velocity = {V, 0, 0}}};
  ClusterSetup setup = on_wall(belt, {}, k, Friction(mu, mu, 0, 0));
  const Sphere& s = setup.spheres[0];
  const double arm = 0.5 * (r + s.position.z), inertia = s.inertia() / s.mass();
  const double until = V / (mu * g * (1 + arm * arm / inertia)), speed = mu * g * until;  // (7/2) μ g, (2/7) V
  Cluster cluster(setup, steps_of(1e-6));
  REQUIRE(cluster.advance(std::uint64_t(2 * until / 1e-6)));
  REQUIRE(cluster.contacts().size() == 1);
  CHECK(cluster.contacts()[0].record.phase_begin[std::size_t(Phase::rolling)] == Approx(until).margin(1e-6));
  CHECK(cluster.velocity(0).x == Approx(speed).epsilon(1e-6));
  CHECK(cluster.spin(0).y == Approx(-speed * arm / inertia).epsilon(1e-6));  // its lower side keeps up
  const ClusterEnergy e = cluster.energy();
  const double gained = mu * s.mass() * g * until * V;  // what the belt does, of which friction burns a part
  CHECK(e.wall_work == Approx(gained).epsilon(1e-5));
  CHECK(e.lost_friction == Approx(0.5 * mu * s.mass() * g * until * V).epsilon(1e-5));
  CHECK(e.total() == Approx(Cluster(setup, steps_of(1e-6)).energy().total()).margin(1e-9 * gained));
}

TEST_CASE("a sphere that rolls in a cylinder is a pendulum of 7/5 of its inertia, one that slides freely of 1") {
  const double k = 1e6, R = 0.05, tilt = 0.01;
  const double expected_arm = r - 0.5 * (4.0 / 3 * std::numbers::pi * r * r * r * rho) * g / k;
  const auto period = [&](Friction friction, TangentialLaw tangential) {
    ClusterSetup setup = on_wall({.inward = {0, 1, 0}, .form = surface::Cylinder{R}}, {0, 0, -R}, k, friction);
    setup.interactions.at({0, 0}).tangential = tangential;
    const double d = -setup.spheres[0].position.z;
    setup.spheres[0].position = {d * std::sin(tilt), 0.003, -d * std::cos(tilt)};
    const double h = 1e-5;
    Cluster cluster(setup, steps_of(h));
    std::vector<double> crossings;
    for (double last = 1; crossings.size() < 3;) {
      cluster.step();
      const double x = cluster.position(0).x;
      if (last > 0 && x <= 0) crossings.push_back(cluster.time() - h * x / (x - last));
      last = x;
    }
    CHECK(std::abs(cluster.position(0).y - 0.003) < 1e-12);
    return 0.5 * (crossings[2] - crossings[0]);
  };
  const double d = R - r + 2 * (r - expected_arm), inertia = 0.4 * r * r / (expected_arm * expected_arm);
  // sin θ for θ: 1 + θ²/16 longer; the spring gives way by far less.
  const double swing = 2 * std::numbers::pi * std::sqrt(d / g) * (1 + tilt * tilt / 16);
  CHECK(period(Friction(), RigidTangential{}) == Approx(swing).epsilon(2e-6));
  CHECK(period(Friction(0.5, 0.5, 0, 0), RigidTangential{}) == Approx(swing * std::sqrt(1 + inertia)).epsilon(2e-6));
  CHECK(period(Friction(0.5, 0.5, 0, 0), LinearTangential(1e6, 0)) ==
        Approx(swing * std::sqrt(1 + inertia)).epsilon(2e-5));
}

TEST_CASE("a turning drum and a swinging plane move a sphere with order 2, and their work closes the balance") {
  const auto drum = [](bool springs) {
    Wall wall{.inward = {0, 1, 0}, .form = surface::Cylinder{0.05}, .motion = {.spin = 6}};
    ClusterSetup setup = on_wall(wall, {0, 0, -0.05}, 2e4, Friction(0.2, 0.2, 0, 0), 0.2);
    if (!springs) return setup;  // it slides all along
    setup.interactions.at({0, 0}).tangential = LinearTangential(1e4, 0.3);
    setup.spheres[0].spin = {0, 6, 0};  // carried round, it slips on springs alone
    setup.spheres[0].velocity = cross(setup.spheres[0].spin, setup.spheres[0].position);
    return setup;
  };
  const auto table = [](bool springs) {
    Wall wall{.motion = {.amplitude = {0.001, 0.0005, 0.0002}, .frequency = 20}};
    ClusterSetup setup = on_wall(wall, {}, 2e4, Friction(0.9, 0.9, 0, 0), 0.2);
    setup.spheres[0].velocity = 2 * std::numbers::pi * 20 * wall.motion.amplitude;
    if (springs) setup.interactions.at({0, 0}).tangential = LinearTangential(1e4, 0.3);
    return setup;
  };
  for (const bool springs : {false, true})
    for (const ClusterSetup& setup : {drum(springs), table(springs)}) {
      CAPTURE(springs, setup.walls[0].motion.spin);
      const double duration = 0.04;
      const auto end = [&](double step) {
        Cluster cluster(setup, steps_of(step));
        cluster.advance(std::uint64_t(std::llround(duration / step)));
        return cluster;
      };
      const double x = order([&](double h) { return end(h).position(0).x; }, 8e-5);
      CHECK(x > 1.8);
      CHECK(x < 2.2);
      const auto imbalance = [&](double h) {
        return end(h).energy().total() - Cluster(setup, steps_of(h)).energy().total();
      };
      const double work = end(1e-5).energy().wall_work;
      CHECK(std::abs(work) > 1e-7);
      CHECK(std::abs(imbalance(1e-5)) < 1e-3 * std::abs(work));
      const double gain = std::log2(std::abs(imbalance(4e-5) / imbalance(2e-5)));
      CAPTURE(imbalance(8e-5), imbalance(4e-5), imbalance(2e-5), imbalance(1e-5));
      CHECK(gain > 1.8);
      CHECK(gain < 2.2);
    }
}

TEST_CASE("a turning drum turns about its own axis, wherever that is") {
  const auto end = [](Vec3 place) {
    Wall wall{.point = place, .inward = {0, 1, 0}, .form = surface::Cylinder{0.05}, .motion = {.spin = 6}};
    const ClusterSetup setup = on_wall(wall, place + Vec3{0, 0, -0.05}, 2e4, Friction(0.2, 0.2, 0, 0), 0.2);
    Cluster cluster(setup, steps_of(2e-5));
    cluster.advance(2000);
    return cluster;
  };
  const Cluster here = end({}), there = end({1, 2, -3});
  CHECK(norm(here.velocity(0)) > 0.01);
  CHECK(norm(here.velocity(0) - there.velocity(0)) < 1e-9);
  CHECK(r * norm(here.spin(0) - there.spin(0)) < 1e-9);
  CHECK(there.energy().wall_work == Approx(here.energy().wall_work).epsilon(1e-6));
}

TEST_CASE("cones, rings and plates are met at their nearest point, edges included") {
  const auto gap = [](const Wall& wall, Vec3 x) {
    const ContactGeometry met = motion::Surface(wall).meet(x, r, 0);
    CHECK(norm(met.normal) == Approx(1));
    return r - met.overlap;
  };
  const Wall cone{.form = surface::Cone{.length = 0.3, .first = 0.1, .last = 0.5}};  // rises 4 for 3
  CHECK(gap(cone, {0.3 - 0.03, 0, 0.15 + 0.04}) == Approx(0.05));                    // across, inside
  CHECK(gap(cone, {0, 0.3 + 0.03, 0.15 - 0.04}) == Approx(0.05));                    // and outside
  CHECK(gap(cone, {0, 0.06, -0.03}) == Approx(0.05));                                // from the rim below
  CHECK(gap(cone, {-0.53, 0, 0.34}) == Approx(0.05));                                // and above
  const Wall ring{.form = surface::Cone{.length = 0, .first = 0.02, .last = 0.1}};
  CHECK(gap(ring, {0.05, 0, 0.03}) == Approx(0.03));
  CHECK(gap(ring, {0.05, 0, -0.03}) == Approx(0.03));
  CHECK(gap(ring, {0, 0.016, 0.003}) == Approx(0.005));
  const Wall disc{.form = surface::Cone{.length = 0, .first = 0, .last = 0.1}};
  CHECK(gap(disc, {0, 0, 0.03}) == Approx(0.03));
  const Wall plate{.point = {1, 2, 3}, .form = surface::Plate{{0.2, 0, 0}, {0, 0.1, 0}}};
  CHECK(gap(plate, {1.1, 2.05, 3.04}) == Approx(0.04));
  CHECK(gap(plate, {1.23, 2.14, 3}) == Approx(0.05));
  CHECK(gap(plate, {0.98, 2.05, 2.9}) == Approx(std::hypot(0.02, 0.1)));
  const Wall drum{.inward = {0, 2, 0}, .form = surface::Cylinder{0.1}};
  CHECK(gap(drum, {0.03, 5, 0.04}) == Approx(0.05));
  CHECK(gap(drum, {0.09, 5, 0.12}) == Approx(-0.05));  // pushed out: the wall still pushes in
}

TEST_CASE("an edge turns a sphere about itself: no angular momentum about it is lost, nor energy") {
  ClusterSetup setup = with_law(Linear(1e5, 0));
  setup.walls = {{.form = surface::Cone{.length = 0, .first = 0.03, .last = 0.1}}};
  Sphere s{.radius = r, .density = rho};
  s.position = {0.025, 0, 0.02}, s.velocity = {0, 0, -1};  // passes the rim, 5 mm off its middle
  setup.spheres = {s};
  Cluster cluster(setup, steps_of(1e-6));
  const Vec3 rim{0.03, 0, 0};
  const auto about_rim = [&] { return cross(cluster.position(0) - rim, cluster.velocity(0)); };
  const Vec3 before = about_rim();
  const double energy = cluster.energy().total();
  bool met = false;
  for (int k = 0; k < 40000; ++k) {
    cluster.step();
    met = met || !cluster.contacts().empty();
    REQUIRE(norm(about_rim() - before) < 1e-11 * norm(before));  // 40000 roundings
  }
  CHECK(met);
  CHECK(cluster.contacts().empty());
  CHECK(std::abs(cluster.velocity(0).x) > 0.5);
  CHECK(cluster.energy().mechanical() == Approx(energy).epsilon(1e-5));
}

TEST_CASE("nobody goes through a surface that ends somewhere without being noticed") {
  ClusterSetup setup = with_law(Linear(1e3, 0));
  setup.walls = {{.point = {-0.1, -0.1, 0}, .form = surface::Plate{{0.2, 0, 0}, {0, 0.2, 0}}}};
  Sphere s{.radius = r, .density = rho};
  s.position = {0, 0, 0.02};
  const double stops = r * std::sqrt(1e3 / s.mass());  // at which the spring would stop it a radius deep
  const auto went_through = [&](double speed) {
    s.velocity = {0, 0, -speed};
    setup.spheres = {s};
    Cluster cluster(setup, steps_of(1e-5));
    for (int k = 0; k < 4000; ++k) {
      cluster.step();
      if (const auto through = cluster.breakthrough()) return through->j == 1;
    }
    return false;
  };
  CHECK_FALSE(went_through(0.98 * stops));
  CHECK(went_through(1.02 * stops));
}

TEST_CASE("over a hole too narrow for it nobody has gone through the surface around") {
  ClusterSetup setup = with_law(Linear(1e4, 0.5));
  setup.gravity = {0, 0, -9.81};
  setup.walls = {{.inward = {0, 0, 1}, .form = surface::Cone{.length = 0, .first = 0.9 * r, .last = 10 * r}}};
  Sphere s{.radius = r, .density = rho};
  s.position = {0.01 * r, 0, 2 * r};
  setup.spheres = {s};
  Cluster cluster(setup, steps_of(1e-5));
  for (int k = 0; k < 20000; ++k) {
    cluster.step();
    REQUIRE_FALSE(cluster.breakthrough());
  }
  CHECK(cluster.position(0).z > 0.3 * r);  // its centre rests by 0.44 r over the hole
}

TEST_CASE("a motion among walls that swing goes on from any step to the last bit") {
  ClusterSetup setup = with_law(Linear(1e4, 0.5));
  setup.gravity = {0, 0, -9.81};
  setup.walls = {{.motion = {.amplitude = {0, 0, 0.1 * r}, .frequency = 37}}};
  setup.spheres = {{.radius = r, .density = rho, .position = {0, 0, 1.2 * r}}};
  const ClusterOptions options = steps_of(1.7e-5);
  Cluster through(setup, options);
  for (int stop = 0; stop < 300; ++stop) {  // some of whose times are rounded otherwise than a sum of steps
    REQUIRE(through.advance(7));
    Cluster resumed(setup, options);
    resumed.restore(through.state());
    REQUIRE(resumed.state().velocities == through.state().velocities);  // the wall's too
  }
}

TEST_CASE("a wall that comes to a sphere finds it") {
  ClusterSetup setup = with_law(Linear(1e5, 0));
  setup.walls = {{.point = {0, 0, -0.3}, .motion = {.velocity = {0, 0, 1}}}};
  setup.spheres = {{.radius = r, .density = rho}};
  Cluster cluster(setup, steps_of(1e-5));
  REQUIRE(cluster.advance(40000));
  CHECK(cluster.velocity(0).z == Approx(2).epsilon(1e-4));  // elastic, of a wall of infinite mass
  CHECK(cluster.energy().total() == Approx(0).margin(1e-4 * cluster.energy().kinetic));
  CHECK(cluster.energy().wall_work == Approx(2 * setup.spheres[0].mass()).epsilon(1e-3));
  const auto met = cluster.take_finished();
  REQUIRE(met.size() == 1);
  CHECK(met[0].begin == Approx(0.29).margin(2e-5));
}

TEST_CASE("walls out of their domain are refused by what is wrong") {
  const auto complaint = [](const Wall& wall) {
    try {
      check(wall);
    } catch (const std::invalid_argument& wrong) {
      return std::string(wrong.what());
    }
    return std::string();
  };
  CHECK(complaint({}).empty());
  CHECK(complaint({.inward = {}}) == "|inward| = 0: must be finite and > 0");
  CHECK(complaint({.point = {NAN, 0, 0}}) == "point: must be three finite numbers");
  CHECK(complaint({.form = surface::Cylinder{0}}) == "radius = 0: must be finite and > 0");
  CHECK(complaint({.form = surface::Cone{.length = 1, .first = 0, .last = 1}}) ==
        "radius = 0: must be > 0 where the surface is no disc");
  CHECK(complaint({.form = surface::Cone{.length = 0, .first = 1, .last = 1}}) ==
        "radius = 1: must be other than the first of a ring");
  CHECK(complaint({.form = surface::Plate{{1, 0, 0}, {1, 1, 0}}}).find("must be 0, as of a rectangle") !=
        std::string::npos);
  CHECK(complaint({.form = surface::Plate{{1, 0, 0}, {0, 1, 0}}, .motion = {.spin = 1}}) ==
        "spin = 1: must be 0 of a plate");
  CHECK(complaint({.motion = {.frequency = -1}}) == "frequency = -1: must be finite and >= 0");
}
