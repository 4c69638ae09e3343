#pragma once

#include "job.hpp"

#include <console/exit.hpp>

namespace ricochet::calibration {

/// `calibrate --fit FILE`: each law fitted to measured restitution (and collision times), with what the data do not
/// tell.
console::Exit run_fit(const Options& options);

}  // namespace ricochet::calibration
