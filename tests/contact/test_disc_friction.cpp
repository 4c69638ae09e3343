#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>
#include <ricochet/contact/friction.hpp>

#include <cmath>
#include <limits>
#include <random>

using namespace ricochet;

namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

struct ExactDisc {
  Exact force, torque;
};

// The closed forms of (36), (37), (44) in 50 digits, which leave 25 of them for λ in 10⁻⁶ … 10⁶.
ExactDisc closed_forms(double at) {
  const Exact lambda = at, square = lambda * lambda, pi = boost::math::constants::pi<Exact>();
  const Exact modulus = lambda > 1 ? Exact(1 / lambda) : lambda;
  const Exact k = boost::math::ellint_1(modulus), e = boost::math::ellint_2(modulus);
  if (lambda > 1)
    return {4 * ((square + 1) * e - (square - 1) * k) / (3 * pi),
            4 * lambda * ((4 - 2 * square) * e + (2 * square - 5 + 3 / square) * k) / (9 * pi)};
  return {4 * ((square + 1) * e + (square - 1) * k) / (3 * pi * lambda),
          4 * ((4 - 2 * square) * e + (square - 1) * k) / (9 * pi)};
}

void check(double lambda) {
  const DiscFriction ours = disc_friction(lambda);
  const ExactDisc exact = closed_forms(lambda);
  CAPTURE(lambda);
  CHECK(std::abs(double(ours.force / exact.force - 1)) < 1e-14);
  CHECK(std::abs(double(ours.torque / exact.torque - 1)) < 1e-14);
}

// A contact whose slide and spin a step's friction slows, by a share of μN that is between a hundredth and a hundred
// times what they are.
struct Problem {
  FrictionProblem problem;
  double mu;
};
Problem random_problem(std::mt19937_64& random) {
  std::uniform_real_distribution<double> decades(-2, 2);
  const auto some = [&] { return std::pow(10, decades(random)); };
  FrictionProblem p;
  p.normal_impulse = some();
  p.contact_radius = 0.01 * some();
  p.mobility = {some(), 0, some() / (p.contact_radius * p.contact_radius)};
  p.free.slip = {some(), 0, 0};
  p.free.spin = some() / p.contact_radius;
  p.before = p.free;
  return {p, 0.3 * some()};
}

// Distance of two impulses, by the limits of both kinds.
double distance(const FrictionSolution& a, const FrictionSolution& b, const Problem& of) {
  const double limit = of.mu * of.problem.normal_impulse;
  return (norm(a.impulse.sliding - b.impulse.sliding) +
          std::abs(a.impulse.torsion - b.impulse.torsion) / of.problem.contact_radius) /
         limit;
}

}  // namespace

TEST_CASE("F and torque of the disc hold 14 digits everywhere") {
  for (int n = -600; n < 600; ++n) check(std::pow(10, (n + 0.5) / 100));
  // Where one way of summing them takes over from another.
  for (const double border : {std::sqrt(1.0 / 32), 0.5, 1.0, 2.0, std::sqrt(32.0)})
    for (const double beside : {0.0, border, 2 * border})
      if (const double lambda = beside == border ? border : std::nextafter(border, beside); lambda != 1) check(lambda);
}

TEST_CASE("friction of the disc is that of the motion it leaves") {
  std::mt19937_64 random(1);
  int sliding = 0;
  for (int n = 0; n < 20000; ++n) {
    const Problem p = random_problem(random);
    const FrictionSolution s = friction_impulse(Friction(p.mu, p.mu, 0), p.problem, {});
    if (s.sticks) continue;
    ++sliding;
    const SlipMobility& m = p.problem.mobility;
    const double a = p.problem.contact_radius, limit = p.mu * p.problem.normal_impulse;
    // Midpoint rule, or where that would turn the motion back, implicit Euler.
    double least = 1;
    for (const double share : {0.5, 1.0}) {
      const double slip = p.problem.free.slip.x + share * m.slip * s.impulse.sliding.x;
      const double spin = p.problem.free.spin + share * m.roll * s.impulse.torsion;
      if (!(slip > 0 && spin > 0)) continue;
      // How far the impulse is from that of speeds which are 10⁻¹³ of what friction changes off.
      const double tolerance = 1e-13 * (m.slip * limit + p.problem.free.slip.x) / slip +
                               1e-13 * (m.roll * a * limit + p.problem.free.spin) / spin;
      const DiscFriction f = disc_friction(slip / (a * spin));
      const double misfit = std::abs(s.impulse.sliding.x + limit * f.force) / limit +
                            std::abs(s.impulse.torsion + limit * a * f.torque) / (limit * a);
      least = std::min(least, misfit / (1e-13 + tolerance));
    }
    CAPTURE(n, p.mu, p.problem.free.slip.x, p.problem.free.spin);
    REQUIRE(least < 1);
  }
  CHECK(sliding > 8000);
}

TEST_CASE("friction does not depend on where it is sought from") {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> decades(-20, 20);
  for (int n = 0; n < 20000; ++n) {
    const Problem p = random_problem(random);
    const Friction friction(p.mu, p.mu, 0);
    const FrictionSolution s = friction_impulse(friction, p.problem, {});
    FrictionImpulse guess{{-std::pow(10, decades(random)), 0, 0}, -std::pow(10, decades(random)), {}};
    if (n % 5 == 0) guess.sliding = {};
    if (n % 7 == 0) guess.torsion = std::numeric_limits<double>::denorm_min();
    const FrictionSolution other = friction_impulse(friction, p.problem, guess);
    CAPTURE(n, guess.sliding.x, guess.torsion);
    REQUIRE(other.sticks == s.sticks);
    REQUIRE(distance(other, s, p) < 1e-12);
  }
}
