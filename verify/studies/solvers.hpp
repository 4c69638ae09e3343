#pragma once

#include "convergence.hpp"

#include <ricochet/collision/solvers/fractional_solvers.hpp>

namespace ricochet::verify {

/// One solver on meshes of growing N (steps in a contact), each at 16 offsets of the mesh against the contact's start:
/// relative errors of e_n, t_col and overlap at the end, and what they cost.
struct SolverConvergence {
  FractionalScheme scheme;
  Convergence en, tcol, overlap_end;
  std::vector<double> multiplications = {};     ///< mean a collision
  std::vector<double> kernel_evaluations = {};  ///< mean a collision
};

/// What errors are taken against: the closed form, or the exact motion under the kernel that the scheme has. The latter
/// is for the arms as differential equations, whose method has its order on a kernel that is kept.
enum class Against { closed_form, kept_kernel };

/// The (60) of a collision has α < 0: it is measured for −alpha, and has no overlap at the end.
/// For the collocation N is its number of nodes, and nothing is stated but that it is exact.
SolverConvergence measure(FractionalScheme scheme, double alpha, const std::vector<std::size_t>& steps,
                          Against against = Against::closed_form);

/// What the scheme's stated order is about.
Against stated_against(FractionalScheme scheme);

inline constexpr FractionalScheme stepping_schemes[] = {
    FractionalScheme::rectangle, FractionalScheme::trapezoid, FractionalScheme::arms_trapezoid,
    FractionalScheme::arms_exponential, FractionalScheme::arms_rosenbrock};

/// The same and (60), which is about a law of its own.
inline constexpr FractionalScheme studied_schemes[] = {
    FractionalScheme::rectangle,      FractionalScheme::rectangle_integral, FractionalScheme::trapezoid,
    FractionalScheme::arms_trapezoid, FractionalScheme::arms_exponential,   FractionalScheme::arms_rosenbrock};

}  // namespace ricochet::verify
