#pragma once

#include <ricochet/contact/fractional.hpp>
#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/instant.hpp>

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

namespace ricochet {

/// Ways to solve m ζ'' + c^α k^{1−α} D^α ζ = 0, ζ(0) = 0, ζ'(0) = v₀, by time steps. Orders are those of t_col and e_n
/// in the step h; docs/theory/orders.md derives them. v is ζ', β = 2−α.
enum class FractionalScheme {
  /// (59) with left values in a predictor-corrector, v_{n+1} = v_n + h/2 (a_n + a_{n+1}). (59) gives the present rate
  /// no weight, so the predictor has nothing to say and one correction is all. Order 1. The digits of Table I exclude
  /// that the paper ran this (`verify table1`).
  rectangle,
  /// The same with (60) for α < 0: R = c^α k^{1−α} I^{−α} ζ from the overlaps. (60) gives the present overlap no
  /// weight, so the step is explicit. Order 1.
  rectangle_integral,
  /// Product trapezoid, P(EC)²E (Diethelm, Ford, Freed, Nonlinear Dyn. 29, 3 (2002)) on the Volterra form
  /// v = v₀ − A I^β v: the rectangle (60) predicts, the trapezoid corrects twice, because once would leave the
  /// predictor's error at order 3−α, next to the 2 that is to be seen. Order 2.
  trapezoid,
  /// FractionalArms with the implicit trapezoid v_{n+1} = v_n − h/2m (F_n + F_{n+1}), as an engine may step them. The
  /// force starts as t^{1−α}, which the trapezoid integrates with an error of order 2−α: order 2−α with δ = h.
  arms_trapezoid,
  /// The same arms with the impulse of spring, arms and dashpot integrated exactly for a rate linear over the step,
  /// implicit. Order 2.
  arms_exponential,
  /// The arms as stiff ordinary differential equations, by Rosenbrock's method of order 4 (Boost.Odeint). Order 4 in h
  /// for a kernel that is kept; the kernel's own error stays.
  arms_rosenbrock,
  /// Collocation on the whole contact, see collocate_motion; `nodes` instead of steps, converging faster than any
  /// power.
  collocation
};

std::string_view name(FractionalScheme scheme) noexcept;

struct FractionalSolverOptions {
  double step = 0;    ///< h [s] > 0 (not used by collocation)
  double offset = 0;  ///< in [0, 1): t_b lies this part of a step after a mesh point, so the first step is (1−offset) h
  double end_time = 0;  ///< [s] > 0: go on through the mesh points up to this time, not to the force's zero
  int nodes = 24;       ///< of the collocation
  std::optional<MemoryKernel> kernel = {};  ///< of the arms; empty: one for δ = step and 1e-10, see solver_kernel
};

/// The memory kernel that the solvers make for themselves: from `shortest` [s] to the longest contact they follow. To
/// be prepared once where many collisions share it.
MemoryKernel solver_kernel(const Fractional& law, const Impact& impact, double shortest, double tolerance = 1e-10);

/// Status, tcol, en and overlap_end of a collision that ends by force, for α < 0 by overlap (the extremes stay 0), and
/// what it took. With end_time: tcol is the last mesh point, status budget_spent.
struct FractionalSolverResult : Collision {
  std::size_t steps = 0;
  std::size_t kernel_evaluations = 0;  ///< powers and exponentials taken
  std::size_t multiplications = 0;     ///< of samples or states by weights
  std::vector<Instant> path = {};      ///< at t_b and at each mesh point (empty for collocation)
};

/// One collision by one scheme. The memory starts at t_b, inside the first step; the end is located inside the last
/// step by cubic interpolation of the force through the last four mesh points and Hermite's of rate and overlap; where
/// the overlap ends it, by the latter alone.
/// Following more than 4 (α < 0.8) or 7 natural times A^{−1/(2−α)} without an end is no_separation.
/// Domain: 0 < α ≤ 0.97 (trapezoid: −1 ≤ α ≤ 0.97, rectangle_integral: −1 ≤ α < 0), step shorter than the longest
/// contact; throws std::invalid_argument otherwise.
FractionalSolverResult solve_collision(FractionalScheme scheme, const Fractional& law, const Impact& impact,
                                       const FractionalSolverOptions& options);

}  // namespace ricochet
