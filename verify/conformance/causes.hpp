#pragma once

#include "grade.hpp"

namespace ricochet::verify::conformance {

/// How closely a repeated run must meet an engine's, its printed digits apart: sums of thousands of steps in another
/// order, coefficients by a formula of the engine's own.
inline constexpr double repeated_to = 1e-8;

/// A cause of a limit is told where it is nearer than what was asked, and others than it farther, by this factor.
inline constexpr double clearly = 3;

inline constexpr const char* half_a_step_before = "forces take the velocity of half a step before";

/// What explains a grade that is not exact, the best first, and after it what does so equally well; none where nothing
/// known does.
///
/// First, the engine's stepping repeated: velocity Verlet with the velocity of half a step before (which is told where
/// forces feel it), of the case as asked and, where the limit is elsewhere, of each misunderstanding below; all
/// required answers at all steps within `repeated_to` of their scales and the digits printed. Then, for a limit
/// elsewhere, what has the engine's limits: every required answer within the limit's uncertainty and what it is itself
/// known to, the forces acting at any one place between a radius from the centres and the touched surface, wherever it
/// fits best.
///
/// A misfit is the greatest difference of a required answer, as a share of its scale. A cause is told only if that of
/// what was asked, at the best place for it, is `clearly` times as great or more; with the best are told those that fit
/// and are not `clearly` worse.
///
/// A misunderstanding is another case, answered by the case's own solver: the other end of the contact (clipped or
/// unclipped attraction), coefficients per mass with twice the effective mass or half of it, damping off by 2, 1/2, √2,
/// 1/√2 or left out, friction left out or without its spring, k_t off by 2 or 1/2, no torsion, no rolling resistance.
/// Of oblique collisions and torsion also (`by_rule`) an engine's rule for tangential springs, another normal force
/// that limits friction, the other end, and any two or three of them together.
std::vector<Cause> causes(const Answered& answered, const CaseResult& result, const CaseGrade& grade);

/// The grade with its causes; `another_rule` where one of them is a rule for tangential springs that engines have;
/// `converges` where every run is repeated by steps of what was asked, wherever the few runs seem to go.
CaseGrade explained(const Answered& answered, const CaseResult* result);

}  // namespace ricochet::verify::conformance
