#include "../../core/src/collision/solvers/arms_equations.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/solvers/fractional_solvers.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace ricochet;

namespace {

// The paper's Fig. 2: a steel sphere on a plate.
const Fractional law(4615380, 128.1, 0.2);
const Impact impact{.velocity = 1, .mass_eff = 8.878e-4};

FractionalSolverResult solved(FractionalScheme scheme, int steps, double offset = 0) {
  const double unit = std::pow(law.coefficient() / impact.mass_eff, -1 / 1.8);
  FractionalSolverOptions options{.step = fractional_contact(0.2).tau * unit / steps, .offset = offset};
  return solve_collision(scheme, law, impact, options);
}

const FractionalScheme steppers[] = {FractionalScheme::rectangle, FractionalScheme::trapezoid,
                                     FractionalScheme::arms_trapezoid, FractionalScheme::arms_exponential,
                                     FractionalScheme::arms_rosenbrock};

}  // namespace

TEST_CASE("Every scheme of the fractional collision tends to the closed form, wherever the mesh starts") {
  const FractionalContact exact = fractional_contact(0.2);
  const double unit = std::pow(law.coefficient() / impact.mass_eff, -1 / 1.8);
  // At 200 steps, from the stated orders with coefficients of size one: N^{−(2−α)}, N^{−2}; Rosenbrock keeps the error
  // of its kernel, (δ/t_col)^{3−α}. (59) holds the rate back by half a step, h/2·ζ'', and t_col is about 3 natural
  // times.
  const double bounds[] = {3.0 / 200, std::pow(200, -2.0), std::pow(200, -1.8), std::pow(200, -2.0),
                           std::pow(200, -2.0)};
  for (std::size_t i = 0; i < std::size(steppers); ++i)
    for (const double offset : {0.0, 0.3, 0.99}) {
      CAPTURE(name(steppers[i]), offset);
      const FractionalSolverResult r = solved(steppers[i], 200, offset);
      REQUIRE(r.status == CollisionStatus::ended_by_force);
      CHECK(r.en == Approx(exact.en).epsilon(2 * bounds[i]));
      CHECK(r.tcol == Approx(exact.tau * unit).epsilon(2 * bounds[i]));
      CHECK(r.overlap_end == Approx(exact.overlap_end * exact.tau * unit).epsilon(5 * bounds[i]));
      CHECK(r.steps >= 200);
      CHECK(r.multiplications > 0);
    }
}

TEST_CASE("The arms' exponential step is the product trapezoid rule to the kernel's tolerance") {
  const FractionalSolverResult history = solved(FractionalScheme::trapezoid, 100);
  const FractionalSolverResult arms = solved(FractionalScheme::arms_exponential, 100);
  // P(EC)²E stops short of the implicit solution by a third power of w₀ ~ h^{2−α}: below 1e-8 here.
  CHECK(arms.en == Approx(history.en).epsilon(1e-8));
  CHECK(arms.tcol == Approx(history.tcol).epsilon(1e-8));
}

TEST_CASE("The Jacobian of the arms' equations is the slope of the equations") {
  const collision::Exponentials kernel{0.3, 0.07, {1.1, 2.3, 4.7}, {0.9, 11, 130}};
  constexpr std::size_t size = 5;
  struct Matrix {
    double at[size][size];
    double& operator()(std::size_t i, std::size_t j) { return at[i][j]; }
  } jacobian;
  for (auto& row : jacobian.at) std::fill(row, row + size, 99.0);  // whatever was in it is to be gone
  std::vector<double> x{0.2, -0.5, 0.1, 0.03, -0.002}, dfdt(size, 99.0);
  collision::ArmsJacobian{kernel}(x, jacobian, 0, dfdt);
  const auto slope_of = [&](std::size_t i, std::size_t j) {
    std::vector<double> high = x, low = x, at_high(size), at_low(size);
    high[j] += 0.5, low[j] -= 0.5;  // linear equations: of any width
    collision::ArmsEquations{kernel}(high, at_high, 0);
    collision::ArmsEquations{kernel}(low, at_low, 1);
    return at_high[i] - at_low[i];
  };
  for (std::size_t i = 0; i < size; ++i) {
    CHECK(dfdt[i] == 0);
    for (std::size_t j = 0; j < size; ++j) {
      CAPTURE(i, j);
      CHECK(jacobian(i, j) == Approx(slope_of(i, j)).epsilon(1e-13).margin(1e-13));
    }
  }
}

TEST_CASE("Collocation needs no steps") {
  FractionalSolverOptions options;
  options.nodes = 24;
  const FractionalSolverResult r = solve_collision(FractionalScheme::collocation, law, impact, options);
  CHECK(r.en == Approx(fractional_contact(0.2).en).epsilon(1e-10));
  CHECK(r.path.empty());
}

TEST_CASE("A solver can go on to a given time, and says when there is no end") {
  FractionalSolverOptions options{.step = 1e-6, .end_time = 60e-6};
  const FractionalSolverResult r = solve_collision(FractionalScheme::trapezoid, law, impact, options);
  CHECK(r.path.size() == 61);
  CHECK(r.path.back().time == Approx(60e-6).epsilon(1e-12));
  CHECK(r.path.back().force < 0);
  // A negative order gains energy; only the history of the rate knows it.
  options = {.step = 1e-7};
  CHECK(solve_collision(FractionalScheme::trapezoid, Fractional(4615380, 128.1, -0.2), impact, options).en > 1);
}

TEST_CASE("Below alpha = 0 a solver ends where the overlap does, and tends to the closed form") {
  for (const double alpha : {-0.1, -0.5, -0.9}) {
    const Fractional gains(4615380, 128.1, alpha);
    const Collision exact = collide(gains, impact);
    for (const auto scheme : {FractionalScheme::rectangle_integral, FractionalScheme::trapezoid})
      for (const double offset : {0.0, 0.3, 0.99}) {
        CAPTURE(alpha, name(scheme), offset);
        const FractionalSolverResult r =
            solve_collision(scheme, gains, impact, {.step = exact.tcol / 200, .offset = offset});
        // (60) holds the overlap back by half a step, which the rate at the end feels as h/2·ζ''; t_col is about 3
        // natural times.
        const double bound = scheme == FractionalScheme::trapezoid ? 2 * std::pow(200, -2.0) : 2 * 3.0 / 200;
        REQUIRE(r.status == CollisionStatus::ended_by_overlap);
        CHECK(r.en == Approx(exact.en).epsilon(bound));
        CHECK(r.tcol == Approx(exact.tcol).epsilon(bound));
        CHECK(r.overlap_end == 0);
        CHECK(r.path.back().force > 0);
      }
  }
  CHECK_THROWS_WITH(solve_collision(FractionalScheme::rectangle_integral, law, impact, {.step = 1e-6}),
                    Catch::Contains("alpha = 0.2: must be >= -1 and < 0"));
}

TEST_CASE("Misuse of a fractional solver is named") {
  const FractionalSolverOptions good{.step = 1e-6};
  CHECK_THROWS_WITH(solve_collision(FractionalScheme::rectangle, Fractional(1, 1, 1.2), impact, good),
                    Catch::Contains("alpha = 1.2"));
  CHECK_THROWS_WITH(solve_collision(FractionalScheme::trapezoid, law, impact, {}), Catch::Contains("step = 0"));
  CHECK_THROWS_WITH(solve_collision(FractionalScheme::trapezoid, law, impact, {.step = 1e-6, .offset = 1}),
                    Catch::Contains("offset = 1"));
  FractionalSolverOptions other = good;
  other.kernel = memory_kernel(0.3, 1e-6, 1e-4, 1e-6);
  CHECK_THROWS_WITH(solve_collision(FractionalScheme::arms_trapezoid, law, impact, other),
                    Catch::Contains("kernel alpha = 0.3"));
}
