#include "../lammps/meeting.hpp"
#include "../runs/collisions.hpp"
#include "laws.hpp"

#include <ricochet/collision/reduction.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace engines;
using collisions::tcol;

namespace {

// With α = 0.5 less than 0.3 is not to be had.
const std::vector<double> restitutions{0.4, 0.5, 0.7, 0.8, 0.95};

using LawFor = std::function<std::string(double en)>;

LawFor target_of(const Solid& solid) {
  return [solid](double en) { return solid.name + "/target " + number(tcol) + " " + number(en) + " " + solid.open; };
}

std::string between_pairs(const LawFor& law) {
  std::string text = one_law(law(0.5));
  for (std::size_t m = 0; m < restitutions.size(); ++m) {
    const std::string type = std::to_string(m + 1);
    text += pair_coeff(type + " " + type, law(restitutions[m]));
  }
  return text;
}

// The same wall for each type, as the plane x = 0 or as the face of a region.
std::string on_wall(const LawFor& law, bool of_region) {
  std::string text = one_law(law(0.5)) + "region room block 0 1 -1 1 -1 1 units box\n";
  for (std::size_t m = 0; m < restitutions.size(); ++m) {
    const std::string type = std::to_string(m + 1);
    std::string fix =
        wall("wall_" + type, "of_" + type, of_region ? "region room" : "xplane 0 NULL", law(restitutions[m]));
    if (of_region) fix.replace(fix.find("wall/gran"), 9, "wall/gran/region");
    text += "group of_" + type + " type " + type + "\n" + fix;
  }
  return text;
}

void check_series(const std::string& title, const LawFor& law, const std::string& against) {
  std::vector<collisions::Errors> errors;
  const bool wall = against != "pair";
  const Box box = collisions::box(restitutions.size(), wall);
  for (int steps : collisions::steps_per_contact) {
    const double dt = tcol / steps;
    std::string name = title + "_" + against + "_" + std::to_string(steps);
    std::replace(name.begin(), name.end(), '/', '_');
    const Workplace place(name);
    const auto grains = collisions::grains(restitutions.size(), dt, wall);
    REQUIRE(place.run(preamble(box) + place.create(grains, box) + neighbours() +
                      (wall ? on_wall(law, against == "region") : between_pairs(law)) + move(dt) + dump("dump") +
                      run(collisions::steps_of_run(steps))) == 0);
    collisions::add_run(errors, place.frames("dump"), restitutions, dt, wall);
  }
  // A nearly elastic Hertzian force ends as (t_e - t)^{3/2}, at which the cubic of contact_time does not look.
  collisions::report_and_check(title + ", " + against, restitutions, errors, title == "fractional/hertz" ? 0.9 : 1);
}

static_assert(tcol == meeting::tcol);
using meeting::dt, meeting::speed;

double restitution_with(const std::string& name, const std::string& laws,
                        const std::vector<Grain>& grains = meeting::grains) {
  Box types = meeting::box;
  for (const Grain& grain : grains) types.types = std::max(types.types, grain.type);
  const Workplace place(name);
  REQUIRE(place.run(preamble(types) + place.create(grains, types) + neighbours() + laws + move(dt) + dump("dump", 300) +
                    run(300)) == 0);
  const auto v = place.frames("dump").back().velocity;
  return (v[1][0] - v[0][0]) / speed;
}

// By its parameters as by the collision that they make.
template <class Law>
void check_parameters(const Solid& solid) {
  const double mass = meeting::grains[0].mass() / 2,
               velocity = std::is_same_v<Law, ricochet::FractionalHertz> ? speed : 1;
  const auto unit = ricochet::Reduction<Law>::unit(0.5, ricochet::ContactEnd::force, {});
  const auto law = ricochet::Reduction<Law>::in_si(unit->law, tcol, {velocity, mass});
  std::string given = solid.name;
  for (const double value : law->values()) given += " " + number(value);
  if (velocity != 1) given += " " + number(velocity);
  std::string name = solid.name;
  std::replace(name.begin(), name.end(), '/', '_');
  const double by_target = restitution_with(name + "_by_target", one_law(target_of(solid)(0.5)));
  CHECK(restitution_with(name + "_by_parameters", one_law(given)) == Approx(by_target).epsilon(1e-10));
  CHECK(by_target == Approx(0.5).epsilon(1e-3));
}

}  // namespace

TEST_CASE("laws of real solids reach their collision time and restitution, between grains and on planes") {
  for (const Solid& solid : solids)
    for (const char* against : {"pair", "plane"}) check_series(solid.name, target_of(solid), against);
}

TEST_CASE("a grain on a region's face collides as on a plane") {
  check_series(
      "fractional", [](double en) { return target(tcol, en); }, "region");
}

TEST_CASE("laws of real solids given by their parameters collide as by their target") {
  check_parameters<ricochet::FractionalKelvinVoigt>(solids[0]);
  check_parameters<ricochet::FractionalHertz>(solids[1]);
  check_parameters<ricochet::FractionalZener>(solids[2]);
}

TEST_CASE("laws of two types are mixed where their pair is not given: geometric means, of degrees the mean") {
  auto grains = meeting::grains;
  grains[1].type = 2;
  const std::string style = pair_style(),
                    two = pair_coeff("1 1", target(tcol, 0.5)) + pair_coeff("2 2", target(tcol, 0.8));
  const double mixed = restitution_with("mixed_targets", style + two, grains);
  CHECK(mixed == Approx(std::sqrt(0.5 * 0.8)).epsilon(1e-3));
  const double k = 5225, c = 0.297;
  const double given = restitution_with(
      "mixed_parameters",
      style + pair_coeff("1 1", parameters(k, c, 0)) + pair_coeff("2 2", parameters(4 * k, 9 * c, 0.4)), grains);
  CHECK(given == restitution_with("mean_parameters", one_law(parameters(2 * k, 3 * c, 0.2)), grains));
}
