#pragma once

#include <ricochet/contact/fractional.hpp>

#include <algorithm>

namespace ricochet::motion {

/// The best kernel that FractionalArms can carry: `tolerance` gives way tenfold until its arms suffice.
inline MemoryKernel affordable_kernel(double alpha, double shortest, double longest, double tolerance) {
  for (;; tolerance *= 10) {
    MemoryKernel kernel = memory_kernel(alpha, shortest, longest, std::min(tolerance, 0.1));
    if (kernel.arms().size() <= FractionalArms::max_arms) return kernel;
  }
}

}  // namespace ricochet::motion
