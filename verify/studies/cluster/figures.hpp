#pragma once

#include "run.hpp"

#include <console/plot.hpp>

#include <vector>

namespace ricochet::verify::cluster {

console::Figure trajectories(const Run& strong, const Run& weak);            ///< Fig. 7
console::Figure velocities(const Run& strong, const Run& weak);              ///< Fig. 8
console::Figure sequence(const Run& strong, const Run& weak, double until);  ///< Fig. 9
console::Figure binary(const std::vector<Run>& strong, const std::vector<Run>& weak, double until);

}  // namespace ricochet::verify::cluster
