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

/// The normal force whose μ-fold limits friction.
enum class Rubs {
  repulsion,  ///< as asked: the force that acts, but no attraction
  size,       ///< |F| of the force that acts, be it attraction
  unclipped,  ///< |F| before attraction is clipped
  spring      ///< what acts without the dashpot's share
};

/// How many overlaps inside the spheres, from 0, at a radius, to 1; engines have the two apart (docs/engines.md).
struct Places {
  double force = 0;  ///< where friction acts
  double slip = 0;   ///< of which the velocity is its slip
};

/// One oblique collision with an engine's rule for tangential spring and dashpot, in the limit of small steps (two
/// runs, extrapolated; 1e-6). Of cases of one collision with a spring, the disc's shared limit of sliding and torsion
/// excepted; else nothing.
std::optional<Solution> by_rule(const Case& of, Rule rule, Places places, Rubs rubs = Rubs::repulsion);

}  // namespace ricochet::verify::conformance
