#pragma once

#include <console/plot.hpp>
#include <verify/gate.hpp>

#include <vector>

namespace ricochet::verify::figures {

/// e_n of the laws of real solids over the speed, beside Kuwabara and Kono's and the paper's, all made for one
/// collision; and over α, at one group.
console::Figure solids_figure();

/// Where little is lost 1 − e_n goes with v₀ to the power α/5, of Kuwabara and Kono's law 1/5: the exponents between
/// two speeds.
std::vector<Gate> solids_gates();

}  // namespace ricochet::verify::figures
