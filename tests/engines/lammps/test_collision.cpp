#include "../runs/collisions.hpp"
#include "deck.hpp"

#include <ricochet/collision/collision.hpp>
#include <ricochet/contact/fractional.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>

using namespace engines;
using collisions::tcol;

namespace {

const std::vector<double> restitutions{0.1, 0.3, 0.5, 0.8, 0.95};

// Every type meets itself at its own restitution.
std::string types_of_pairs() {
  std::string text = one_law(target(tcol, 0.5));
  for (std::size_t m = 0; m < restitutions.size(); ++m) {
    const std::string type = std::to_string(m + 1);
    text += pair_coeff(type + " " + type, target(tcol, restitutions[m]));
  }
  // None of these meet: they may not change what others keep.
  for (std::size_t m = 1; m <= restitutions.size(); ++m)
    for (std::size_t n = m + 1; n <= restitutions.size(); ++n)
      text += pair_coeff(std::to_string(m) + " " + std::to_string(n), target(tcol, 0.6));
  return text;
}

std::string types_of_walls() {
  std::string text = one_law(target(tcol, 0.5));
  for (std::size_t m = 0; m < restitutions.size(); ++m) {
    const std::string type = std::to_string(m + 1);
    text += "group of_" + type + " type " + type + "\n" +
            wall("wall_" + type, "of_" + type, "xplane 0 NULL", target(tcol, restitutions[m]));
  }
  return text;
}

void check_series(const std::string& title, bool wall) {
  std::vector<collisions::Errors> errors;
  const Box box = collisions::box(restitutions.size(), wall);
  for (int steps : collisions::steps_per_contact) {
    const double dt = tcol / steps;
    const Workplace place("collision_" + title + "_" + std::to_string(steps));
    const auto grains = collisions::grains(restitutions.size(), dt, wall);
    REQUIRE(place.run(preamble(box) + place.create(grains, box) + neighbours() +
                      (wall ? types_of_walls() : types_of_pairs()) + move(dt) + dump("dump") +
                      run(collisions::steps_of_run(steps))) == 0);
    collisions::add_run(errors, place.frames("dump"), restitutions, dt, wall);
  }
  collisions::report_and_check(title, restitutions, errors);
}

}  // namespace

TEST_CASE("a pair of grains reaches its collision time and restitution") { check_series("pair", false); }

TEST_CASE("a grain on a plane reaches its collision time and restitution") { check_series("plane", true); }

TEST_CASE("k with c and α gives the collision that `collide` finds") {
  const Box box{{-0.01, -0.01, -0.01}, {0.01, 0.01, 0.01}};
  const ricochet::Fractional law(5225, 0.297, 0.3197);
  const Grain a{.position = {-1.6e-3, 0, 0}, .velocity = {0.25, 0, 0}},
      b{.position = {1.6e-3, 0, 0}, .velocity = {-0.25, 0, 0}};
  const ricochet::Collision exact = collide(law, {0.5, a.mass() / 2}, {});
  std::vector<double> errors;
  for (int steps : {50, 100, 200}) {
    const Workplace place("parameters_" + std::to_string(steps));
    const double dt = exact.tcol / steps;
    const int count = static_cast<int>(2e-4 / 0.5 / dt) + steps + steps / 5;
    REQUIRE(place.run(preamble(box) + place.create({a, b}, box) + neighbours() +
                      one_law(parameters(5225, 0.297, 0.3197)) + move(dt) + dump("dump", count) + run(count)) == 0);
    const auto v = place.frames("dump").back().velocity;
    errors.push_back(std::fabs((v[1][0] - v[0][0]) / 0.5 / exact.en - 1));
    CHECK(v[0][0] + v[1][0] == Approx(0).margin(1e-14));
  }
  std::printf("k, c, alpha: en off by %.1e, %.1e, %.1e at t_col/50, /100, /200\n", errors[0], errors[1], errors[2]);
  CHECK(errors[0] <= 1e-3);
  CHECK(errors[2] <= errors[0] / 8);
}
