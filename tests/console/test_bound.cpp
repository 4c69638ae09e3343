#include <console/bound.hpp>
#include <console/number.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace ricochet::console;

TEST_CASE("a bound is said with the digits that what was refused asks for") {
  CHECK(bound_text({2, Bound::upper}, 3) == "2");
  CHECK(bound_text({1.0 / 3, Bound::upper}, 1) == "0.333333");
  CHECK(bound_text({1.0 / 3, Bound::upper}, 0.33333333333, 3) == "0.333");  // within
  CHECK(bound_text({1.0 / 3, Bound::upper}, 0.33333333334, 3) == "0.333");
  CHECK(bound_text({2.5699e-05, Bound::upper}, 2.57e-05, 3) == "2.5699e-05");  // not "2.57e-05"
  CHECK(bound_text({2.5701e-05, Bound::lower}, 2.57e-05, 3) == "2.5701e-05");
  CHECK(bound_text({0.25, Bound::upper, true}, 0.25, 2) == "0.25");  // open: must be less
  const double next = std::nextafter(0.3, 1);
  CHECK(bound_text({0.3, Bound::upper}, next) == "0.3");
  CHECK(bound_text({next, Bound::lower}, 0.3) == shortest(next));
  const double infinity = std::numeric_limits<double>::infinity();
  CHECK(bound_text({infinity, Bound::upper}, 1) == "inf");
}
