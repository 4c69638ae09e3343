#pragma once

#include <calibrate/calibration.hpp>

namespace ricochet::calibration {

/// The forward question: what a law of known parameters does at an impact. `request` then holds the target that it
/// would answer, (t_col, e_n) as `achieved`; nothing was searched, so that method and residuals say nothing.
/// Infeasible where the bodies do not part. The closed forms are confirmed by the numerical collision.
///
/// Throws std::invalid_argument for an impact outside its domain and an end that the law does not offer; NotConverged
/// where the collision could not be followed or the two ways contradict each other.
Outcome answer(const AnyLaw& law, ContactEnd end, const Impact& impact);

}  // namespace ricochet::calibration
