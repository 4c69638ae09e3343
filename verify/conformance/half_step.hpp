#pragma once

#include "results.hpp"

#include "../studies/slider.hpp"

#include <optional>

namespace ricochet::verify::conformance {

// Steppings that engines are known to have, done here.

/// Where velocities live.
enum class Velocities {
  at_steps,  ///< velocity Verlet (LAMMPS, LIGGGHTS)
  behind     ///< half a step before the positions, from the start on (Yade)
};

/// A whole run, as an engine writes it: positions by the velocity in the middle of the step, forces from the new
/// positions and that same velocity, half a step before. Of cases on a line, by laws without memory or the hysteretic
/// one; else nothing.
std::optional<Run> half_step_run(const Case& of, int steps, Velocities velocities);

/// One oblique collision with an engine's rule for tangential spring and dashpot, in the limit of small steps (two
/// runs, extrapolated; 1e-6), the forces acting `place` overlaps inside the spheres: 0, at a radius, to 1. Of cases of
/// one collision with a spring and without torsion; else nothing.
std::optional<Solution> by_rule(const Case& of, Rule rule, double place);

}  // namespace ricochet::verify::conformance
