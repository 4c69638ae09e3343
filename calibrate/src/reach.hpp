#pragma once

#include <calibrate/calibration.hpp>

namespace ricochet::calibration {

/// The relative error that rounding the law's parameters to doubles leaves in e_n. In exact arithmetic every e_n in (0,
/// 1] can be reached; `law` is the one in the units of the target.
double rounding_error(const AnyLaw& law, ContactEnd end, double en);

/// The bound of `collide` for its numerical path, at the answer.
double check_error(const AnyLaw& law, ContactEnd end, double en);

/// What to say of a request that rounding keeps from the tolerance, or that has a parameter that is no normal double.
Infeasible out_of_reach(const Request& request, double tolerance);

}  // namespace ricochet::calibration
