#include "run_advice.hpp"

#include <ricochet/support/text.hpp>

namespace ricochet::half_step {

using support::significant;

std::string too_coarse(double dt, double tcol) {
  return "timestep = " + significant(dt, 6) + ": must be at most 1/" + significant(least_steps, 6) +
         " of the shortest collision time, " + significant(tcol, 6) + " (1/" + significant(advised_steps, 6) +
         " is advised)";
}

std::string coarse(double dt, double tcol) {
  return "timestep = " + significant(dt, 6) + " leaves " + significant(tcol / dt, 3) +
         " steps to the shortest collision time, " + significant(tcol, 6) + "; " + significant(advised_steps, 6) +
         " are advised";
}

std::string too_soft(double share, std::string_view tcol) {
  return "an overlap of " + significant(100 * share, 3) +
         " % of the smaller radius: the contact is too soft for this load (of one " + std::string(tcol) +
         " the stiffness falls with the mass: small grains need a shorter one)";
}

}  // namespace ricochet::half_step
