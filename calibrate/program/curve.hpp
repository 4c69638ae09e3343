#pragma once

#include "report.hpp"

namespace ricochet::calibration {

/// The reports of a list of values of one number, in its order.
struct CurveReport {
  const Curve* curve;
  std::vector<Report> reports;  ///< one a value
};

/// Runs the options once a value. Throws as `job_of` and `run` do.
CurveReport run_curve(const Options& options);

/// A table a law and end with a row a value; as CSV one table of all, as JSON "ricochet/calibrations/1".
std::string render(const CurveReport& report, console::Format format);

}  // namespace ricochet::calibration
