#pragma once

#include "sticking.hpp"

#include <variant>

namespace ricochet::calibration {

/// k_t √ζ for β₀ without dashpot, under the normal law that `stuck` has; Infeasible outside β₀'s first rise.
struct MindlinSpring {
  MindlinTangential law;
  double log_top = 0;  ///< of the first rise, in units of `unit_k`
};
std::variant<MindlinSpring, Infeasible> spring_for(double beta0, const AnyLaw& normal, ContactEnd end,
                                                   const Sticking& stuck, double unit_k);

/// The least c_t that gives β₀ beside Mindlin's spring k_t √ζ. No dashpot leaves β₀ to the free spring, an endless one
/// makes it 0; between them it is not monotone, so that its extremes are sought as well.
std::variant<MindlinTangential, Infeasible> dashpot_for(double beta0, double k, const AnyLaw& normal, ContactEnd end,
                                                        const Sticking& stuck);

}  // namespace ricochet::calibration
