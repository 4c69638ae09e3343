#include "column.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/motion/column.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace engines::column {

namespace {

constexpr double speed = 0.5, gap = 1e-6;
constexpr int beads = 10;

// A coefficient c^α k^{1−α} is all that a contact sees of k and c: any pair that gives it serves.
ricochet::Fractional law_at(double mass_eff) {
  const double alpha = ricochet::conversion_degree(en);
  const double coefficient = mass_eff * ricochet::fractional_contact(alpha).z_star / std::pow(tcol, 2 - alpha);
  return {coefficient, coefficient, alpha};
}

ricochet::ColumnResult reference(double mass) {
  ricochet::ColumnOptions options;
  options.step = tcol / 2000;
  options.duration = duration;
  options.longest_memory = memory;
  return ricochet::run_column(ricochet::equal_column(beads, mass, gap, -speed), law_at(mass), law_at(mass / 2),
                              options);
}

std::vector<Grain> falling_beads() {
  std::vector<Grain> grains(beads, Grain{.radius = radius});
  for (int i = 0; i < beads; ++i) {
    grains[i].position = {0, 0, (2 * i + 1) * radius + (i + 1) * gap};
    grains[i].velocity = {0, 0, -speed};
  }
  return grains;
}

std::vector<double> velocities_in_engine(const std::string& name, int steps, const Deck& deck) {
  const Workplace place(name + "_" + std::to_string(steps));
  const int last = static_cast<int>(std::lround(duration / tcol)) * steps;
  REQUIRE(place.run(deck(place, falling_beads(), tcol / steps, last)) == 0);
  std::vector<double> velocity;
  for (const Vector& v : place.frames("dump").back().velocity) velocity.push_back(v[2]);
  return velocity;
}

}  // namespace

void check(const std::string& name, const Deck& deck) {
  const auto exact = reference(Grain{.radius = radius}.mass());
  CHECK(exact.end != ricochet::ColumnEnd::out_of_time);
  std::vector<double> errors;
  for (int steps : {50, 100, 200}) {
    const auto velocity = velocities_in_engine(name, steps, deck);
    double energy = 0, worst = 0;
    for (int i = 0; i < beads; ++i) {
      energy += velocity[i] * velocity[i] / (beads * speed * speed);
      worst = std::max(worst, std::fabs(velocity[i] - exact.velocity[i]) / speed);
    }
    std::printf("column of %d, t_col/%d: E/E0 = %.7f (%.7f in our engine), velocities within %.1e of the impact's\n",
                beads, steps, energy, exact.energy_ratio, worst);
    errors.push_back(worst);
  }
  CHECK(errors[0] <= 1e-3);
  const double order = std::log2(errors[1] / errors[2]);
  CHECK(order >= 1.5);
  CHECK(order <= 2.5);
}

}  // namespace engines::column
