#include "half_step_contact.hpp"

#include <ricochet/fractional/memory_kernel.hpp>
#include <ricochet/support/require.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::half_step {

namespace {

template <class Law>
bool ends(const Law& law) noexcept {
  if constexpr (requires { law.force_fades(); })
    if (law.force_fades()) return false;
  return law.alpha() >= 0 && (law.alpha() < 1 || !std::is_same_v<Law, Fractional>);
}

// The arms must fit the history's fixed slots; worse than 1 % is no memory.
template <class Law>
MemoryKernel fitting_kernel(const Law& law, double dt, double memory) {
  constexpr std::size_t more = MaxwellArms::max_arms - Law::Arms::max_kernel_arms;  // than its kernel's has a law
  support::require(ends(law), "alpha", law.alpha(), "0 <= alpha < 1 (a contact that ends)");
  support::require_positive("dt", dt);
  support::require(std::isfinite(memory) && memory >= dt, "memory", memory, "at least one time step");
  MemoryKernel kernel = affordable_kernel(law.alpha(), {dt, memory, 1e-7}, ContactHistory::arm_slots - more);
  support::require(kernel.error() <= 1e-2, "memory/dt", memory / dt, "short enough for 12 arms");
  return kernel;
}

}  // namespace

template <class Law>
LocatedContact<Law>::LocatedContact(const Law& law, double dt, double memory)
    : LocatedContact(law, fitting_kernel(law, dt, memory), dt) {}

template <class Law>
typename LocatedContact<Law>::Arms::Memory LocatedContact<Law>::memory_of(const double* history) const noexcept {
  typename Arms::Memory memory;
  std::copy_n(history + arms, arms_law_.arms(), memory.elongation.begin());
  return memory;
}

template <class Law>
void LocatedContact<Law>::start(double* history, double now, double half_step_rate, double dt) const noexcept {
  // A pair that already overlapped before it was first seen (inserted so, or a jumping wall) is loaded over one step.
  const double mean = std::max(half_step_rate, now / dt);
  const double theta = now / (mean * dt);
  typename Arms::Memory memory;
  arms_law_.advance(memory, {0, mean}, {now, mean}, theta * dt);
  std::copy_n(memory.elongation.begin(), arm_slots, history + arms);
  history[rate] = mean;
  history[older_rate] = 0;
  history[force] = first_kick(law(), mean, theta, dt);
}

template <class Law>
double LocatedContact<Law>::step_otherwise(double* history, Approach before, Approach after, double dt) const noexcept {
  typename Arms::Memory memory = memory_of(history);
  arms_law_.MaxwellArms::advance(memory, before, after, dt);
  std::copy_n(memory.elongation.begin(), arms_law_.arms(), history + arms);
  return arms_law_.MaxwellArms::force(after, memory);
}

template <class Law>
double LocatedContact<Law>::stored_energy(const double* history) const noexcept {
  return history[force] > 0 ? arms_law_.stored_energy({history[overlap], history[rate]}, memory_of(history)) : 0;
}

template <class Law>
double LocatedContact<Law>::dissipated_energy(const double* before, const double* after, double dt) const noexcept {
  const bool started = before[stamp] + 1 != after[stamp];
  const double repulsion_before = started ? 0 : repulsion(before);
  const double mean = after[rate];
  if (started) return first_work(law(), mean, after[overlap] / mean) - stored_energy(after);
  if (repulsion_before > 0 && after[force] > 0) {
    const double power_before = arms_law_.dissipated_power({before[overlap], mean}, memory_of(before));
    return 0.5 * dt * (power_before + arms_law_.dissipated_power({after[overlap], mean}, memory_of(after)));
  }
  const double work = 0.5 * (repulsion_before + repulsion(after)) * (after[overlap] - before[overlap]);
  return work + stored_energy(before) - stored_energy(after);
}

template class LocatedContact<Fractional>;
template class LocatedContact<FractionalKelvinVoigt>;
template class LocatedContact<FractionalHertz>;
template class LocatedContact<FractionalZener>;

}  // namespace ricochet::half_step
