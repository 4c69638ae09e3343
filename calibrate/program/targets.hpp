#pragma once

#include "job.hpp"

#include <console/exit.hpp>

namespace ricochet::calibration {

/// `calibrate --targets FILE`: every row of the file calibrated by the direct method, one row out per row in, in order,
/// on all cores and in constant memory. Returns gate_failed when a row failed; such a row keeps its place, with the
/// reason in its status.
console::Exit run_targets(const Options& options);

}  // namespace ricochet::calibration
