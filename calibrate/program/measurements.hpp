#pragma once

#include <calibrate/fit.hpp>

#include <string>
#include <vector>

namespace ricochet::calibration {

/// The rows of a CSV file with the columns velocity [m/s], en and any of en_sigma, tcol [s], tcol_sigma [s]. Throws
/// console::BadInput naming file and line, column, value and what is accepted.
std::vector<Measurement> read_measurements(const std::string& path);

}  // namespace ricochet::calibration
