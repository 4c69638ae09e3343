#include <ricochet/fractional/operators.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>

using namespace ricochet;

namespace {

const double orders[] = {0.1, 0.25, 0.5, 0.75, 0.9};

template <class F>
std::vector<double> sampled(F f, double h, std::size_t steps) {
  std::vector<double> x(steps + 1);
  for (std::size_t l = 0; l <= steps; ++l) x[l] = f(h * static_cast<double>(l));
  return x;
}

/// D^α t^p = Γ(p+1)/Γ(p+1−α) t^{p−α}, also for integrals (α < 0).
double power_rule(double p, double alpha, double t) {
  return std::tgamma(p + 1) / std::tgamma(p + 1 - alpha) * std::pow(t, p - alpha);
}

}  // namespace

TEST_CASE("Rules are exact where their interpolant is") {
  const double h = 0.01;
  for (const double a : orders)
    for (const std::size_t n : {1, 2, 3, 5, 17, 200}) {
      CAPTURE(a, n);
      const double t = h * static_cast<double>(n);
      const auto one = sampled([](double) { return 1.0; }, h, n), line = sampled([](double s) { return s; }, h, n);
      const auto check = [](double value, double exact) { CHECK(value == Approx(exact).epsilon(1e-12)); };
      check(rectangle_derivative(a, h, n).last(one), power_rule(1, a, t));
      check(rectangle_integral(a, h, n).last(one), power_rule(0, -a, t));
      check(l1_derivative(a, h, n).last(line), power_rule(1, a, t));
      check(l12_derivative(a, h, n).last(line), power_rule(1, a, t));
      check(trapezoid_derivative(a, h, n).last(one), power_rule(1, a, t));
      check(trapezoid_derivative(a, h, n).last(line), power_rule(2, a, t) / 2);
      check(trapezoid_integral(a + 1, h, n).last(line), power_rule(1, -a - 1, t));
    }
}

TEST_CASE("L1-2 is exact for parabolas but for its first step") {
  // Over the first step the chord of t² has the right mean rate: what is missed is ½·second difference there.
  for (const double a : orders) {
    const double h = 0.1, t = 3;
    const std::size_t n = 30;
    const auto square = sampled([](double s) { return s * s; }, h, n);
    double missed = 0;  // 1/Γ(1−α) ∫_0^h (t−s)^{−α} (2s − h) ds by a fine midpoint sum
    for (int i = 0; i < 2000; ++i) {
      const double s = h * (i + 0.5) / 2000;
      missed += std::pow(t - s, -a) * (2 * s - h) * h / 2000;
    }
    missed /= std::tgamma(1 - a);
    CHECK(l12_derivative(a, h, n).last(square) == Approx(power_rule(2, a, t) - missed).epsilon(1e-10));
  }
}

TEST_CASE("(59) and (60) are the paper's sums as written") {
  const double a = 0.3, h = 0.07;
  const std::size_t n = 23;
  const auto x = sampled([](double s) { return std::cos(3 * s); }, h, n);
  const auto written = [&](double p) {
    const double t = h * static_cast<double>(n);
    double sum = x[0] * std::pow(t, p);
    for (std::size_t l = 1; l <= n; ++l)
      sum += (x[l] - x[l - 1]) * std::pow(std::fabs(t - h * static_cast<double>(l)), p);
    return sum / std::tgamma(p + 1);
  };
  CHECK(rectangle_derivative(a, h, n).last(x) == Approx(written(1 - a)).epsilon(1e-12));
  CHECK(rectangle_integral(a, h, n).last(x) == Approx(written(a)).epsilon(1e-12));
}

TEST_CASE("Weights of old samples keep their digits") {
  // The weights sum to the operator of a constant, to rounding, also after 10⁵ steps.
  const std::size_t n = 100000;
  for (const double a : orders) {
    CAPTURE(a);
    const double t = static_cast<double>(n);
    const std::vector<double> one(n + 1, 1.0);
    CHECK(trapezoid_integral(a, 1, n).last(one) == Approx(power_rule(0, -a, t)).epsilon(1e-13));
    // −L1's first weights: Σ w = 0 for a constant, against a scale of 1.
    CHECK(l1_derivative(a, 1, n).last(one) == Approx(0).margin(1e-13));
    CHECK(l12_derivative(a, 1, n).last(one) == Approx(0).margin(1e-13));
    // The oldest weights against the kernel they sample, t^{−α}/Γ(1−α)·(1 + O(1/t)).
    CHECK(rectangle_derivative(a, 1, n).weights()[n] ==
          Approx(std::pow(t - 0.5, -a) / std::tgamma(1 - a)).epsilon(1e-10));
    CHECK(l1_derivative(a, 1, n).weights()[n] == Approx(-a * std::pow(t, -a - 1) / std::tgamma(1 - a)).epsilon(1e-9));
  }
}

TEST_CASE("On a uniform mesh the general rules are the uniform ones, and grading mends a weak start") {
  const double a = 0.4;
  const auto mesh = graded_mesh(2, 40, 1);
  std::vector<double> values, rates;
  for (const double t : mesh) values.push_back(std::sin(t)), rates.push_back(std::cos(t));
  CHECK(l1_derivative(a, mesh, values) == Approx(l1_derivative(a, 0.05, 40).last(values)).epsilon(1e-12));
  CHECK(trapezoid_derivative(a, mesh, rates) == Approx(trapezoid_derivative(a, 0.05, 40).last(rates)).epsilon(1e-12));

  const auto worst = [&](double grading) {
    const auto times = graded_mesh(1, 256, grading);
    double error = 0;
    std::vector<double> x;
    for (const double t : times) x.push_back(1.5 * std::sqrt(t));
    for (std::size_t n = 1; n < times.size(); ++n) {
      const std::span<const double> t(times.data(), n + 1), r(x.data(), n + 1);
      error = std::max(error, std::fabs(trapezoid_derivative(a, t, r) - power_rule(1.5, a, times[n])));
    }
    return error;
  };
  CHECK(worst(2.0) < 0.02 * worst(1.0));
}

TEST_CASE("Misuse of an operator is named") {
  CHECK_THROWS_WITH(l1_derivative(1.5, 0.1, 4), Catch::Contains("alpha = 1.5"));
  CHECK_THROWS_WITH(trapezoid_integral(0, 0.1, 4), Catch::Contains("beta = 0"));
  CHECK_THROWS_WITH(gruenwald_letnikov_derivative(0.5, -1, 4), Catch::Contains("step = -1"));
  CHECK_THROWS_WITH(l1_derivative(0.5, 0.1, 4).last(std::vector<double>(6)), Catch::Contains("samples = 6"));
  CHECK_THROWS_WITH(graded_mesh(1, 4, 0.5), Catch::Contains("grading"));
  // h^10, and the weights that it is multiplied by.
  CHECK_THROWS_WITH(trapezoid_integral(10, 1e31, 4), Catch::Contains("step = 1e+31"));
  CHECK_THROWS_WITH(trapezoid_integral(10, 1e-31, 4), Catch::Contains("step = 1e-31"));
  CHECK_THROWS_WITH(trapezoid_integral(10, 5e30, 1000), Catch::Contains("weight = inf: must be finite"));
}
