#pragma once

#include "job.hpp"

#include <calibrate/oblique_fit.hpp>
#include <console/exit.hpp>

#include <string>
#include <vector>

namespace ricochet::calibration {

/// Is it a file of oblique impacts? Its head then has a tangential velocity or an angle of impact, in whatever unit,
/// and no restitution along the normal alone.
bool is_oblique(const std::string& path);

/// Oblique impacts of a CSV file: the angle of impact [deg] from the normal, with the speed or without, or the
/// velocities along and across the normal; e_t, the angle of rebound [deg], the spin after [1/s], in any mix, and their
/// standard errors; or `quantity` and `value`. Throws console::BadInput naming file and line, column, value and what is
/// accepted. `speed` [m/s]: where the file has none.
std::vector<ObliqueMeasurement> read_oblique(const std::string& path, double speed, std::vector<std::string>& ignored);

/// `calibrate --fit` of such a file: μ and β₀ beside the normal law of the flags.
console::Exit run_oblique_fit(const Options& options);

}  // namespace ricochet::calibration
