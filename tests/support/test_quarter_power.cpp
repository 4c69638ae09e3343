#include <ricochet/support/quarter_power.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>
#include <utility>

using ricochet::support::quarter_power;

namespace {

template <int Quarters>
void check_power() {
  for (const double x : {1e-18, 3.7e-6, 0.02, 0.5, 1.0, 1.7, 42.0, 6.1e9}) {
    CAPTURE(Quarters, x);
    // Four roundings, and one of std::pow.
    CHECK(std::abs(quarter_power<Quarters>(x) / std::pow(x, Quarters / 4.0) - 1) <=
          5 * std::numeric_limits<double>::epsilon());
  }
}

template <int... N>
void check_powers(std::integer_sequence<int, N...>) {
  (check_power<N - 16>(), ...);
}

}  // namespace

TEST_CASE("Powers of quarters are those of std::pow") { check_powers(std::make_integer_sequence<int, 33>()); }

TEST_CASE("Whole powers and those of squares and fourth powers are exact") {
  CHECK(quarter_power<0>(0.3) == 1);
  CHECK(quarter_power<4>(0.3) == 0.3);
  CHECK(quarter_power<8>(0.5) == 0.25);
  CHECK(quarter_power<-8>(0.5) == 4);
  CHECK(quarter_power<1>(81) == 3);
  CHECK(quarter_power<2>(81) == 9);
  CHECK(quarter_power<3>(81) == 27);
  CHECK(quarter_power<6>(4) == 8);
  CHECK(quarter_power<1>(0) == 0);
}
