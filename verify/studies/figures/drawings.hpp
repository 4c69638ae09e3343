#pragma once

#include <console/plot.hpp>
#include <ricochet/collision/trace.hpp>

#include <string>
#include <vector>

namespace ricochet::verify::figures {

/// Overlap, velocity and force of the steel sphere for growing numbers of steps.
console::Figure figure2();
/// Over time and in phase, three groups of α.
console::Figure figure3();
console::Figure figure4();

/// Greatest distance of the solver's points in Figs. 3 and 4 from the closed form, in units of v₀.
double solver_distance();

/// A law of Table II with the printed coefficients.
struct PrintedLaw {
  std::string name;
  Collision collision;
  std::vector<Instant> points;
};

std::vector<PrintedLaw> table2_laws();

/// The collision of the pair under each of them.
console::Figure figure5(const std::vector<PrintedLaw>& laws);

}  // namespace ricochet::verify::figures
