#include "../paper.hpp"
#include "drawings.hpp"
#include "panels.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/solvers/fractional_solvers.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::verify::figures {

namespace {

using paper::pair, paper::steel;

const Fractional steel_law(steel.k, steel.c, steel.alpha);

const std::vector<std::vector<double>> groups{{-0.5, -0.25, -0.1},
                                              {0, 0.25, 0.5, 0.75, 0.9},
                                              {paper::no_rebound_degrees.begin(), paper::no_rebound_degrees.end()}};

Fractional law_of(double alpha) { return {paper::alpha_study_k, paper::alpha_study_c, alpha}; }

/// What ends the collision, or for how long one that does not end is shown [s].
double shown(double alpha) {
  const Collision out = alpha_collision(alpha);
  return out.separated() ? out.tcol : paper::no_rebound_shown;
}

std::vector<Path> alpha_paths() {
  std::vector<Path> paths;
  for (std::size_t group = 0; group < groups.size(); ++group)
    for (std::size_t i = 0; i < groups[group].size(); ++i) {
      const double alpha = groups[group][i];
      paths.push_back(
          {fmt::format("α = {}", alpha), closed_form(law_of(alpha), pair.impact, shown(alpha)), line(i), group});
    }
  return paths;
}

/// By the product trapezoid in thirty steps; past the end by one of them.
std::vector<Instant> solved(double alpha) {
  return solve_collision(FractionalScheme::trapezoid, law_of(alpha), pair.impact, {.step = shown(alpha) / paper::steps})
      .path;
}

/// The title of each group.
const std::string names[] = {"α < 0: gains energy", "0 ≤ α < 1: rebounds", "α ≥ 1: no rebound"};

}  // namespace

Collision alpha_collision(double alpha, CollideMethod method) {
  return collide(law_of(alpha), pair.impact, {.method = method});
}

std::vector<double> drawn_degrees() {
  std::vector<double> all;
  for (const auto& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

console::Figure figure2() {
  const Impact impact = steel.impact(steel.density);
  std::vector<Path> paths;
  const FractionalTrajectory motion(steel_law.coefficient(), steel_law.alpha(), impact.mass_eff, impact.velocity);
  std::string missed[2];  // by the finest steps, at the end
  const FractionalScheme schemes[] = {FractionalScheme::rectangle, FractionalScheme::arms_exponential};
  for (std::size_t column = 0; column < 2; ++column) {
    for (const int steps : {5, 10, 20, 40}) {
      const FractionalSolverOptions options{.step = steel.tcol / steps, .end_time = steel.tcol};
      auto points = solve_collision(schemes[column], steel_law, impact, options).path;
      missed[column] = fmt::format("{:.0e}", std::fabs(points.back().rate - motion.rate(points.back().time)));
      points.front().force = 0;  // at t_b the arms' dashpot stands for what is not yet there
      paths.push_back({fmt::format("ΔN = {}", steps), points, "linespoints lw 1.5 ps 0.6", column});
    }
    paths.push_back({"exact", closed_form(steel_law, impact, steel.tcol), "lines lw 2 lc rgb 'black'", column});
  }
  auto drawn =
      panels("figure2",
             "Fig. 2: overlap, velocity and force for growing numbers of steps; left (59) with left values, "
             "right the arms with the exponential step.",
             paths, over_time, {{"(59), left values", "top right", 1}, {"arms, exponential step", "top right", 1}});
  drawn.finding = fmt::format(
      "With 40 steps (59) with left values misses the last velocity by {} m/s, the arms with the exponential step by "
      "{} "
      "m/s.",
      missed[0], missed[1]);
  return drawn;
}

double solver_distance() {
  double worst = 0;
  for (const double alpha : drawn_degrees()) {
    if (alpha >= 1) continue;
    const Fractional law = law_of(alpha);
    const FractionalTrajectory exact(law.coefficient(), alpha, pair.impact.mass_eff, pair.impact.velocity);
    for (const Instant& s : solved(alpha)) {
      const double off = std::fabs(s.rate - exact.rate(s.time));
      if (!(off <= worst)) worst = off;
    }
  }
  return worst / pair.impact.velocity;
}

console::Figure figure3() {
  std::vector<Path> paths = alpha_paths();
  for (std::size_t group = 0; group < 2; ++group)
    for (const double alpha : groups[group]) {
      auto points = solved(alpha);
      points.pop_back();
      paths.push_back({"", points, "points pt 6 ps 0.5 lc rgb '#767676'", group});
    }
  const double first_force = paper::alpha_study_c * pair.impact.velocity;  // of the dashpot
  const Ranges right{.time = std::pair(0.0, 1e6 * paper::no_rebound_shown), .force = std::pair(0.0, 1.2 * first_force)};
  auto drawn = panels(
      "figure3", "Fig. 3: overlap, velocity and force for three groups of alpha; circles: product trapezoid, 30 steps.",
      paths, over_time, {{names[0], "top right", 1}, {names[1], "top right", 1}, {names[2], "top right", 1, right}});
  drawn.finding = fmt::format(
      "Below 0 the spheres leave faster than they came, and the sooner the smaller α: after {:.1f} µs at -0.1, {:.1f} "
      "µs at -0.5. Between 0 and 1 they leave the slower and the later the greater α; from 1 on they stay together. "
      "The "
      "solver's points lie within {:.0e} of v0 of the closed form.",
      1e6 * alpha_collision(-0.1).tcol, 1e6 * alpha_collision(-0.5).tcol, solver_distance());
  return drawn;
}

console::Figure figure4() {
  std::vector<Path> paths = alpha_paths();
  // As in Fig. 3, and the group by its dashes; the gaps are short, so that the ends show.
  constexpr std::array dashes{"(6,2)", "1", "3"};
  for (std::size_t group = 0, k = 0; group < groups.size(); ++group)
    for (std::size_t i = 0; i < groups[group].size(); ++i) paths[k++].style = line(i, dashes.at(group));
  // What dashpot and spring need; past α = 1 the overlap grows without end, and the force begins infinite.
  const double dashpot = pair.impact.velocity * pair.impact.mass_eff / paper::alpha_study_c;
  const double strongest = alpha_collision(groups[0].front()).max_force;
  const Ranges ranges{.overlap = std::pair(0.0, 1.25e6 * dashpot), .force = std::pair(0.0, 1.05 * strongest)};
  auto drawn = overlaid(
      "figure4", "Fig. 4: phase curves of every alpha of Fig. 3: velocity and force over overlap, force over velocity.",
      paths, phases, ranges);
  drawn.finding = fmt::format(
      "The loops of velocity over overlap are closed by less and less velocity as α grows. At α = 1 the velocity falls "
      "on a straight line to rest at {:.1f} µm; above 1 it leaves the picture, and no force turns it back.",
      1e6 * dashpot);
  return drawn;
}

console::Figure chosen_degrees(const std::vector<double>& alphas, const std::string& size) {
  const Canvas canvas = size == "talk" ? Canvas{1280, 720, 1.5} : Canvas{672, 560, 1};
  std::vector<Path> paths;
  Ranges ranges;
  double last = 0, strongest = 0;
  for (std::size_t i = 0; i < alphas.size(); ++i) {
    const double until = shown(alphas[i]);
    last = std::max(last, until);
    paths.push_back({fmt::format("α = {}", alphas[i]), closed_form(law_of(alphas[i]), pair.impact, until),
                     line(i, std::to_string(1 + i / line_colours))});
    // Past 1 the force begins infinite: of it as much is shown as a dashpot begins with.
    const double dashpot = 1.2 * paper::alpha_study_c * pair.impact.velocity;
    strongest = std::max(strongest, alphas[i] > 1 ? dashpot : 1.03 * alpha_collision(alphas[i]).max_force);
  }
  ranges.time = std::pair(0.0, 1.03e6 * last);
  ranges.force = std::pair(0.0, strongest);
  return overlaid("alphas", "The collision of Figs. 3 and 4 at chosen conversion degrees: overlap, velocity and force.",
                  paths, over_time, ranges, canvas);
}

}  // namespace ricochet::verify::figures
