// Contacts with springs in the tangent plane.
#include <catch2/catch.hpp>
#include <ricochet/collision/oblique.hpp>

#include "scenes.hpp"

#include <array>
#include <numbers>

using namespace ricochet;
using namespace ricochet::test;

namespace {

// MFiX's DEM05: 5 mm, 4000 kg/m³, 3.9 m/s on a wall, undamped linear springs.
constexpr double r = 2.5e-3, density = 4000, k_n = 1.72e7, k_t = 1.48e7, speed = 3.9;
const double mass = Sphere{r, density}.mass(), tcol = std::numbers::pi * std::sqrt(mass / k_n);

constexpr double gap = 2.37e-6;  // some steps long, so that touches fall anywhere in a step

struct Rebound {
  double along, away;  // velocities [m/s]
  double spin;
  double energy_drift;
};

double distance(const Rebound& a, const Rebound& b) {
  return (std::abs(a.along - b.along) + std::abs(a.away - b.away) + r * std::abs(a.spin - b.spin)) / speed;
}

ClusterSetup oblique(double degrees, double mu, const TangentialLaw& tangential) {
  const double angle = degrees * std::numbers::pi / 180;
  ClusterSetup setup = with_law(Linear(k_n, 0), Friction(mu, mu, 0));
  setup.interactions.at({0, 0}).tangential = tangential;
  setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
  setup.spheres.push_back({r, density, {0, 0, r + gap}, {speed * std::sin(angle), 0, -speed * std::cos(angle)}});
  return setup;
}

Rebound rebound(const ClusterSetup& setup, double step) {
  Cluster cluster(setup, {.step = step});
  const double start = cluster.energy().total();
  double drift = 0;
  while (cluster.take_finished().empty()) {
    cluster.step();
    drift = std::max(drift, std::abs(cluster.energy().total() / start - 1));
  }
  return {cluster.velocity(0).x, cluster.velocity(0).z, cluster.spin(0).y, drift};
}

// The same by itself: one angle of spin, two coordinates, the paper's arm r − ζ/2, n steps a collision. The slider lies
// behind spring and dashpot: c ξ' = T − k ξ where it slides.
Rebound by_hand(double degrees, double mu, double k, double c, int n) {
  const double angle = degrees * std::numbers::pi / 180, h = tcol / n, inertia = 0.4 * mass * r * r;
  double vx = speed * std::sin(angle), vz = -speed * std::cos(angle), spin = 0, overlap = 0, xi = 0;
  while (overlap >= 0) {
    overlap -= 0.5 * h * vz;
    const double arm = r - 0.5 * overlap, normal = k_n * std::max(0.0, overlap), slip = vx - arm * spin;
    const double held = xi + h * slip, wanted = k * held + c * slip;
    const double load = std::copysign(std::min(std::abs(wanted), mu * normal), wanted);
    xi = load == wanted ? held : (c / h * xi + load) / (k + c / h);
    vx -= h * load / mass, vz += h * normal / mass, spin += h * arm * load / inertia;
    overlap -= 0.5 * h * vz;
  }
  return {vx, vz, spin, 0};
}

// Errors at tcol/step = 50, 100, 200, 400, means over places of the touch in a step, and their order.
struct Errors {
  std::array<double, 4> mean{};
  double order() const { return std::log2(mean[0] / mean[3]) / 3; }
};

template <class Measure>
Errors errors(const Measure& error_at) {
  constexpr int places = 24;
  Errors errors;
  for (std::size_t level = 0; level < errors.mean.size(); ++level)
    for (int place = 0; place < places; ++place) {
      const double finer = 1 + 0.5 * place / places;
      errors.mean[level] += finer * finer * error_at(tcol / ((50 << level) * finer)) / places;
    }
  CAPTURE(errors.mean[0], errors.mean[1], errors.mean[2], errors.mean[3]);
  return errors;
}

// Two spheres, or one on a wall, that meet while they slide across, roll and spin.
ClusterSetup skew(bool wall, double mu, const TangentialLaw& law, const Rolling& rolling = {}) {
  ClusterSetup setup = with_law(Linear(k_n, 0), Friction(mu, mu, 0));
  auto& interaction = setup.interactions.at({0, 0});
  interaction.tangential = law, interaction.rolling = rolling;
  if (wall) {
    setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
    setup.spheres.push_back({r, density, {0, 0, r + gap}, {0.8, 0, -3}, {300, 100, 500}});
  } else {
    setup.spheres.push_back({r, density, {0, 0, 0}, {1.0, 0.3, 2.0}, {300, -200, 500}});
    setup.spheres.push_back({0.8 * r, density, {0, 0, 1.8 * r + gap}, {0, 0, -1.5}, {100, 150, -200}});
  }
  return setup;
}

struct Motion {
  Vec3 velocity, spin;
};

Motion after_meeting(const ClusterSetup& setup, double step) {
  Cluster cluster(setup, {.step = step});
  while (cluster.take_finished().empty()) cluster.step();
  return {cluster.velocity(0), cluster.spin(0)};
}

}  // namespace

TEST_CASE("an oblique impact on springs is met at second order, sticking, sliding and both in turn") {
  // 5° and 40° at mu = 0.092 stick for a while and slide throughout; mu = 5 hardly ever slides.
  // A dashpot, with which β₀ is 0.66 were nothing to slide, pulls with c u from the touch on, until μ R has grown to
  // that after c u/(μ k v): t_col/50 at 20° and μ = 0.5, what no mesh here resolves at more friction or less angle.
  const auto [degrees, mu, c] = GENERATE(table<double, double, double>({{5, 0.092, 0},
                                                                        {10, 0.092, 0},
                                                                        {20, 0.092, 0},
                                                                        {40, 0.092, 0},
                                                                        {20, 0.5, 0},
                                                                        {40, 0.5, 0},
                                                                        {5, 5, 0},
                                                                        {40, 5, 0},
                                                                        {5, 0.092, 4},
                                                                        {10, 0.092, 4},
                                                                        {20, 0.092, 4},
                                                                        {40, 0.092, 4},
                                                                        {20, 0.5, 4},
                                                                        {40, 0.5, 4}}));
  CAPTURE(degrees, mu, c);
  const Rebound exact = by_hand(degrees, mu, k_t, c, 1'000'000);
  const ClusterSetup setup = oblique(degrees, mu, LinearTangential(k_t, c));
  const Errors e = errors([&](double step) { return distance(rebound(setup, step), exact); });
  const Errors drift = errors([&](double step) { return rebound(setup, step).energy_drift; });
  CHECK(e.order() > 1.75);
  CHECK(e.order() < 2.4);
  CHECK(drift.order() > 1.8);
  CHECK(drift.order() < 2.2);
  CHECK(e.mean[3] < 3e-4);
}

// Springs against turning, however weak, are stepped one by one.
TEST_CASE("contacts stepped side by side move as those stepped one by one do") {
  const LinearTangential law(k_t, 4);
  const MindlinTangential growing(4e9, 4);
  ClusterSetup drum = skew(true, 0.092, law);
  drum.walls = {{.inward = {0, 1, 0}, .form = surface::Cylinder{0.01}}};
  drum.spheres[0].position = {0, 0, -0.01 + r + gap};
  for (const ClusterSetup& setup : {skew(true, 0.092, law), skew(true, 0.5, law), skew(false, 0.092, law), drum,
                                    skew(true, 0.092, growing), skew(false, 0.3, growing)}) {
    ClusterSetup one_by_one = setup;
    one_by_one.interactions.at({0, 0}).torsion = {Torsion::Limit::separate, {1e-30, 0}};
    const Motion a = after_meeting(setup, tcol / 50), b = after_meeting(one_by_one, tcol / 50);
    CHECK(norm(a.velocity - b.velocity) < 1e-12 * speed);
    CHECK(r * norm(a.spin - b.spin) < 1e-12 * speed);
  }
}

TEST_CASE("a sphere that meets a wall tends to the exact oblique collision with the same contact point") {
  const double stiff = 0.3 * k_t * r * r;
  struct Case {
    TangentialContact contact;
    double order;
  };
  const auto sprung = [](const TangentialLaw& law, double mu, const Torsion& torsion, const Rolling& rolling) {
    return TangentialContact{law, Friction(mu, mu, 0), torsion, rolling};
  };
  const Torsion twist{Torsion::Limit::separate, {stiff, 1e-6 * stiff}};
  const auto [contact, order] = GENERATE_COPY(
      Case{sprung(LinearTangential(k_t), 0.1, {}, {}), 2}, Case{sprung(LinearTangential(k_t, 4), 0.3, twist, {}), 2},
      Case{sprung(LinearTangential(k_t), 0.2, twist, {0.05, {stiff, 1e-6 * stiff}}), 2},
      Case{sprung(LinearTangential(k_t), 0.2, {}, {1, {stiff, 0}}), 2},
      Case{sprung(MindlinTangential(4e9), 0.3, {}, {}), 1.5}, Case{sprung(MindlinTangential(4e9, 4), 0.3, {}, {}), 1.5},
      Case{sprung(MindlinTangential(4e9, 40), 0.1, twist, {}), 1.5});
  CAPTURE(std::string(name(contact.law)), contact.friction.mu_static(), contact.rolling.mu);
  ClusterSetup setup = skew(true, contact.friction.mu_static(), contact.law, contact.rolling);
  setup.interactions.at({0, 0}).torsion = contact.torsion;
  const Sphere& s = setup.spheres[0];
  const ObliqueImpact impact{{0, 0, -1}, {s.mass(), s.radius, s.velocity, s.spin}};
  const ObliqueCollision exact = collide(Linear(k_n, 0), contact, impact, {.arm = ContactArm::contact_point});
  REQUIRE(exact.separated());
  const Errors e = errors([&](double step) {
    const Motion m = after_meeting(setup, step);
    return (norm(m.velocity - exact.velocity_i) + r * norm(m.spin - exact.spin_i)) / speed;
  });
  CAPTURE(e.order());
  CHECK(e.order() > order - 0.25);
  CHECK(e.order() < 2.3);
  const Motion fine = after_meeting(setup, tcol / 50'000);
  CHECK((norm(fine.velocity - exact.velocity_i) + r * norm(fine.spin - exact.spin_i)) / speed < 1e-6);
}

TEST_CASE("a slide that turns is met at second order") {
  // Spins across and rolling resistance turn the slip by up to a radian and more.
  const bool wall = GENERATE(true, false);
  const double c = GENERATE(0.0, 4.0);
  const double stiff = 0.3 * k_t * r * r;
  const Rolling rolling = GENERATE_COPY(Rolling{}, Rolling{1, {stiff, 0}}, Rolling{0.05, {stiff, 0}});
  CAPTURE(wall, c, rolling.mu);
  const ClusterSetup setup = skew(wall, 0.1, LinearTangential(k_t, c), rolling);
  const Motion exact = after_meeting(setup, tcol / 20'000);
  const Errors e = errors([&](double step) {
    const Motion m = after_meeting(setup, step);
    return norm(m.velocity - exact.velocity) + r * norm(m.spin - exact.spin);
  });
  CHECK(e.order() > 1.7);
  CHECK(e.order() < 2.4);
}

TEST_CASE("springs turn with two spheres that turn about each other, and keep their energy") {
  // Soft: the normal turns by a third of a radian while they stick. What a spring lost by not turning along, or won,
  // would stand in no account.
  constexpr double soft = 1000, radius = 0.01;
  const double c = GENERATE(0.0, 1.0);
  CAPTURE(c);
  ClusterSetup setup = with_law(Linear(soft, 0), Friction(1e6, 1e6, 0));
  setup.interactions.at({0, 0}).tangential = LinearTangential(0.8 * soft, c);
  setup.spheres.push_back({radius, 2000, {0, 0, 0}, {0.5, 1, 0}, {0, 20, 30}});
  setup.spheres.push_back({0.8 * radius, 2000, {1.8 * radius + 1e-6, 0, 0}, {}, {10, -20, 0}});
  const double lasts = std::numbers::pi * std::sqrt(setup.spheres[1].mass() / soft);
  const auto drift = [&](int steps) {
    Cluster cluster(setup, {.step = lasts / steps});
    const double start = cluster.energy().total();
    double worst = 0;
    for (int n = 0; n < steps / 2; ++n) {
      cluster.step();
      worst = std::max(worst, std::abs(cluster.energy().total() / start - 1));
    }
    REQUIRE(cluster.contacts().size() == 1);
    return worst;
  };
  const double coarse = drift(200), fine = drift(1600);
  CAPTURE(coarse, fine);
  CHECK(std::log2(coarse / fine) / 3 == Approx(2).margin(0.2));
  CHECK(fine < 1e-4);
}

TEST_CASE("no impact on springs ends with more energy than it began with") {
  std::mt19937_64 random(14);
  const auto draw = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  double most = 0;
  for (int n = 0; n < 400; ++n) {
    const double mu = std::exp(draw(-4, 2)), k = k_t * std::exp(draw(-3, 0.5)), c = n % 3 == 0 ? draw(0, 8) : 0;
    const double stiff = std::exp(draw(-3, 0)) * k * r * r, drag = n % 5 == 0 ? stiff * draw(0, 1e-6) : 0;
    ClusterSetup setup =
        with_law(n % 4 == 0 ? NormalLaw(Tsuji(4e9, 0)) : NormalLaw(Linear(k_n, 0)), Friction(mu, mu, 0));
    auto& interaction = setup.interactions.at({0, 0});
    if (n % 2 == 0)
      interaction.tangential = LinearTangential(k, c);
    else
      interaction.tangential = MindlinTangential(k / 4e-3, c);
    const auto limit = std::array{Torsion::Limit::none, Torsion::Limit::separate, Torsion::Limit::disc}[n % 3];
    interaction.torsion = {limit, {stiff, drag}};
    if (n % 7 < 4) interaction.rolling = {std::exp(draw(-6, 0)), {stiff, drag}};
    const auto spin = [&] { return Vec3{draw(-800, 800), draw(-800, 800), draw(-800, 800)}; };
    setup.spheres.push_back({r, density, {0, 0, r + gap}, {draw(-4, 4), draw(-4, 4), -draw(0.5, 4)}, spin()});
    if (n % 2 == 0)
      setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
    else
      setup.spheres.push_back({draw(0.3, 2) * r, density, {0, 0, 0}, {}, spin()});
    if (n % 2 == 1) setup.spheres[1].position.z = -setup.spheres[1].radius;
    Cluster cluster(setup, {.step = tcol / 400});
    const double before = cluster.energy().kinetic;
    while (cluster.take_finished().empty()) cluster.step();
    most = std::max(most, cluster.energy().kinetic / before - 1);
  }
  // What an undamped swing keeps is off by some (ω h)²/8, ω up to four times π/t_col: 1.2e-4.
  CHECK(most < 2e-4);
}

TEST_CASE("beside rigid friction nothing changes where springs grow stiff") {
  // Sticking: 5/7 of the tangential speed on average of a swing that ends anywhere; sliding throughout: μ(1+e)v_n.
  const double angle = 60 * std::numbers::pi / 180, mu = 0.1;
  const ClusterSetup setup = oblique(60, mu, LinearTangential(100 * k_t));
  const double vt = speed * std::sin(angle), vn = speed * std::cos(angle);
  CHECK(rebound(setup, tcol / 4000).along == Approx(vt - 2 * mu * vn).epsilon(1e-4));
}

TEST_CASE("a contact that sticks for the whole of its collision swings with (2/7) m") {
  // No limit: ξ'' = −k_t ξ/m_t for t_col, whatever the normal force. β = −cos(ω t_col) − …, exact for an arm of r.
  const double mt = 2.0 / 7 * mass, beta0 = 0.7;
  const double swing = std::acos(-beta0) / tcol, kt = mt * swing * swing;
  ClusterSetup setup = oblique(20, 1e6, LinearTangential(kt));
  const Rebound got = rebound(setup, tcol / 1000);
  const double vt = setup.spheres[0].velocity.x, u = got.along - r * got.spin;
  CHECK(-u / vt == Approx(beta0).epsilon(4e-3));  // the arm is r less half the overlap, 0.3 % of r at most
}

namespace {

constexpr double g = 9.81;

/// A sphere at rest on an incline, whose spring bears its weight.
ClusterSetup incline(double slope, double mu, double mu_rolling) {
  constexpr double radius = 0.01, rho = 2000, k = 1e5, kt = 8e4, kr = 0.5 * kt * radius * radius;
  const Sphere sphere{radius, rho};
  const double m = sphere.mass(), damping = 0.4 * std::sqrt(m * k);
  ClusterSetup setup = with_law(Linear(k, damping), Friction(mu, mu, 0));
  auto& interaction = setup.interactions.at({0, 0});
  interaction.tangential = LinearTangential(kt, damping);
  interaction.rolling = {mu_rolling, {kr, 0.3 * std::sqrt(kr * sphere.inertia())}};
  setup.gravity = g * Vec3{std::sin(slope), 0, -std::cos(slope)};
  setup.walls.push_back({{0, 0, 0}, {0, 0, 1}});
  setup.spheres.push_back({radius, rho, {0, 0, radius - m * g * std::cos(slope) / k}});
  return setup;
}

}  // namespace

TEST_CASE("on a slope that friction and rolling resistance hold, a sphere comes to rest and does not creep") {
  const ClusterSetup setup = incline(std::atan(0.3), 0.5, 0.4);
  const double radius = setup.spheres[0].radius;
  Cluster cluster(setup, {.step = 2e-5});
  REQUIRE(cluster.advance(50'000));  // the springs take the load up and their dashpots end the swing
  const Vec3 there = cluster.position(0);
  const double energy = cluster.energy().mechanical();
  REQUIRE(cluster.advance(50'000));
  CHECK(norm(cluster.position(0) - there) < 1e-9 * radius);  // within a second
  CHECK(norm(cluster.velocity(0)) < 1e-9 * radius);
  CHECK(radius * norm(cluster.spin(0)) < 1e-9 * radius);
  CHECK(cluster.energy().mechanical() <= energy + 1e-15);
  CHECK(cluster.contacts()[0].record.phase_begin[std::size_t(Phase::sliding)] == Encounter::never);
}

TEST_CASE("down a slope a sphere on springs rolls with (5/7) g sin, slides with g (sin - mu cos)") {
  const double mu = 0.2;
  // From when the springs have settled on: the change of velocity over half a second.
  const auto acceleration = [&](double slope) {
    Cluster cluster(incline(slope, mu, 0), {.step = 2e-5});
    REQUIRE(cluster.advance(25'000));
    const double before = cluster.velocity(0).x;
    REQUIRE(cluster.advance(25'000));
    return (cluster.velocity(0).x - before) / 0.5;
  };
  const double gentle = std::atan(3.4 * mu), steep = std::atan(3.6 * mu);  // rolling needs tan ≤ 3.5 μ
  const double sag = Sphere{0.01, 2000}.mass() * g * std::cos(gentle) / 1e5, arm = 1 - 0.5 * sag / 0.01;
  CHECK(acceleration(gentle) == Approx(g * std::sin(gentle) / (1 + 0.4 / (arm * arm))).epsilon(1e-9));
  CHECK(acceleration(steep) == Approx(g * (std::sin(steep) - mu * std::cos(steep))).epsilon(1e-9));
}

TEST_CASE("a top on a torsion spring swings with k/J until its limit is reached, then slows by it") {
  // At rest on the floor but for its spin: J Ω' = −k φ while |k φ| < (2/3) μ a N, then Ω' = −(2/3) μ a N/J.
  const double spin = GENERATE(0.05, 50.0), stiffness = 2e-3;
  ClusterSetup setup = incline(0, 0.5, 0);
  setup.interactions.at({0, 0}).torsion = {Torsion::Limit::separate, {stiffness, 0}};
  setup.spheres[0].spin = {0, 0, spin};
  const Sphere& s = setup.spheres[0];
  const double sag = s.mass() * g / 1e5, a = std::sqrt(sag * (2 * s.radius - sag));
  const double limit = 2.0 / 3 * 0.5 * a * s.mass() * g, swing = std::sqrt(stiffness / s.inertia());
  const bool slides = spin * std::sqrt(stiffness * s.inertia()) > limit;
  CAPTURE(spin, slides);
  const double step = 1e-6, time = 2e-3;
  Cluster cluster(setup, {.step = step});
  REQUIRE(cluster.advance(static_cast<std::uint64_t>(time / step + 0.5)));
  if (!slides)
    CHECK(cluster.spin(0).z == Approx(spin * std::cos(swing * time)).epsilon(1e-6));
  else  // the spring takes up k φ = limit in φ/Ω, half of whose impulse is missing
    CHECK(cluster.spin(0).z ==
          Approx(spin - limit / s.inertia() * (time - 0.5 * limit / stiffness / spin)).epsilon(1e-6));
}

TEST_CASE("a limit without a spring is named, a stiff spring asks for a shorter step") {
  ClusterSetup setup = oblique(20, 0.1, LinearTangential(k_t));
  setup.interactions.at({0, 0}).rolling.mu = 0.1;
  CHECK_THROWS_WITH(Cluster(setup, {.step = 1e-7}), "rolling stiffness = 0: must be > 0 where rolling has a limit");
  const double plain = stiffest_contact(oblique(20, 0.1, RigidTangential{})).tcol;
  CHECK(plain == Approx(tcol));
  CHECK(stiffest_contact(oblique(20, 0.1, LinearTangential(k_t))).tcol ==
        Approx(tcol * std::sqrt(2.0 / 7 * k_n / k_t)));
}

TEST_CASE("a spring whose limit is 0 holds nothing: all is as without friction") {
  const auto after = [](const TangentialLaw& law) {
    Cluster cluster(oblique(40, 0, law), {.step = tcol / 100});
    double strained = 0;
    while (cluster.velocity(0).z <= 0) {
      cluster.step();
      strained = std::max(strained, cluster.energy().strained);
    }
    CHECK(strained == 0);
    CHECK(cluster.energy().lost_friction == 0);
    return std::pair(cluster.energy().total(), cluster.velocity(0));
  };
  CHECK(after(LinearTangential(k_t, 1)) == after(RigidTangential{}));
}
