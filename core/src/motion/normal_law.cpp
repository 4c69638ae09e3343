#include <ricochet/motion/normal_law.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>

namespace ricochet {

MemoryKernel NormalLaw::kernel_for(double alpha, const NormalStepping& s, std::size_t most_arms) {
  const double shortest = 0.5 * s.step, longest = s.longest_contact > 0 ? s.longest_contact : 1e4 * s.step;
  support::require(longest <= 1e6 * shortest, "longest_contact", longest, "at most 5e5 steps with a fractional law");
  return affordable_kernel(alpha, {shortest, std::max(longest, shortest), s.kernel_tolerance}, most_arms);
}

void NormalLaw::require_degree(double alpha) {
  support::require(alpha >= 0 && alpha <= 1, "alpha", alpha, "in [0, 1] for particles in motion");
}

NormalLaw::NormalLaw(const AnyLaw& law) : law_(std::visit([](const auto& one) { return NormalLaw(one).law_; }, law)) {}

}  // namespace ricochet
