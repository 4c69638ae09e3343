#include <console/bound.hpp>
#include <console/number.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace ricochet::console;

TEST_CASE("a bound is said by digits that lie within it") {
  CHECK(bound_text(Bound::upper, 2) == "2");
  CHECK(bound_text(Bound::upper, 1.0 / 3) == "0.333333");
  CHECK(bound_text(Bound::upper, 0.66666, 3) == "0.66666");  // 0.667 and 0.6667 lie beyond
  CHECK(bound_text(Bound::lower, 0.66666, 3) == "0.667");
  CHECK(bound_text(Bound::upper, 0.12345, 2) == "0.12");
  // "2.57e-05: must be at most 2.57e-05" would be no help.
  CHECK(bound_text(Bound::upper, 2.5699e-05, 3) == "2.5699e-05");
  CHECK(bound_text(Bound::lower, 2.5701e-05, 3) == "2.5701e-05");
  const double next = std::nextafter(0.3, 1);
  CHECK(bound_text(Bound::upper, next) == "0.3");
  CHECK(bound_text(Bound::lower, next) == shortest(next));
  CHECK(bound_text(Bound::upper, std::numeric_limits<double>::infinity()) == "inf");
}
