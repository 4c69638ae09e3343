#pragma once

#include <ricochet/collision/reduction.hpp>

namespace ricochet {

/// The relative error of e_n that the rounding of a law's parameters to doubles may leave in a law that is made for it.
inline constexpr double reach_tolerance = 1e-10;

/// Is there a law of that kind that keeps e_n to `tolerance` and takes t_col [s] at this impact? In exact arithmetic
/// there always is, but for a law of real solids at what is held of it. The fractional law, whose k somebody holds, is
/// asked for e_n alone.
/// Throws as `unit_law` and `at_impact`.
bool reaches(LawKind kind, ContactEnd end, double en, double tcol, const Impact& impact,
             double tolerance = reach_tolerance, const Held& held = {});

/// The e_n that no law of that kind with this held falls to, however much it loses: what a springpot without its spring
/// keeps (Kelvin–Voigt, Hertz), or the least along τ (Zener). 0 of every other law, and where a contact ended by
/// overlap is longer and longer in coming to its end.
/// Throws std::invalid_argument for what is held outside its domain.
double restitution_bound(LawKind kind, ContactEnd end, const Held& held = {});

/// The least e_n above `missed`, which is not reached, that is: to three digits, upwards. Throws as `reaches`.
double least_restitution(LawKind kind, ContactEnd end, double missed, double tcol, const Impact& impact,
                         double tolerance = reach_tolerance, const Held& held = {});

}  // namespace ricochet
