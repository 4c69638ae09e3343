#pragma once

#include <calibrate/calibration.hpp>

namespace ricochet::calibration {

/// What to say of a request that rounding keeps from the tolerance, or that has a parameter that is no normal double.
Infeasible out_of_reach(const Request& request, double tolerance);

}  // namespace ricochet::calibration
