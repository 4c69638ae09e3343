#pragma once

#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/instant.hpp>

#include <vector>

namespace ricochet {

/// The fractional law with 1 ≤ α < 2 in time steps, from t_b to `until` [s]: n = 2 in (32). Integrated once, with
/// ζ(t_b) = 0 and the term of ζ'(t_b) that the Riemann-Liouville derivative keeps, the motion is
///   v = v₀ − A I^β v,  β = 2−α in (0, 1],  A = c^α k^{1−α}/m,
/// on which the product trapezoid, v linear in each step and the kernel integrated exactly, is implicit and linear.
///
/// Order in the number of steps, at a fixed time. v starts as v₀ − A v₀ t^β/Γ(1+β), so on a uniform mesh the first step
/// errs by h^β over a time h: order 1+β = 3−α. On t_n = until·(n/N)^r it is 2 from r > 2/(1+β) on; `graded` takes r a
/// tenth above. Errors of the overlap are of the same order; the force is left 0. Knows no Mittag-Leffler function.
/// Domain: 1 ≤ α < 2, until > 0, 1 ≤ steps ≤ 10000; throws std::invalid_argument otherwise. steps² / 2 powers.
std::vector<Instant> follow_permanent_contact(const Fractional& law, const Impact& impact, double until, int steps,
                                              bool graded);

}  // namespace ricochet
