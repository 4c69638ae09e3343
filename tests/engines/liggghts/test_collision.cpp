#include "../runs/collisions.hpp"
#include "liggghts_run.hpp"

#include <catch2/catch.hpp>

using namespace engines;
using collisions::tcol;

namespace {

// Those that are asked for; of the laws of real solids with α = 0.5 less than 0.3 is not to be had.
const std::vector<double> of_fractional{0.1, 0.3, 0.5, 0.8, 0.95}, of_solids{0.4, 0.5, 0.7, 0.8, 0.95};

std::string materials(const std::vector<double>& restitutions) {
  const std::size_t n = restitutions.size();
  std::vector<std::vector<double>> en(n, std::vector<double>(n, 0.5));
  for (std::size_t m = 0; m < n; ++m) en[m][m] = en[0][m] = en[m][0] = restitutions[m];  // walls are of type 1
  return pair_property("collisionTime", tcol, static_cast<int>(n)) + pair_property("coefficientRestitution", en);
}

// What the grains collide with; LAW in its commands stands for the model's name.
struct Partner {
  const char* name;
  bool wall;
  std::string commands;
};

std::string with_law(std::string commands, const std::string& law) {
  if (const auto at = commands.find("LAW"); at != std::string::npos) commands.replace(at, 3, law);
  return commands;
}

void check_series(const Model& model, const Partner& partner) {
  const auto& restitutions = model.name == "fractional" ? of_fractional : of_solids;
  std::vector<collisions::Errors> errors;
  const Box box = collisions::box(restitutions.size(), partner.wall);
  for (int steps : collisions::steps_per_contact) {
    const double dt = tcol / steps;
    const Workplace place("collision_" + model.name + "_" + partner.name + "_" + std::to_string(steps));
    write_square(place.file("square.stl"), 5e-4, 0.0295);
    const std::string deck =
        preamble(box) + place.create(collisions::grains(restitutions.size(), dt, partner.wall), box) +
        "neighbor 0.0005 bin\n" + materials(restitutions) + model.properties + "pair_style gran model " + model.name +
        "\npair_coeff * *\n" + with_law(partner.commands, model.name) + "fix move all nve/sphere\ntimestep " +
        number(dt) + "\n" + dump_command("dump") + "run " + std::to_string(collisions::steps_of_run(steps)) + "\n";
    REQUIRE(place.run(deck) == 0);
    collisions::add_run(errors, place.frames("dump"), restitutions, dt, partner.wall);
  }
  // A nearly elastic Hertzian force ends as (t_e - t)^{3/2}, at which the cubic of contact_time does not look.
  collisions::report_and_check(model.name + ", " + partner.name, restitutions, errors,
                               model.name == "fractional-hertz" ? 0.9 : 1);
}

}  // namespace

TEST_CASE("a pair of grains reaches its collision time and restitution") {
  for (const Model& model : our_models()) check_series(model, {"pair", false, ""});
}

TEST_CASE("a grain on a primitive wall reaches its collision time and restitution") {
  for (const Model& model : our_models())
    check_series(model, {"primitive wall", true, "fix wall all wall/gran model LAW primitive type 1 xplane 0\n"});
}

TEST_CASE("a grain on a mesh wall reaches its collision time and restitution") {
  for (const Model& model : our_models())
    check_series(model, {"mesh wall", true,
                         "fix square all mesh/surface file square.stl type 1\n"
                         "fix wall all wall/gran model LAW mesh n_meshes 1 meshes square\n"});
}
