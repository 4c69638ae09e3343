#include <ricochet/motion/normal_law.hpp>

#include <ricochet/support/require.hpp>

#include <algorithm>

namespace ricochet {

namespace {

MemoryKernel new_kernel(double alpha, const NormalStepping& s, std::size_t most_arms) {
  const double shortest = 0.5 * s.step, longest = s.longest_contact > 0 ? s.longest_contact : 1e4 * s.step;
  support::require(longest <= 1e6 * shortest, "longest_contact", longest, "at most 5e5 steps with a fractional law");
  return affordable_kernel(alpha, {shortest, std::max(longest, shortest), s.kernel_tolerance}, most_arms);
}

}  // namespace

MemoryKernel NormalLaw::kernel_for(double alpha, const NormalStepping& s, std::size_t most_arms) {
  if (!s.made) return new_kernel(alpha, s, most_arms);
  const std::pair key(alpha, most_arms);
  const auto found = s.made->find(key);
  return found != s.made->end() ? found->second : s.made->emplace(key, new_kernel(alpha, s, most_arms)).first->second;
}

void NormalLaw::require_degree(double alpha) {
  support::require(alpha >= 0 && alpha <= 1, "alpha", alpha, "in [0, 1] for particles in motion");
}

NormalLaw::NormalLaw(const AnyLaw& law) : law_(std::visit([](const auto& one) { return NormalLaw(one).law_; }, law)) {}

}  // namespace ricochet
