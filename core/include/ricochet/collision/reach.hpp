#pragma once

#include <ricochet/collision/reduction.hpp>

namespace ricochet {

/// The relative error of e_n that the rounding of a law's parameters to doubles may leave in a law that is made for it.
inline constexpr double reach_tolerance = 1e-10;

/// Is there a law of that kind that keeps e_n to `tolerance` and takes t_col [s] at this impact? In exact arithmetic
/// there always is. The fractional law, whose k somebody holds, is asked for e_n alone.
/// Throws as `unit_law` and `at_impact`.
bool reaches(LawKind kind, ContactEnd end, double en, double tcol, const Impact& impact,
             double tolerance = reach_tolerance);

/// The least e_n above `missed`, which is not reached, that is: to three digits, upwards. Throws as `reaches`.
double least_restitution(LawKind kind, ContactEnd end, double missed, double tcol, const Impact& impact,
                         double tolerance = reach_tolerance);

}  // namespace ricochet
