#include "../runs/scenes.hpp"
#include "liggghts_run.hpp"

#include <catch2/catch.hpp>

using namespace engines;
using namespace engines::bouncing;

namespace {

struct Setting {
  const char* name;
  const char* walls;
  bool grains;  // fixed grains as the obstacles
};

const Setting settings[] = {
    {"primitive",
     "fix left all wall/gran model fractional primitive type 1 xplane 0\n"
     "fix right all wall/gran model fractional primitive type 1 xplane 0.0032\n",
     false},
    {"mesh",
     "fix a all mesh/surface file square.stl type 1\nfix b all mesh/surface file square.stl type 1 move 0.0032 0. 0.\n"
     "fix walls all wall/gran model fractional mesh n_meshes 2 meshes a b\n",
     false},
    {"grains", "group fixed id 2 3\nfix hold fixed freeze\n", true},
};

std::string deck(const Setting& setting, const Workplace& place, int ranks) {
  write_square(place.file("square.stl"), -0.0095, 0.0095);
  return preamble(box, processors(ranks)) + place.create(grains(setting.grains), box) + "neighbor " + skin +
         " bin\nneigh_modify delay 0\n" + pair_property("collisionTime", tcol) +
         pair_property("coefficientRestitution", en) + "pair_style gran model fractional\npair_coeff * *\n" +
         setting.walls +
         (setting.grains ? "group free subtract all fixed\nfix move free nve/sphere\n" : "fix move all nve/sphere\n") +
         "timestep " + number(dt) + "\n" + dump_command("dump") + "run " + std::to_string(steps_of_run()) + "\n";
}

}  // namespace

TEST_CASE("each of five bounces between neighbour rebuilds starts without memory of the one before") {
  for (const Setting& setting : settings)
    check(
        setting.name, [&](const Workplace& place, int ranks) { return deck(setting, place, ranks); }, 1e-10);
}
