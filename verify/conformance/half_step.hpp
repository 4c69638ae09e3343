#pragma once

#include "results.hpp"

#include "../studies/slider.hpp"

#include <optional>

namespace ricochet::verify::conformance {

// Steppings that engines are known to have, done here.

/// Velocity Verlet as LAMMPS, LIGGGHTS and (with velocities half a step behind) Yade do it: positions by the velocity
/// in the middle of the step, forces from the new positions and that same velocity, half a step before. The whole run,
/// as an engine writes it. Of cases on a line, by laws without memory or the hysteretic one; else nothing.
std::optional<Run> half_step_run(const Case& of, int steps);

/// One oblique collision with an engine's rule for tangential spring and dashpot, in the limit of small steps (two runs,
/// extrapolated; 1e-6). Of cases of one collision with a spring and without torsion; else nothing.
std::optional<Solution> by_rule(const Case& of, Rule rule);

}  // namespace ricochet::verify::conformance
