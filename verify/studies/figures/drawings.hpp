#pragma once

#include <console/plot.hpp>
#include <ricochet/collision/trace.hpp>

#include <string>
#include <vector>

namespace ricochet::verify::figures {

/// Overlap, velocity and force of the steel sphere for growing numbers of steps.
console::Figure figure2();
/// Over time in three groups of α, and all of them in phase.
console::Figure figure3();
console::Figure figure4();

/// Greatest distance of the solver's points in Fig. 3 from the closed form, in units of v₀.
double solver_distance();

/// The collision of Figs. 3 and 4 at one conversion degree.
Collision alpha_collision(double alpha, CollideMethod method = CollideMethod::automatic);
/// The conversion degrees that they draw, ascending.
std::vector<double> drawn_degrees();

/// The same collision at degrees of a reader's own in [-0.5, 2), over time, on a canvas of `size` "paper", two columns
/// of a journal, or "talk", a slide.
console::Figure chosen_degrees(const std::vector<double>& alphas, const std::string& size);

/// How that collision's time and restitution follow α.
struct DegreeSweep {
  std::vector<double> alpha, tcol, en;
};
DegreeSweep sweep_degrees();
console::Figure degree_figure(const DegreeSweep& sweep);

/// A law of Table II with the printed coefficients.
struct PrintedLaw {
  std::string name;   ///< the paper's
  std::string title;  ///< ours, "linear, ended by overlap"
  Collision collision;
  std::vector<Instant> points;
};

std::vector<PrintedLaw> table2_laws();
/// Their names from the greatest overlap at the end to the least.
std::vector<const PrintedLaw*> by_end_overlap(const std::vector<PrintedLaw>& laws);

/// The collision of the pair under each of them.
console::Figure figure5(const std::vector<PrintedLaw>& laws);

/// F and 𝒯 of Eqs. (36), (44), and by sums over the disc.
console::Figure disc_figure();
/// Greatest distance of the two.
double disc_distance();

}  // namespace ricochet::verify::figures
