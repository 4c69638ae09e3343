#include "../runs/examples.hpp"

#include <catch2/catch.hpp>

TEST_CASE("the example's drum takes its grains along") {
  engines::check_rotating_drum("engines/liggghts/examples/rotating_drum.liggghts", 1800);
}
