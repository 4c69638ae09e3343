#pragma once

#include "grade.hpp"

namespace ricochet::verify::conformance {

/// How closely a repeated run must meet an engine's: sums of thousands of steps in another order, coefficients by a
/// formula of the engine's own.
inline constexpr double repeated_to = 1e-8;

/// What explains a grade that is not exact, the best first; none where nothing known does.
///
/// First, the engine's stepping repeated: velocity Verlet with the velocity of half a step before, of the case as asked
/// and, where the limit is elsewhere, of each misunderstanding below; all required answers at all steps within
/// `repeated_to` of their scales. Then, for a limit elsewhere, the misunderstandings whose own limit is the engine's:
/// every required answer within its uncertainty and what the answer is known to.
///
/// A misunderstanding is another case, answered by the case's own solver: the other end of the contact (clipped or
/// unclipped attraction), coefficients per mass with twice the effective mass or half of it, damping off by 2, 1/2, √2,
/// 1/√2 or left out, friction left out or without its spring, k_t off by 2 or 1/2, no torsion, no rolling resistance;
/// or an engine's rule for tangential springs (`by_rule`).
std::vector<Cause> causes(const Answered& answered, const CaseResult& result, const CaseGrade& grade);

}  // namespace ricochet::verify::conformance
