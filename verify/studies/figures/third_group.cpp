#include "third_group.hpp"

#include "../paper.hpp"

#include <console/number.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/solvers/permanent_contact.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::figures {
namespace {

using console::Notation;

constexpr int finest = 512;

/// Mean of the orders of the last three pairs of meshes, each of which halves the one before.
double observed(const std::vector<double>& errors) { return std::log2(errors[errors.size() - 4] / errors.back()) / 3; }

ThirdGroup follow(double alpha) {
  const Impact impact{.velocity = paper::pair.impact.velocity, .mass_eff = paper::pair.impact.mass_eff};
  const Fractional law(paper::alpha_study_k, paper::alpha_study_c, alpha);
  const FractionalTrajectory exact(law.coefficient(), alpha, impact.mass_eff, impact.velocity);
  ThirdGroup group{.alpha = alpha, .steps = {}, .uniform = {}, .graded = {}, .distance = 0};
  const auto off = [&](const Instant& at) { return std::fabs(at.rate - exact.rate(at.time)) / impact.velocity; };
  for (int steps = 32; steps <= finest; steps *= 2) {
    const auto run = [&](bool graded) {
      return follow_permanent_contact(law, impact, paper::no_rebound_shown, steps, graded);
    };
    const auto path = run(true);
    group.steps.push_back(steps);
    group.uniform.push_back(off(run(false).back()));
    group.graded.push_back(off(path.back()));
    if (steps < finest) continue;
    for (auto at = path.begin() + 1; at != path.end(); ++at) group.distance = std::max(group.distance, off(*at));
  }
  return group;
}

}  // namespace

std::vector<ThirdGroup> third_group() {
  std::vector<ThirdGroup> groups;
  groups.reserve(paper::no_rebound_degrees.size());
  for (const double alpha : paper::no_rebound_degrees) groups.push_back(follow(alpha));
  return groups;
}

console::Table table(const std::vector<ThirdGroup>& groups) {
  const Notation error{Notation::Kind::scientific, 2}, order{Notation::Kind::fixed, 3};
  console::Table table({{"alpha"},
                        {"steps"},
                        {"uniform", "v0", error},
                        {"order", "", order},
                        {"graded", "v0", error},
                        {"order", "", order}},
                       "The third group, alpha >= 1, by time steps (n = 2 in (32)) against the closed form");
  for (const ThirdGroup& g : groups)
    for (std::size_t i = 0; i < g.steps.size(); ++i) {
      const auto pairwise = [&](const std::vector<double>& e) {
        return i == 0 ? console::blank() : console::Cell(std::log2(e[i - 1] / e[i]));
      };
      table.row(
          {g.alpha, std::int64_t{g.steps[i]}, g.uniform[i], pairwise(g.uniform), g.graded[i], pairwise(g.graded)});
    }
  for (const ThirdGroup& g : groups)
    table.note(fmt::format("alpha = {}: with {} graded steps nowhere further from the closed form than {:.0e} v0",
                           console::shortest(g.alpha), finest, g.distance));
  table.note(
      "errors of the velocity where the curves end; stated orders: 3 - alpha on uniform meshes, 2 on graded ones");
  return table;
}

std::vector<Gate> gates(const std::vector<ThirdGroup>& groups) {
  std::vector<Gate> all;
  for (const ThirdGroup& g : groups) {
    const std::string at = fmt::format("alpha = {}", console::shortest(g.alpha));
    all.push_back(near(at + ": order by time steps, uniform", observed(g.uniform), 3 - g.alpha, 0.1));
    all.push_back(near(at + ": order by time steps, graded", observed(g.graded), 2, 0.1));
  }
  return all;
}

}  // namespace ricochet::verify::figures
