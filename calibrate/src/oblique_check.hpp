#pragma once

#include <calibrate/oblique_fit.hpp>

#include <vector>

namespace ricochet::calibration {

/// Throws std::invalid_argument naming what of the request or the data is outside its domain, or too little for two
/// unknowns.
void require_oblique(const ObliqueFitRequest& request, const std::vector<ObliqueMeasurement>& data);

}  // namespace ricochet::calibration
