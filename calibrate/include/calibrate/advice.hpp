#pragma once

#include <calibrate/calibration.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet::calibration {

/// What a change of one parameter does to the collision: logarithmic derivatives, the percent that the result changes
/// for one percent of the parameter. Nothing where the parameter is 0 or cannot be moved in both directions.
struct Sensitivity {
  Parameter parameter;
  std::optional<double> tcol, en;
};

/// Central differences of `collide` over ±1e-4 of each parameter: the error is of the order of 1e-7.
std::vector<Sensitivity> sensitivities(const AnyLaw& law, ContactEnd end, const Impact& impact);

/// How far e_n is off when an engine takes that many steps a collision time.
struct StepError {
  int steps;     ///< t_col/Δt
  double error;  ///< greatest |e_n/target − 1| over sixteen places of the first touch within a step
};

/// The collision as engines step it, for 5 to 1000 steps a collision time: velocity Verlet, the force taken from the
/// position at the end of the step and the velocity at its middle (LAMMPS, LIGGGHTS, Yade), a contact found only once
/// the bodies overlap, the force clamped at zero where the contact ends by force. First order in the step, because
/// the touch is not located and the velocity lags. The fractional law is carried by Maxwell arms with a kernel error
/// of 1e-6.
std::vector<StepError> step_errors(const AnyLaw& law, ContactEnd end, const Target& target);

/// The least steps from which on the error stays within `bound`; nothing if 1000 do not suffice.
std::optional<int> steps_for(const std::vector<StepError>& errors, double bound);

}  // namespace ricochet::calibration
