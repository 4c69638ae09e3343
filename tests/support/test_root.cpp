#include <ricochet/support/root.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

using ricochet::support::root;
using ricochet::support::root_bracket;

TEST_CASE("A bracketed root is found to its last bits") {
  int evaluations = 0;
  const auto cosine = [&](double x) { return ++evaluations, std::cos(x); };
  // 4 ε of the bracket's lower end, and the zero of cos as a double is exact to half a unit.
  CHECK(std::abs(root(cosine, 1, 3) - std::numbers::pi / 2) <= 2 * std::numeric_limits<double>::epsilon());
  CHECK(evaluations < 15);
  CHECK(std::abs(root([](double x) { return 1e-30 - x * x * x; }, 0, 1) - 1e-10) < 1e-25);
}

TEST_CASE("A bracket may close on neighbouring doubles, which enclose the root") {
  const auto f = [](double x) { return x * x - 2; };
  const auto [low, high] = root_bracket(f, 0, 2, f(0), f(2), {.relative = 0});
  CHECK(std::nextafter(low, high) == high);
  CHECK(f(low) < 0);
  CHECK(f(high) > 0);
}

TEST_CASE("A wider tolerance takes fewer evaluations and keeps it") {
  const auto count = [](double relative) {
    int evaluations = 0;
    const double x = root([&](double t) { return ++evaluations, std::exp(t) - 2; }, 0, 5, {.relative = relative});
    CHECK(std::abs(x - std::numbers::ln2) <= std::fmax(relative, 4e-16) * std::numbers::ln2);
    return evaluations;
  };
  CHECK(count(1e-3) < count(1e-15));
}

TEST_CASE("An end that is the root is returned, and a bracket without a change of sign is refused") {
  CHECK(root([](double x) { return x; }, 0, 1) == 0);
  CHECK(root([](double x) { return x - 1; }, 0, 1) == 1);
  CHECK_THROWS_AS(root([](double x) { return x + 1; }, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(root([](double) { return std::nan(""); }, 0, 1), std::invalid_argument);
}

TEST_CASE("A value given at an end may be a limit that the function cannot be asked for") {
  const auto f = [](double x) {
    REQUIRE(x > 0);
    return std::log(x) + 1;
  };
  CHECK(std::abs(root(f, 0, 1, -1e3, 1) - 1 / std::numbers::e) < 4e-16);
}
