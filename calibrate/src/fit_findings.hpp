#pragma once

#include "fit_model.hpp"

namespace ricochet::calibration {

/// Throws std::invalid_argument naming what of the request or the data is outside its domain.
void require_fit(const FitRequest& request, const std::vector<Measurement>& data);
/// Throws std::invalid_argument unless there are more observations than unknowns.
void require_observations(const FitRequest& request, const std::vector<Measurement>& data, Eigen::Index unknowns);

/// Which residuals are ten times as far off the middle one as the middle distance from it, or as `least` where that is
/// more: rather slips than chance. None of fewer than five, of which nobody could say which is out.
std::vector<std::size_t> far_out(std::vector<double> residuals, double least);

/// What these data cannot tell, and what this law cannot do, in words; `at_the_edge`: parameters at the end of their
/// range.
std::vector<std::string> findings(const Fit& fit, const std::vector<std::string>& at_the_edge,
                                  const Eigen::VectorXd& residuals, const std::vector<Measurement>& data);

}  // namespace ricochet::calibration
