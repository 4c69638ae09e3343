#include <catch2/catch.hpp>
#include <ricochet/ricochet.hpp>

using namespace ricochet;

TEST_CASE("a law rejects parameters outside its domain and names them") {
  CHECK_THROWS_WITH(Linear(-1, 0), "k = -1: must be finite and > 0");
  CHECK_THROWS_WITH(Linear(1, -0.5), "c = -0.5: must be finite and >= 0");
  CHECK_THROWS_WITH(Hysteretic(2, 1), "k1 = 2: must be at most k2");
  CHECK_THROWS_AS(Fractional(1, 0, 0.5), std::invalid_argument);
}
