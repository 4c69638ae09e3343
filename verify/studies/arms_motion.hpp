#pragma once

#include <ricochet/fractional/memory_kernel.hpp>

namespace ricochet::verify {

/// What ends by force of the motion ζ'' = −∫K(t − t')ζ'(t')dt' from ζ = 0, ζ' = 1.
struct ArmsMotion {
  double tcol, en, overlap_end;
};

/// The motion under a kernel K as its spring, arms and dashpot are, in closed form and without steps: ζ' has the
/// Laplace transform 1/(s + K̂(s)), K̂ = spring/s + Σ strength_j/(s + rate_j) + dashpot, whose poles are one between
/// every two neighbours of −rate_j and 0, and a pair that their sum and product leave. The end is looked for within a
/// fifth of `near`. To rounding, 1e-13 or so; the spring must be there.
ArmsMotion exact_motion(const MemoryKernel& kernel, double near);

}  // namespace ricochet::verify
