#include "liggghts_run.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/motion/column.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdio>

using namespace engines;

namespace {

constexpr double tcol = 1e-4, en = 0.945, speed = 0.5, gap = 1e-6, radius = 1.5e-3;
constexpr double duration = 40 * tcol, memory = 10 * tcol;
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

std::vector<double> velocities_in_engine(int steps, const Grain& bead) {
  const Box box{{-0.01, -0.01, 0}, {0.01, 0.01, 0.05}};
  std::vector<Grain> grains(beads, bead);
  for (int i = 0; i < beads; ++i) {
    grains[i].position = {0, 0, (2 * i + 1) * radius + (i + 1) * gap};
    grains[i].velocity = {0, 0, -speed};
  }
  const Workplace place("column_" + std::to_string(steps));
  const int count = static_cast<int>(std::lround(duration / tcol)) * steps;
  REQUIRE(place.run(preamble(box) + place.create(grains, box) + "neighbor 0.0005 bin\nneigh_modify delay 0\n" +
                    pair_property("collisionTime", tcol) + pair_property("coefficientRestitution", en) +
                    "fix memory all property/global memoryTime scalar " + number(memory) +
                    "\npair_style gran model fractional\npair_coeff * *\n"
                    "fix plate all wall/gran model fractional primitive type 1 zplane 0\n"
                    "fix move all nve/sphere\ntimestep " +
                    number(tcol / steps) + "\n" + dump_command("dump", count) + "run " + std::to_string(count) +
                    "\n") == 0);
  std::vector<double> velocity;
  for (const Vector& v : place.frames("dump").back().velocity) velocity.push_back(v[2]);
  return velocity;
}

}  // namespace

TEST_CASE("a column of ten beads leaves the plate as our own column engine has it") {
  const Grain bead{.radius = radius};
  const auto exact = reference(bead.mass());
  CHECK(exact.end != ricochet::ColumnEnd::out_of_time);
  std::vector<double> errors;
  for (int steps : {50, 100, 200}) {
    const auto velocity = velocities_in_engine(steps, bead);
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
  CHECK(std::log2(errors[1] / errors[2]) >= 1.5);
}
