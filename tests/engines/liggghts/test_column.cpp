#include "../runs/column.hpp"
#include "liggghts_run.hpp"

#include <catch2/catch.hpp>

using namespace engines;

TEST_CASE("a column of ten beads leaves the plate as our own column engine has it") {
  column::check("column", [](const Workplace& place, const std::vector<Grain>& beads, double dt, int last) {
    return preamble(column::box) + place.create(beads, column::box) + "neighbor 0.0005 bin\nneigh_modify delay 0\n" +
           pair_property("collisionTime", column::tcol) + pair_property("coefficientRestitution", column::en) +
           "fix memory all property/global memoryTime scalar " + number(column::memory) +
           "\npair_style gran model fractional\npair_coeff * *\n"
           "fix plate all wall/gran model fractional primitive type 1 zplane 0\n"
           "fix move all nve/sphere\ntimestep " +
           number(dt) + "\n" + dump_command("dump", last) + "run " + std::to_string(last) + "\n";
  });
}
