#include "../paper.hpp"
#include "drawings.hpp"
#include "panels.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <cmath>

namespace ricochet::verify::figures {

namespace {

using paper::pair, paper::steel;

const Fractional steel_law(steel.k, steel.c, steel.alpha);

const std::vector<std::vector<double>> groups{{-0.5, -0.25, -0.1}, {0, 0.25, 0.5, 0.75, 0.9}, {1.1, 1.25, 1.5}};

Fractional law_of(double alpha) { return {paper::alpha_study_k, paper::alpha_study_c, alpha}; }

/// [s]; long enough for the slowest rebound.
double shown(double alpha) { return alpha < 1 ? 3e-4 : 2e-4; }

std::vector<Curve> alpha_curves() {
  std::vector<Curve> curves;
  for (std::size_t group = 0; group < groups.size(); ++group)
    for (std::size_t i = 0; i < groups[group].size(); ++i) {
      const double alpha = groups[group][i];
      const Fractional law = law_of(alpha);
      const int panel = static_cast<int>(group);
      curves.push_back({fmt::format("α = {}", alpha), closed_form(law, pair.impact, shown(alpha)), line(i), panel});
      if (alpha > 0.97) continue;  // there is no rebound to solve for
      const double step = curves.back().points.back().time / paper::steps;
      curves.push_back({"",
                        points_of(solve_collision(FractionalScheme::trapezoid, law, pair.impact, {.step = step}).path),
                        "with points pt 6 ps 0.5 lc rgb '#767676'", panel});
      curves.back().points.pop_back();  // past the end
    }
  return curves;
}

/// The title of each group.
const std::string names[] = {"α < 0: gains energy", "0 ≤ α < 1: rebounds", "α > 1: no rebound"};

}  // namespace

console::Figure figure2() {
  const Impact impact = steel.impact(steel.density);
  std::vector<Curve> curves;
  const FractionalTrajectory motion(steel_law.coefficient(), steel_law.alpha(), impact.mass_eff, impact.velocity);
  std::string missed[2];  // by the finest steps, at the end
  const FractionalScheme schemes[] = {FractionalScheme::rectangle, FractionalScheme::arms_exponential};
  for (int column = 0; column < 2; ++column) {
    for (const int steps : {5, 10, 20, 40}) {
      const FractionalSolverOptions options{.step = steel.tcol / steps, .end_time = steel.tcol};
      auto points = points_of(solve_collision(schemes[column], steel_law, impact, options).path);
      missed[column] = fmt::format("{:.0e}", std::fabs(points.back().rate - motion.rate(points.back().time)));
      points.front().force = 0;  // at t_b the arms' dashpot stands for what is not yet there
      curves.push_back({fmt::format("ΔN = {}", steps), points, "with linespoints lw 1.5 ps 0.6", column});
    }
    curves.push_back({"exact", closed_form(steel_law, impact, steel.tcol), "with lines lw 2 lc 'black'", column});
  }
  auto drawn =
      panels("figure2",
             "Fig. 2: overlap, velocity and force for growing numbers of steps; left (59) as written, right "
             "the arms with the exponential step.",
             curves, over_time, {{"(59) as written", "top right", 1}, {"arms, exponential step", "top right", 1}});
  drawn.finding = fmt::format(
      "With 40 steps (59) as written misses the last velocity by {} m/s, the arms with the exponential step by {} m/s.",
      missed[0], missed[1]);
  return drawn;
}

double solver_distance() {
  double worst = 0;
  for (const auto& group : groups)
    for (const double alpha : group) {
      if (alpha > 0.97) continue;
      const Fractional law = law_of(alpha);
      const FractionalTrajectory exact(law.coefficient(), alpha, pair.impact.mass_eff, pair.impact.velocity);
      const double step = closed_form(law, pair.impact, shown(alpha)).back().time / paper::steps;
      for (const auto& s : solve_collision(FractionalScheme::trapezoid, law, pair.impact, {.step = step}).path)
        if (!(std::fabs(s.rate - exact.rate(s.time)) <= worst)) worst = std::fabs(s.rate - exact.rate(s.time));
    }
  return worst / pair.impact.velocity;
}

console::Figure figure3() {
  auto drawn = panels(
      "figure3", "Fig. 3: overlap, velocity and force for three groups of alpha; circles: product trapezoid, 30 steps.",
      alpha_curves(), over_time, {{names[0], "top right", 1}, {names[1], "top right", 1}, {names[2], "top right", 1}});
  drawn.finding = fmt::format(
      "Below 0 the spheres leave faster than they came; between 0 and 1 they leave the slower the greater α; above 1 "
      "they stay together. The solver's points lie within {:.0e} of v0 of the closed form.",
      solver_distance());
  return drawn;
}

console::Figure figure4() {
  auto drawn =
      panels("figure4", "Fig. 4: phase curves for the three groups of alpha; circles: product trapezoid, 30 steps.",
             alpha_curves(), phases,
             {{names[0], "left center", 0}, {names[1], "left center", 0}, {names[2], "bottom left", 0}});
  drawn.finding =
      "The loops of velocity over overlap are closed by less and less velocity as α grows; above 1 they stay open.";
  return drawn;
}

}  // namespace ricochet::verify::figures
