#pragma once

#include "report.hpp"

#include <calibrate/fit.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet::calibration {

/// The fitted laws as a run or an engine takes them: whole, at one impact. Collision times in the data make them so, or
/// a scale among the options. nullopt where neither is there; nothing of the fit is changed. What cannot run (α of the
/// speed) is infeasible, with the reason in words.
/// Throws console::BadInput where the options' scale contradicts the data's, or themselves.
std::optional<Report> run_of_fits(const Options& options, const std::vector<Fit>& fits,
                                  const std::vector<Measurement>& data);

}  // namespace ricochet::calibration
