#include "mittag_leffler_reference.hpp"

#include <catch2/catch.hpp>
#include <console/csv.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <vector>

using ricochet::mittag_leffler;
using ricochet::MittagLeffler;

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The promise of the header.
double bound(double value, double slope) { return 1e-13 * std::abs(value) + 20 * epsilon * std::abs(slope); }

/// Error in units of the promise; what falls below the smallest double counts as 0.
double excess(double computed, double value, double slope) {
  return std::abs(computed - value) / (bound(value, slope) + std::numeric_limits<double>::min());
}

struct Row {
  double a, b, x, value;
};

std::vector<Row> rows(const std::string& file) {
  using ricochet::console::CsvColumn;
  constexpr std::array columns{CsvColumn{"a"}, CsvColumn{"b"}, CsvColumn{"x"}, CsvColumn{"value"}};
  ricochet::console::CsvReader in(file, columns);
  std::vector<Row> result;
  while (in.next()) result.push_back({in.number(0), in.number(1), in.number(2), in.number(3)});
  return result;
}

void compare_with_multiprecision(int count, unsigned seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const std::array special_a{0.1,    0.3, 0.5,  0.75, 0.99,   1.0, 1 + 1e-9, 1.001,
                             1.0625, 1.5, 1.99, 2.0,  2.0001, 2.5, 2.999,    3.0};
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const double a = uniform(0, 1) < 0.5 ? special_a[random() % special_a.size()] : uniform(0.1, 3);
    const std::array special_b{0.5, 1.0, 2.0, a, 3.0, 2 * a, a + 1, a + 1e-9, std::abs(a - 1) + 1e-3, uniform(0.01, 6)};
    const double b = special_b[random() % special_b.size()];
    const double kind = uniform(0, 1);
    const double x = kind < 0.4 ? -uniform(0, 12) : kind < 0.8 ? -std::pow(10, uniform(-3, 6)) : uniform(0, 5);
    if (x > 0 && std::pow(x, 1 / a) > 690) continue;
    const Reference reference = mittag_leffler_reference(a, b, x);
    INFO("a = " << a << ", b = " << b << ", x = " << x << ", E = " << reference.digits);
    const double direct = excess(mittag_leffler(a, b, x), reference.value, reference.slope);
    const double prepared = excess(MittagLeffler(a, b)(x), reference.value, reference.slope);
    worst = std::max({worst, direct, prepared});
    CHECK(direct <= 1);
    CHECK(prepared <= 1);
  }
  WARN("worst error in units of the promise: " << worst);
}

}  // namespace

TEST_CASE("E matches the tabulated reference values") {
  const std::vector<Row> table = rows(RICOCHET_SOURCE_DIR "/data/mittag_leffler_reference.csv");
  REQUIRE(table.size() == 213);
  for (const Row& row : table) {
    INFO("a = " << row.a << ", b = " << row.b << ", x = " << row.x);
    const auto f = [&](double x) { return mittag_leffler(row.a, row.b, x); };
    const double slope = (f(row.x * 1.0001) - f(row.x * 0.9999)) / 2e-4;  // x E', as far as the promise needs it
    CHECK(excess(f(row.x), row.value, slope) <= 1);
    CHECK(excess(MittagLeffler(row.a, row.b)(row.x), row.value, slope) <= 1);
  }
}

TEST_CASE("E matches multiprecision") { compare_with_multiprecision(50, 1); }
TEST_CASE("E matches multiprecision at many points", "[.slow]") { compare_with_multiprecision(1500, 2); }

TEST_CASE("E matches multiprecision for large b, whose contours are further out") {
  for (double b : {2.6, 9.53, 35.0, 56.9, 72.0, 100.0, 111.0, 120.0})
    for (double a : {0.5, 1.3, 2.4})
      for (double x : {-2e3, -3.0, 0.7}) {
        const Reference reference = mittag_leffler_reference(a, b, x);
        CAPTURE(a, b, x, reference.digits);
        CHECK(excess(mittag_leffler(a, b, x), reference.value, reference.slope) <= std::max(1.0, b / 100));
        CHECK(excess(MittagLeffler(a, b)(x), reference.value, reference.slope) <= std::max(1.0, b / 100));
      }
}

TEST_CASE("E matches multiprecision for small a, where E_{a,a} is as small as a") {
  for (double a : {1e-9, 2e-3, 0.0999})
    for (double b : {a, 0.02, 1.0})
      for (double x : {-9e5, -41.0, -1.7, -0.6, 0.02, 0.4}) {
        const Reference reference = mittag_leffler_reference(a, b, x);
        CAPTURE(a, b, x, reference.digits);
        CHECK(excess(mittag_leffler(a, b, x), reference.value, reference.slope) <= 1);
        CHECK(excess(MittagLeffler(a, b)(x), reference.value, reference.slope) <= 1);
      }
  for (double from_one : {-4.0, 1.9, 2.1})  // in units of a: both sides of where the forms meet
    for (double a : {0.09})
      for (double b : {a, 1.0}) {
        const double x = 1 - from_one * a;
        const Reference reference = mittag_leffler_reference(a, b, x);
        CAPTURE(a, b, x, reference.digits);
        CHECK(excess(mittag_leffler(a, b, x), reference.value, reference.slope) <= 1);
        CHECK(excess(MittagLeffler(a, b)(x), reference.value, reference.slope) <= 1);
      }
}

TEST_CASE("the tabulated reference values are those of the multiprecision series", "[.slow]") {
  for (const Row& row : rows(RICOCHET_SOURCE_DIR "/data/mittag_leffler_reference.csv")) {
    INFO("a = " << row.a << ", b = " << row.b << ", x = " << row.x);
    CHECK(std::abs(mittag_leffler_reference(row.a, row.b, row.x).value / row.value - 1) < 2 * epsilon);
  }
}

// What the switch points in core/src/fractional rest on: worst error in units of the promise over b, by a and x, of the
// contour sum and of the prepared form. Run with: test_fractional "[.map]"
TEST_CASE("error map of E", "[.map]") {
  const std::array orders{1e-6, 0.01, 0.09, 0.1, 0.4, 0.8,  0.95, 0.97, 0.9999, 1.0, 1.0001,
                          1.04, 1.06, 1.2,  1.5, 1.8, 1.97, 2.0,  2.03, 2.4,    2.8, 3.0};
  const std::array arguments{-8e5, -3e4,  -900.0, -41.0, -31.0, -29.0, -16.1, -15.9,
                             -6.0, -1.01, -0.99,  -0.1,  0.6,   2.1,   4.9};
  std::ostringstream map;
  map << "a \\ x: contour/prepared";
  for (double x : arguments) map << '\t' << x;
  for (double a : orders) {
    map << '\n' << a;
    for (double x : arguments) {
      double direct = 0, prepared = 0;
      for (double b : {0.29, 0.31, 1.0, 1.16, a, 2.0, 2.51, 4.01}) {
        if (x > 0 && std::pow(x, 1 / a) > 690) continue;
        const Reference r = mittag_leffler_reference(a, b, x);
        direct = std::max(direct, excess(mittag_leffler(a, b, x), r.value, r.slope));
        prepared = std::max(prepared, excess(MittagLeffler(a, b)(x), r.value, r.slope));
      }
      map << '\t' << std::round(direct * 1000) / 1000 << '/' << std::round(prepared * 1000) / 1000;
      CHECK(std::max(direct, prepared) <= 1);
    }
  }
  WARN(map.str());
}

TEST_CASE("E has its closed forms") {
  for (double x : {-500.0, -40.0, -7.5, -1.0, -1e-3, 0.0, 1e-3, 0.7, 5.0}) {
    INFO("x = " << x);
    CHECK(excess(mittag_leffler(1, 1, x), std::exp(x), x * std::exp(x)) <= 1);
    if (x != 0) CHECK(excess(mittag_leffler(1, 2, x), std::expm1(x) / x, std::exp(x) - std::expm1(x) / x) <= 1);
    const double root = std::sqrt(std::abs(x));
    CHECK(excess(mittag_leffler(2, 1, x), x < 0 ? std::cos(root) : std::cosh(root),
                 0.5 * root * (x < 0 ? std::sin(root) : std::sinh(root))) <= 1);
    const double versine = x < 0 ? 2 * std::pow(std::sin(root / 2), 2) : 2 * std::pow(std::sinh(root / 2), 2);
    if (x != 0) CHECK(excess(mittag_leffler(2, 3, x), versine / std::abs(x), 0) <= 1);
    if (x >= -7.5 && x <= 0) {  // erfcx through erfc has lost no digit yet
      CHECK(excess(mittag_leffler(0.5, 1, x), std::exp(x * x) * std::erfc(-x), x) <= 1);
    }
  }
}

TEST_CASE("E satisfies its recurrence in b and its derivative identity") {
  for (double a : {0.25, 0.8, 1.0, 1.2, 1.7, 2.0, 2.6})
    for (double b : {0.7, 1.0, a, 2.0, 4.5})
      for (double x : {-60.0, -9.0, -1.5, -0.2, 0.4, 0.9}) {
        INFO("a = " << a << ", b = " << b << ", x = " << x);
        const double e = mittag_leffler(a, b, x), raised = mittag_leffler(a, a + b, x);
        const double scale = 1 / std::tgamma(b) + std::abs(x * raised) + std::abs(e);
        CHECK(std::abs(e - 1 / std::tgamma(b) - x * raised) <= 4e-13 * scale);
        // d/dx[E_{a,b}] = (E_{a,b−1} − (b−1)E_{a,b})/(a x), against a central difference of order 4
        const double h = 2e-3 * std::abs(x), at = a < 1 && x > 0 ? 0.5 * x : x;
        const auto f = [&](double y) { return mittag_leffler(a, b + 1, y); };
        const double numeric = (8 * (f(at + h) - f(at - h)) - (f(at + 2 * h) - f(at - 2 * h))) / (12 * h);
        const double exact = (mittag_leffler(a, b, at) - b * mittag_leffler(a, b + 1, at)) / (a * at);
        CHECK(numeric == Approx(exact).epsilon(1e-7).margin(1e-10));
      }
}

TEST_CASE("E is finite where e^s at its pole is not") {
  // The residue e^s s^{1−b}/a, s = x^{1/a} = 800: what else there is in E is 1e-150 of it.
  const double a = 0.2, b = 100, x = std::pow(800, a), s = std::pow(x, 1 / a);
  CHECK(mittag_leffler(a, b, x) == Approx(std::exp(s - (b - 1) * std::log(s)) / a).epsilon(20 * epsilon * s / a));
}

TEST_CASE("E has its digits where it is as small as a double can be") {
  for (double a : {0.5, 1.3, 2.4})
    for (double b : {70.0, 72.0, 110.0, 117.0})
      for (double x : {-60.0, -1.5, 0.4, 0.9}) {
        INFO("a = " << a << ", b = " << b << ", x = " << x);
        const double exact = 1 / std::tgamma(b) + x * mittag_leffler(a, a + b, x);
        CHECK(mittag_leffler(a, b, x) == Approx(exact).epsilon(4e-13));
      }
}

TEST_CASE("E says what it cannot do") {
  CHECK_THROWS_WITH(mittag_leffler(0, 1, -1), "a = 0: must be in (0, 3]");
  CHECK_THROWS_WITH(mittag_leffler(3.5, 1, -1), "a = 3.5: must be in (0, 3]");
  CHECK_THROWS_WITH(MittagLeffler(1, 0), "b = 0: must be in (0, 120]");
  CHECK_THROWS_WITH(mittag_leffler(1, 1, 6), "x = 6: must be in [-1e6, 5]");
  CHECK_THROWS_AS(mittag_leffler(1, 1, std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  CHECK_THROWS_WITH(mittag_leffler(1, 121, -1), "b = 121: must be in (0, 120]");
  CHECK_THROWS_AS(mittag_leffler(0.05, 1, 5), std::overflow_error);
  CHECK(mittag_leffler(1, 1, -1e6) == 0);
}
