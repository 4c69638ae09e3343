#include <catch2/catch.hpp>
#include <ricochet/contact/friction.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace ricochet;
using std::numbers::pi;

namespace {

// F and 𝒯 from their definition: the mean over the unit disc of the direction of u + Ω×ρ, its component along the
// sliding and its moment. With R² = λ² + 1 − 2λ r sin φ … the integrand in polar coordinates around the point of rest
// is smooth; around the disc's centre it has a kink when that point lies inside. So integrate around the point of rest
// at distance λ from the centre: the local velocity there is Ω×distance, hence its direction is the angle alone, and
// the radial integrals are elementary: F = (1/π)∫∫ sin-part, over chords that the disc cuts.
DiscFriction disc_quadrature(double lambda) {
  // Point of rest at (−λ, 0); at (s, φ) from it the direction of motion is (−sin φ, cos φ), sliding is along y.
  // Chord: s between the roots of s² − 2λ s cos φ + λ² − 1 = 0.
  const auto integrand = [&](double angle) -> std::pair<double, double> {
    const double c = lambda * std::cos(angle),
                 root = std::sqrt(std::max(0.0, 1 - std::pow(lambda * std::sin(angle), 2)));
    const double far = c + root, near = lambda > 1 ? c - root : 0.0;
    const double area = (far * far - near * near) / 2, moment = (far * far * far - near * near * near) / 3;
    // Moment about the disc's centre: (ρ × direction)_z = s − λ cos φ.
    return {std::cos(angle) * area, moment - c * area};
  };
  // λ ≤ 1: whole turn, periodic and smooth (trapezoidal rule). λ > 1: |sin φ| ≤ 1/λ, with sin φ = sin θ/λ smooth.
  const int n = 4000;
  double force = 0, torque = 0;
  for (int k = 0; k < n; ++k) {
    const double theta = 2 * pi * (k + 0.5) / n;
    if (lambda <= 1) {
      const auto [f, t] = integrand(theta);
      force += f, torque += t;
    } else {
      const double angle = std::asin(std::sin(theta) / lambda);
      const double jacobian = std::cos(theta) / (lambda * std::cos(angle));
      const auto [f, t] = integrand(angle);
      force += 0.5 * f * std::abs(jacobian), torque += 0.5 * t * std::abs(jacobian);
    }
  }
  return {force * 2 * pi / n / pi, torque * 2 * pi / n / pi};
}

}  // namespace

TEST_CASE("friction falls from static to dynamic as Eq. (35) says") {
  const Friction friction(0.6, 0.2, 3);
  CHECK(friction.coefficient(0) == Approx(0.6).epsilon(1e-15));
  CHECK(friction.coefficient(0.5) == Approx(0.2 + 0.4 * 0.22313016014842982).epsilon(1e-15));  // e^-1.5
  CHECK(friction.coefficient(100) == Approx(0.2).epsilon(1e-15));
  CHECK_THROWS_AS(Friction(std::numeric_limits<double>::infinity(), 0.3, 0), std::invalid_argument);
}

TEST_CASE("F and torque of the sliding, spinning disc equal the disc integral") {
  for (double lambda : {1e-3, 0.1, 0.3, 0.4999, 0.5, 0.7, 0.9, 1.1, 1.5, 1.9999, 2.0, 2.0001, 3.0, 10.0, 50.0}) {
    const DiscFriction ours = disc_friction(lambda), integral = disc_quadrature(lambda);
    CAPTURE(lambda);
    CHECK(std::abs(ours.force - integral.force) < 1e-12);
    CHECK(std::abs(ours.torque - integral.torque) < 1e-12);
  }
}

TEST_CASE("F and torque have the limits of pure spinning, pure sliding and the kink between") {
  CHECK(disc_friction(0).force == 0);
  CHECK(disc_friction(0).torque == Approx(2.0 / 3).epsilon(1e-15));
  CHECK(disc_friction(1e-9).force == Approx(1e-9).epsilon(1e-14));     // F → λ
  CHECK(disc_friction(1e9).torque == Approx(0.25e-9).epsilon(1e-14));  // 𝒯 → 1/(4λ)
  CHECK(disc_friction(std::numeric_limits<double>::infinity()).force == 1);
  CHECK(disc_friction(std::numeric_limits<double>::infinity()).torque == 0);
  CHECK(disc_friction(1).force == Approx(8 / (3 * pi)).epsilon(1e-15));
  CHECK(disc_friction(1).torque == Approx(8 / (9 * pi)).epsilon(1e-15));
  for (double seam : {0.5, 1.0, 2.0}) {
    const double below = std::nextafter(seam, 0), above = std::nextafter(seam, 3);
    CHECK(disc_friction(below).force == Approx(disc_friction(above).force).epsilon(2e-14));
    CHECK(disc_friction(below).torque == Approx(disc_friction(above).torque).epsilon(2e-14));
  }
}

namespace {

// A body on a plane pressed with the force `normal`, moved by friction alone over one step.
struct Slider {
  FrictionProblem problem;
  SlipMotion motion;
  FrictionSolution last;

  void step(const Friction& friction, double normal, double dt) {
    problem.normal_impulse = normal * dt;
    problem.before = problem.free = motion;
    last = friction_impulse(friction, problem, {});
    const SlipMobility& m = problem.mobility;
    motion.slip += m.slip * last.impulse.sliding + m.cross * last.impulse.rolling;
    motion.roll += m.cross * last.impulse.sliding + m.roll * last.impulse.rolling;
    motion.spin += m.roll * last.impulse.torsion;
  }
};

}  // namespace

TEST_CASE("pure spin slows at the rate of the full torque") {
  // dΩ/dt = −(2/3) μ a N/J, exactly linear in time until it stops.
  const Friction friction(0.4, 0.4, 0, 1);
  Slider s;
  s.problem.contact_radius = 0.2;
  s.problem.mobility = {1.0, 0.0, 2.0};
  s.motion.spin = -5;
  for (int n = 0; n < 100; ++n) s.step(friction, 3, 0.01);
  CHECK(s.motion.spin == Approx(-5 + 2.0 / 3 * 0.4 * 0.2 * 3 * 2.0).epsilon(1e-12));
  CHECK(norm(s.motion.slip) == 0);
}

TEST_CASE("a slide ever so small against the spin dies as the power of the spin that the disc integrals give") {
  // To first order in λ = u/(aΩ) the direction of motion at (ρ, φ) has the sliding component λ sin²φ/ρ:
  // F = (1/π)∫∫ λ sin²φ dρ dφ = λ, and 𝒯 = (1/π)∫∫ ρ² dρ dφ = 2/3. With y = aΩ, α = μN/m, β = μN a²/J:
  // du/dt = −α u/y, dy/dt = −(2/3)β, hence u/u₀ = (y/y₀)^{3α/(2β)}.
  const Friction friction(0.5, 0.5, 0, 1);
  const double a = 0.2, alpha = 0.5 * 1.2, beta = 0.5 * a * a * 20, y0 = a * 4, u0 = 1e-16 * y0;
  const auto start = [&] {
    Slider s;
    s.problem.contact_radius = a;
    s.problem.mobility = {1.2, 0.0, 20.0};
    s.motion.spin = y0 / a;
    s.motion.slip = {0.6 * u0, -0.8 * u0, 0};
    return s;
  };
  Slider once = start();  // one midpoint step: u_m = u₀ − (α/2) u_m/y_m, y_m = y₀ − β/3
  once.step(friction, 1, 1);
  const double impulse = -0.5 * u0 / (y0 - beta / 3 + alpha / 2);
  CHECK(once.last.impulse.sliding.x == Approx(0.6 * impulse).epsilon(1e-14));
  CHECK(once.last.impulse.sliding.y == Approx(-0.8 * impulse).epsilon(1e-14));
  CHECK(once.last.impulse.torsion == Approx(-2.0 / 3 * 0.5 * a).epsilon(1e-14));

  const double exact = u0 * std::pow((y0 - 2.0 / 3 * beta) / y0, 1.5 * alpha / beta);
  const auto error = [&](int steps) {
    Slider s = start();
    for (int n = 0; n < steps; ++n) s.step(friction, 1, 1.0 / steps);
    return std::abs(norm(s.motion.slip) - exact);
  };
  CHECK(std::log2(error(32) / error(64)) == Approx(2).margin(0.1));
  CHECK(error(4096) < 1e-6 * exact);
}

TEST_CASE("a spin ever so small against the slide decays as the disc integrals give") {
  // To first order in 1/λ: 𝒯 = (1/π)∫∫ (ρ cos φ)²/λ ρ dρ dφ = 1/(4λ), F = 1. So dy/dt = −(β/4) y/u, du/dt = −α, and
  // y/y₀ = (u/u₀)^{β/(4α)}.
  const Friction friction(0.5, 0.5, 0, 1);
  const double a = 0.2, alpha = 0.5 * 1.2, beta = 0.5 * a * a * 20, u0 = 0.9, y0 = 1e-16 * u0;
  const auto start = [&] {
    Slider s;
    s.problem.contact_radius = a;
    s.problem.mobility = {1.2, 0.0, 20.0};
    s.motion.spin = -y0 / a;
    s.motion.slip = {0, u0, 0};
    return s;
  };
  Slider once = start();  // one midpoint step: y_m = y₀ − (β/2) y_m/(4u_m), u_m = u₀ − α/2
  once.step(friction, 1, 1);
  CHECK(once.last.impulse.sliding.y == Approx(-0.5).epsilon(1e-14));
  CHECK(once.last.impulse.torsion == Approx(0.5 * a * 0.25 * y0 / (u0 - alpha / 2 + beta / 8)).epsilon(1e-14));

  const double exact = y0 * std::pow((u0 - alpha) / u0, 0.25 * beta / alpha);
  const auto error = [&](int steps) {
    Slider s = start();
    for (int n = 0; n < steps; ++n) s.step(friction, 1, 1.0 / steps);
    return std::abs(-a * s.motion.spin - exact);
  };
  CHECK(std::log2(error(32) / error(64)) == Approx(2).margin(0.1));
  CHECK(error(4096) < 1e-6 * exact);
}

TEST_CASE("a disc ends sliding and spinning together, at the ratio of Farkas et al.") {
  // Uniform disc on its face: J = m a²/2. The ratio tends to the root of F/(λ𝒯) = m a²/J = 2, which is 0.653
  // (Phys. Rev. Lett. 90, 248302), from whichever side.
  const Friction friction(0.3, 0.3, 0, 1);
  for (double start : {0.1, 0.653, 5.0}) {
    Slider s;
    s.problem.contact_radius = 0.5;
    s.problem.mobility = {1.0, 0.0, 2 / (0.5 * 0.5)};
    s.motion.spin = 2;
    s.motion.slip = {start * 0.5 * 2, 0, 0};
    double ratio = 0, energy = 1e300;
    int steps = 0;
    while (!s.last.sticks && steps < 100000) {
      const double speed = std::max(norm(s.motion.slip), 0.5 * s.motion.spin);
      if (speed > 1e-12) ratio = norm(s.motion.slip) / (0.5 * s.motion.spin);
      const double now = dot(s.motion.slip, s.motion.slip) + s.motion.spin * s.motion.spin * 0.25 / 2;
      REQUIRE(now < energy);
      energy = now;
      s.step(friction, 1, std::max(0.02 * speed, 1e-13));  // the rest takes a time proportional to the speed
      ++steps;
    }
    CAPTURE(start, steps);
    CHECK(s.last.sticks);
    CHECK(norm(s.motion.slip) == 0);  // both ended, in the same step
    CHECK(s.motion.spin == 0);
    CHECK(ratio == Approx(0.653).margin(1e-3));
  }
}

TEST_CASE("coupled sliding and spinning converge at order 2 in the step") {
  const Friction friction(0.5, 0.3, 0.7, 1);
  const auto run = [&](int steps) {
    Slider s;
    s.problem.contact_radius = 0.5;
    s.problem.mobility = {1.0, 0.0, 6.0};
    s.motion.spin = 2;
    s.motion.slip = {0.6, 0.8, 0};
    for (int n = 0; n < steps; ++n) s.step(friction, 1, 1.0 / steps);
    return s.motion;
  };
  const double exact = run(4096).spin;
  const double e1 = std::abs(run(32).spin - exact), e2 = std::abs(run(64).spin - exact);
  CHECK(std::log2(e1 / e2) == Approx(2).margin(0.15));
}

TEST_CASE("a stuck contact stays stuck below the limit and slips above it") {
  const Friction friction(0.5, 0.5, 0, 0);
  FrictionProblem p;
  p.normal_impulse = 1;
  p.contact_radius = 0.01;
  p.mobility = {3.5, 2.5, 2.5};
  p.free.slip = {3.5 * 0.499, 0, 0};
  const FrictionSolution holds = friction_impulse(friction, p, {});
  CHECK(holds.sticks);
  CHECK(holds.impulse.sliding.x == Approx(-0.499).epsilon(1e-15));
  p.free.slip = {3.5 * 0.501, 0, 0};
  const FrictionSolution slips = friction_impulse(friction, p, {});
  CHECK_FALSE(slips.sticks);
  CHECK(slips.impulse.sliding.x == Approx(-0.5).epsilon(1e-15));
}

TEST_CASE("friction rejects coefficients that no surface has") {
  CHECK_THROWS_WITH(Friction(-0.1, 0, 0), "mu_static = -0.1: must be finite and >= 0");
  CHECK_THROWS_WITH(Friction(0.3, 0.4, 0), "mu_dynamic = 0.4: must be at most mu_static");
  CHECK_THROWS_AS(Friction(0.3, 0.3, std::nan("")), std::invalid_argument);
}
