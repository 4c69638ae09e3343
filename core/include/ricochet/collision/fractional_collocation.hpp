#pragma once

#include <ricochet/collision/collision.hpp>

namespace ricochet {

/// A binary collision of the fractional law (30) in the units m = v₀ = c^α k^{1−α} = 1: times in A^{−1/(2−α)},
/// A = c^α k^{1−α}/m; overlaps in v₀ times that; forces in m v₀ over that. Where the asked end was not found every
/// number of the collision is 0.
struct FractionalSolution : Collision {
  double error_estimate = 0;  ///< last Chebyshev coefficients of the rate, relative to e_n
  int nodes = 0;              ///< collocation nodes of the last system
  int solves = 0;             ///< linear systems of that size: more than one where the first interval was too short
};

/// Solves the collision by `collocate_motion` with the given number of nodes and locates its events as roots of the
/// polynomials. Does not use the Mittag-Leffler function. From 24 nodes on t_col and e_n are accurate to 1e-10 relative
/// for −1 ≤ α ≤ 0.97. α ≥ 1 never separates; by overlap only α < 0.40088… does; α < 0 ends by overlap, whichever end is
/// asked for.
/// Domain: −1 ≤ α < 2, 4 ≤ nodes ≤ 120; throws std::invalid_argument otherwise.
FractionalSolution collocate_collision(double alpha, int nodes = 32, ContactEnd end = ContactEnd::force);

}  // namespace ricochet
