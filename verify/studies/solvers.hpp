#pragma once

#include "convergence.hpp"

#include <ricochet/motion/fractional_solvers.hpp>

namespace ricochet::verify {

/// One solver on meshes of growing N (steps in a contact), each at 16 offsets of the mesh against the contact's start:
/// errors of e_n, t_col and overlap at the end, and what they cost.
struct SolverConvergence {
  FractionalScheme scheme;
  Convergence en, tcol, overlap_end;       ///< relative errors
  std::vector<double> multiplications = {};     ///< mean a collision
  std::vector<double> kernel_evaluations = {};  ///< mean a collision
};

/// N = 16 … finest. For the collocation N is its number of nodes, 6 … 24, and nothing is stated but that it is exact at 24.
SolverConvergence measure(FractionalScheme scheme, double alpha, std::size_t finest);

inline constexpr FractionalScheme stepping_schemes[] = {
    FractionalScheme::rectangle, FractionalScheme::trapezoid, FractionalScheme::arms_trapezoid,
    FractionalScheme::arms_exponential, FractionalScheme::arms_rosenbrock};

}  // namespace ricochet::verify
