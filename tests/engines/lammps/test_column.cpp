#include "../runs/column.hpp"
#include "deck.hpp"

#include <catch2/catch.hpp>

using namespace engines;

TEST_CASE("a column of ten beads leaves the plate as our own column engine has it") {
  const std::string law = target(column::tcol, column::en), settings = memory(column::memory);
  column::check("column", [&](const Workplace& place, const std::vector<Grain>& beads, double dt, int last) {
    return preamble(column::box) + place.create(beads, column::box) + neighbours() + one_law(law, settings) +
           planes("zplane", "0", "NULL", law, settings) + move(dt) + dump("dump", last) + run(last);
  });
}
