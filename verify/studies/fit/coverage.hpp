#pragma once

#include <calibrate/fit.hpp>

#include <string>
#include <vector>

namespace ricochet::verify {

/// How often a parameter's 95 % interval, value ± 1.96 standard errors, held the truth.
struct Coverage {
  calibration::FitRequest request;
  bool with_times = false;
  std::string parameter;
  double truth;
  double relative_error;  ///< the stated standard error over the value, on average
  double share;
};

/// One case a law, with and without collision times: synthetic measurements of a known law with known Gaussian errors
/// (0.01 in e_n, 2 % in t_col; a tenth of it for fractional-hertz), fitted `trials` times. The law's collisions are
/// `collide`'s, not the fit's own forward model.
struct CoverageCase {
  calibration::FitRequest request;
  bool with_times = false;
};

std::vector<CoverageCase> coverage_cases();

/// One of each parameter.
std::vector<Coverage> coverage_of(const CoverageCase& one, int trials);

}  // namespace ricochet::verify
