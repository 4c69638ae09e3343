#include "../runs/scenes.hpp"
#include "deck.hpp"

#include <catch2/catch.hpp>

using namespace engines;
using namespace engines::bouncing;

TEST_CASE("each of five bounces between neighbour rebuilds starts without memory of the one before") {
  for (bool between_grains : {true, false}) {
    const auto deck = [&](const Workplace& place, int ranks) {
      const std::string obstacles = between_grains ? "group fixed id 2 3\nfix hold fixed freeze\n"
                                                   : planes("xplane", "0", "0.0032", target(tcol, en));
      return preamble(box, processors(ranks)) + place.create(grains(between_grains), box) + neighbours(skin) +
             one_law(target(tcol, en)) + obstacles + move(dt) + dump("dump") + run(steps_of_run());
    };
    check(between_grains ? "grains" : "planes", deck, 0);
  }
}
