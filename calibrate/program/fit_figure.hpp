#pragma once

#include <calibrate/fit.hpp>
#include <console/plot.hpp>

#include <vector>

namespace ricochet::calibration {

/// Measured restitution (and collision times) with every law's curve, and under it what is left over. Laws of the same
/// curve share it.
console::Figure figure_of(const std::vector<Fit>& fits, const std::vector<Measurement>& data);

}  // namespace ricochet::calibration
