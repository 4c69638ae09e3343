#include <catch2/catch.hpp>

#include "scenes.hpp"

#include <numbers>

using namespace ricochet;
using namespace ricochet::test;

namespace {

constexpr double r = 0.01, density = 2000, g = 9.81;

// A sphere that rests on a wall inclined by `slope`, at the overlap where its weight is borne.
struct Incline {
  ClusterSetup setup;
  Vec3 downhill{1, 0, 0}, up{0, 0, 1};

  Incline(double slope, Friction friction, double stiffness) : setup(with_law(Linear(stiffness, 0), friction)) {
    setup.gravity = g * Vec3{std::sin(slope), 0, -std::cos(slope)};
    setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
    Sphere s{r, density, {}, {}, {}, 0};
    s.position.z = r - s.mass() * g * std::cos(slope) / stiffness;
    setup.spheres.push_back(s);
  }
};

double coast(const ClusterSetup& setup, double step, double duration, auto&& observe) {
  Cluster cluster(setup, {.step = step});
  while (cluster.time() < duration) {
    cluster.step();
    observe(cluster);
  }
  return cluster.time();
}

}  // namespace

TEST_CASE("a sliding sphere rolls with 5/7 of its speed from t = 2v/(7 mu g) on") {
  const double mu = 0.3, v = 0.4;
  Incline plane(0, Friction(mu, mu, 0, 0), 1e6);  // stiff: the arm of friction is r to 1e-6
  plane.setup.spheres[0].velocity = {0.6 * v, 0.8 * v, 0};
  Cluster cluster(plane.setup, {.step = 1e-4});
  REQUIRE(cluster.advance(1000));
  CHECK(norm(cluster.velocity(0)) == Approx(5.0 / 7 * v).epsilon(1e-5));
  CHECK(r * norm(cluster.spin(0)) == Approx(5.0 / 7 * v).epsilon(1e-5));
  const auto& phases = cluster.contacts()[0].record.phase_begin;
  CHECK(phases[std::size_t(Phase::sliding)] == 0);
  CHECK(phases[std::size_t(Phase::rolling)] == Approx(2 * v / (7 * mu * g)).epsilon(1e-5));  // well within a step
  // From there it rolls for ever, and friction takes nothing more.
  const double lost = cluster.energy().lost_friction;
  const Vec3 before = cluster.velocity(0);
  REQUIRE(cluster.advance(1000));
  CHECK(norm(cluster.velocity(0) - before) < 1e-13 * v);
  CHECK(cluster.energy().lost_friction == Approx(lost).epsilon(1e-12));
}

TEST_CASE("a grain that slides through its rebound keeps the spin it got, where nobody asks for rolling resistance") {
  // Chung & Ooi, Granular Matter 13, 643 (2011), test 4: alumina at 3.9 m/s, 40° from the normal, e = 0.98, mu = 0.092.
  // Gross sliding throughout: omega r = (5/2) mu (1 + e) v_n. Measured by Kharaz et al.: 595 1/s.
  const double mu = 0.092, en = 0.98, angle = 40 * std::numbers::pi / 180, radius = 2.5e-3;
  const double vn = 3.9 * std::cos(angle), loss = -std::log(en), mass = Sphere{radius, 4000}.mass(), tcol = 1e-5;
  const double k = mass * (std::numbers::pi * std::numbers::pi + loss * loss) / (tcol * tcol),
               c = 2 * loss * mass / tcol;
  ClusterSetup setup = with_law(Linear(k, c), Friction(mu, mu, 0));
  setup.interactions.at({0, 0}).end = ContactEnd::overlap;
  setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
  setup.spheres.push_back({radius, 4000, {0, 0, radius}, {3.9 * std::sin(angle), 0, -vn}, {}, 0});
  Cluster cluster(setup, {.step = tcol / 500});
  REQUIRE(cluster.advance(600));
  CHECK(cluster.contacts().empty());
  // The arm of friction is r less half the overlap, which is at most v_n t_col/pi: 0.2 % of r in the mean.
  CHECK(cluster.spin(0).y == Approx(2.5 * mu * (1 + en) * vn / radius).epsilon(4e-3));
  CHECK(cluster.velocity(0).z == Approx(en * vn).epsilon(1e-5));
}

TEST_CASE("a spinning top slows by (2/3) mu a N/J") {
  const double mu = 0.4, stiffness = 2000;
  Incline plane(0, Friction(mu, mu, 0, 1), stiffness);
  plane.setup.spheres[0].spin = {0, 0, 100};
  const Sphere& s = plane.setup.spheres[0];
  const double overlap = s.mass() * g / stiffness, a = std::sqrt(overlap * (2 * r - overlap));
  Cluster cluster(plane.setup, {.step = 1e-4});
  REQUIRE(cluster.advance(500));
  CHECK(cluster.spin(0).z == Approx(100 - 2.0 / 3 * mu * a * s.mass() * g / s.inertia() * 0.05).epsilon(1e-12));
  CHECK(norm(cluster.velocity(0)) < 1e-14);
}

TEST_CASE("sliding and spinning at once end together, friction weaker than of either alone") {
  const double mu = 0.3;
  Incline plane(0, Friction(mu, mu, 0, 0), 500);
  plane.setup.spheres[0].velocity = {0.1, 0, 0};
  plane.setup.spheres[0].spin = {0, 0, 400};
  // As m_t a²/J = (5/7)(a/r)² < 3/2, λ tends to 0: the slip dies with the spin as a power of it, never before.
  double spin_at_rest = 0;
  Cluster cluster(plane.setup, {.step = 1e-4});
  bool stuck = false;
  cluster.step();  // the elastic energy at rest counts from here
  double last_energy = cluster.energy().mechanical();
  for (int n = 0; n < 100000 && !stuck; ++n) {
    const double spin_before = cluster.spin(0).z;
    cluster.step();
    const double energy = cluster.energy().mechanical();
    REQUIRE(energy <= last_energy * (1 + 1e-14));
    last_energy = energy;
    const auto& phases = cluster.contacts()[0].record.phase_begin;
    stuck =
        phases[std::size_t(Phase::rolling)] != Encounter::never || phases[std::size_t(Phase::rest)] != Encounter::never;
    if (stuck) spin_at_rest = spin_before;
  }
  REQUIRE(stuck);
  CHECK(std::abs(cluster.spin(0).z) < 1e-12);
  const double per_step =
      2.0 / 3 * mu * 0.01 * plane.setup.spheres[0].mass() * g / plane.setup.spheres[0].inertia() * 1e-4;
  CHECK(spin_at_rest < per_step);  // no more than one step's loss was left when the slip ended
}

TEST_CASE("a sphere on a slope stays put to rounding where friction and rolling resistance can hold it") {
  // Soft contact, wide arm: rolling resistance holds while tan(slope) < ρa/|s|.
  Incline plane(0.2, Friction(0.5, 0.5, 0, 3), 400);
  Cluster cluster(plane.setup, {.step = 1e-4});
  const Vec3 start = cluster.position(0);
  double worst = 0;
  for (int n = 0; n < 20000; ++n) {
    cluster.step();
    worst = std::max(worst, norm(cluster.velocity(0)) + r * norm(cluster.spin(0)));
  }
  CHECK(norm(cluster.position(0) - start) < 1e-14);
  CHECK(worst < 1e-13);
  CHECK(cluster.contacts()[0].record.phase_begin[std::size_t(Phase::rest)] == Approx(0).margin(1e-15));
  CHECK(cluster.contacts()[0].record.phase_begin[std::size_t(Phase::sliding)] == Encounter::never);
}

TEST_CASE("a coefficient of rolling resistance holds a sphere up to mu_r R N, whatever the contact's width") {
  // tan(slope) < μ_r R*/|s| rests; above it the rest of the moment rolls it: (5/7) g (sin − μ_r cos) for an arm of r.
  const auto speed = [](double slope, double mu_rolling) {
    Incline plane(slope, Friction(0.5, 0.5, 0), 1e6);
    plane.setup.interactions.at({0, 0}).rolling.mu = mu_rolling;
    Vec3 v;
    const double t = coast(plane.setup, 1e-4, 0.05, [&](const Cluster& c) { v = c.velocity(0); });
    return v.x / t;
  };
  const double slope = std::atan(0.1);
  CHECK(std::abs(speed(slope, 0.101)) < 1e-12);
  CHECK(speed(slope, 0.04) == Approx(5.0 / 7 * g * (std::sin(slope) - 0.04 * std::cos(slope))).epsilon(1e-5));
}

TEST_CASE("rolling resistance slows a spin where nothing resists sliding") {
  // omega' = −limit/J with the limit μ_r r N, or ρ a N; no force along the plane.
  const double spin = 100, stiffness = 400;
  const auto slowing = [&](const Friction& friction, double mu_rolling) {
    Incline plane(0, friction, stiffness);
    plane.setup.interactions.at({0, 0}).rolling.mu = mu_rolling;
    plane.setup.spheres[0].spin = {0, spin, 0};
    double left = 0;
    const double t = coast(plane.setup, 1e-4, 0.05, [&](const Cluster& c) {
      left = c.spin(0).y;
      REQUIRE(norm(c.velocity(0)) < 1e-12);
    });
    return (spin - left) / t;
  };
  const Incline plane(0, Friction(), stiffness);
  const double overlap = r - plane.setup.spheres[0].position.z, a = std::sqrt(overlap * (2 * r - overlap));
  CHECK(slowing(Friction(0, 0, 0, 0), 0.04) == Approx(2.5 * 0.04 * g / r).epsilon(1e-9));
  CHECK(slowing(Friction(0, 0, 0, 1), 0) == Approx(2.5 * a * g / (r * r)).epsilon(1e-9));
}

TEST_CASE("down a slope a sphere rolls with (5/7) g sin, slides with g (sin - mu cos)") {
  const double mu = 0.2;
  const Friction plain(mu, mu, 0, 0);
  const auto acceleration = [&](double slope) {
    const Incline plane(slope, plain, 1e6);
    Vec3 v;
    const double t = coast(plane.setup, 1e-4, 0.05, [&](const Cluster& c) { v = c.velocity(0); });
    return v.x / t;
  };
  const double gentle = std::atan(3.4 * mu), steep = std::atan(3.6 * mu);  // rolling needs tan ≤ 3.5 μ
  CHECK(acceleration(gentle) == Approx(5.0 / 7 * g * std::sin(gentle)).epsilon(1e-5));
  CHECK(acceleration(steep) == Approx(g * (std::sin(steep) - mu * std::cos(steep))).epsilon(1e-5));
}

TEST_CASE("a contact that sticks has no slip at the end of a step, though its arms and its normal change within") {
  // Impulses pass in the middle of a step, where the geometry is known; what the slip gains from there to the end is
  // foreseen to first order. So the slip left at the end is of second order in the step, of first order without.
  struct Scene {
    ClusterSetup setup;
    double duration;
  };
  const auto bouncing_on_a_wall = [] {
    Incline plane(0, Friction(5, 5, 0, 0), 60);  // soft: the overlap is 0.03 r to 0.08 r
    Sphere& s = plane.setup.spheres[0];
    s.velocity = {0.2, 0, 0.004};
    const double arm = r - 0.5 * (r - s.position.z);
    s.spin = {0, 0.2 / arm, 0};
    return Scene{plane.setup, 0.02};
  };
  const auto rolling_on_each_other = [] {
    // Gears of unequal size that meet: no slip at the touch, then the overlap and the direction change.
    ClusterSetup setup = with_law(Linear(1000, 0), Friction(5, 5, 0, 0));
    setup.spheres.push_back({r, density, {}, {}, {0, 0, 30}, 0});
    const double small = 0.6 * r, speed = 0.3;
    const Vec3 along{0, r * 30 + small * 30, 0};
    setup.spheres.push_back({small, density, {r + small + 1e-9, 0, 0}, along + Vec3{-speed, 0, 0}, {0, 0, 30}, 0});
    return Scene{setup, 0.004};
  };
  const auto slip_left = [](const Scene& scene, int steps) {
    const auto& spheres = scene.setup.spheres;
    const bool wall = spheres.size() == 1;
    Cluster cluster(scene.setup, {.step = scene.duration / steps});
    double worst = 0;
    int looked_at = 0;
    for (int n = 0; n < steps; ++n) {
      cluster.step();
      const ContactGeometry g =
          wall ? sphere_wall(cluster.position(0), r, {}, {0, 0, 1})
               : sphere_sphere(cluster.position(0), spheres[0].radius, cluster.position(1), spheres[1].radius);
      if (g.overlap < 1e-4) continue;  // a collision's first and last touch is too light to hold anything
      const Vec3 v = cluster.velocity(0) - (wall ? Vec3{} : cluster.velocity(1));
      const Vec3 w = g.arm_i * cluster.spin(0) + (wall ? Vec3{} : g.arm_j * cluster.spin(1));
      worst = std::max(worst, norm(tangential(v, g.normal) + cross(w, g.normal)));
      ++looked_at;
    }
    REQUIRE(looked_at > steps / 2);
    return worst;
  };
  for (const Scene& scene : {bouncing_on_a_wall(), rolling_on_each_other()}) {
    const double coarse = slip_left(scene, 200), fine = slip_left(scene, 800);
    CAPTURE(scene.setup.spheres.size(), coarse, fine);
    CHECK(std::log2(coarse / fine) / 2 == Approx(2).margin(0.25));
  }
}

TEST_CASE("nothing chatters: a sphere that comes to rest has a slip that only falls, then is zero") {
  Incline plane(0, Friction(0.4, 0.2, 3, 1), 500);
  plane.setup.spheres[0].velocity = {0.3, 0, 0};
  plane.setup.spheres[0].spin = {5, -3, 20};
  double last = 1e300, last_energy = 1e300;
  Cluster cluster(plane.setup, {.step = 2e-4});
  for (int n = 0; n < 20000; ++n) {
    cluster.step();
    const Sphere& s = plane.setup.spheres[0];
    const ContactGeometry c = sphere_wall(cluster.position(0), r, {}, {0, 0, 1});
    const Vec3 slip = tangential(cluster.velocity(0), c.normal) + cross(c.arm_i * cluster.spin(0), c.normal);
    REQUIRE(norm(slip) <= last + 1e-14);
    last = norm(slip);
    const double energy = cluster.energy().kinetic / s.mass();
    REQUIRE(energy <= last_energy + 1e-15);
    last_energy = energy;
  }
  CHECK(last < 1e-14);
  CHECK(norm(cluster.velocity(0)) < 1e-13);
  CHECK(norm(cluster.spin(0)) < 1e-11);
}

TEST_CASE("an oblique impact tends to the rigid sphere's sliding and sticking rebound") {
  // Rigid: normal impulse (1+e) m v_n; tangential μ of it while sliding lasts, else what ends the slip, (2/7) m u.
  const auto rebound = [](double vt, double mu, double stiffness) {
    ClusterSetup setup = with_law(Linear(stiffness, 0), Friction(mu, mu, 0, 0));
    setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
    Sphere s{r, density, {0, 0, r + 1e-7}, {vt, 0, -1}, {}, 0};
    setup.spheres.push_back(s);
    const double tcol = std::numbers::pi * std::sqrt(s.mass() / stiffness);
    Cluster cluster(setup, {.step = tcol / 300});
    REQUIRE(cluster.advance(500));
    REQUIRE(cluster.contacts().empty());
    CHECK(cluster.velocity(0).z == Approx(1).epsilon(2e-4));
    return std::pair(cluster.velocity(0).x, cluster.spin(0).y);
  };
  const double hard = 1e10;  // overlap/r about 1e-4
  const auto [v_slide, w_slide] = rebound(2.0, 0.1, hard);
  CHECK(v_slide == Approx(2.0 - 0.1 * 2).epsilon(1e-4));
  CHECK(w_slide == Approx(2.5 * 0.1 * 2 / r).epsilon(2e-3));
  const auto [v_stick, w_stick] = rebound(0.5, 0.5, hard);
  CHECK(v_stick == Approx(5.0 / 7 * 0.5).epsilon(1e-3));
  CHECK(w_stick * r == Approx(5.0 / 7 * 0.5).epsilon(1e-3));
}

TEST_CASE(
    "where friction is redundant, steps that do not settle are counted, and their velocities are good all the same") {
  // Four spheres in a square tube that squeezes them from four sides: 20 contacts, 60 components of force for 24
  // degrees of freedom.
  ClusterSetup setup = with_law(Linear(1e5, 10), Friction(0.1, 0.1, 0, 1));
  setup.gravity = {1, 0.5, -g};
  const double squeezed = r * (1 - 5e-5);
  for (const Wall& wall : box_walls({0, 0, 0}, {2 * squeezed, 2 * squeezed, 1})) setup.walls.push_back(wall);
  for (int i = 0; i < 4; ++i)
    setup.spheres.push_back({r, density, {squeezed, squeezed, squeezed * (2 * i + 1)}, {}, {}, 0});
  const double step = stiffest_contact(setup).tcol / 100;
  Cluster usual(setup, {.step = step}), patient(setup, {.step = step, .max_sweeps = 2000}),
      hasty(setup, {.step = step, .max_sweeps = 2});
  for (Cluster* c : {&usual, &patient, &hasty}) REQUIRE(c->advance(5));
  CHECK(usual.contacts().size() == 20);
  CHECK(hasty.state().unconverged == 5);
  CHECK(hasty.state().worst_change > 1e-6);
  CHECK(usual.state().unconverged > 0);
  Cluster resumed(setup, {.step = step});
  resumed.restore(usual.state());
  REQUIRE(usual.advance(3));
  REQUIRE(resumed.advance(3));
  CHECK(resumed.state().unconverged == usual.state().unconverged);
  CHECK(resumed.state().worst_change == usual.state().worst_change);
  REQUIRE(patient.advance(3));
  double fastest = 0, apart = 0;
  for (std::size_t i = 0; i < usual.size(); ++i) {
    fastest = std::max(fastest, norm(patient.velocity(i)));
    apart = std::max(apart, norm(patient.velocity(i) - usual.velocity(i)));
    CHECK(usual.velocity(i) == resumed.velocity(i));
  }
  // Impulses that still changed by w of the greatest one leave at most a few w of it to a sphere's velocity.
  const double greatest = [&] {
    double most = 0;
    for (const ContactState& c : patient.contacts()) most = std::max(most, c.normal_impulse);
    return most;
  }();
  CHECK(apart < 20 * usual.state().worst_change * greatest / setup.spheres[0].mass());
  CHECK(apart < 1e-4 * fastest);
}

TEST_CASE("sweeps over contacts end where they are as near as the tolerance says") {
  // A sphere that spins in a corner of two walls that it sticks to. In the plane of the spin friction on one wall turns
  // it against the other: (5/2)/m beside the (7/2)/m that a contact has of itself. A sweep thus leaves (5/7)² = 0.51 of
  // the error, and one that changed impulses by tol J leaves 0.51/0.49 tol J, J the greatest impulse; two such impulses
  // change the spin by (5/2)/m each.
  ClusterSetup setup = with_law(Linear(2e4, 0), Friction(5, 5, 0, 0));
  setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
  setup.walls.push_back({{0, 0, 0}, {1, 0, 0}});
  setup.spheres.push_back({r, density, {0.999 * r, 0, 0.999 * r}, {}, {0, 0.15, 0}, 0});  // slower than they stick at
  const double m = setup.spheres[0].mass(), tolerance = 1e-5;
  Cluster loose(setup, {.step = 1e-5, .solver_tolerance = tolerance});
  Cluster tight(setup, {.step = 1e-5, .solver_tolerance = 1e-14});
  loose.step(), tight.step();
  REQUIRE(loose.state().unconverged == 0);
  REQUIRE(loose.contacts().size() == 2);
  double J = 0;
  for (const ContactState& c : tight.contacts()) J = std::max(J, c.normal_impulse);
  const double bound = 2 * 2.5 / m * (0.51 / 0.49) * tolerance * J;
  CHECK(r * norm(loose.spin(0) - tight.spin(0)) <= bound);
  CHECK(norm(loose.velocity(0) - tight.velocity(0)) <= bound);
}
