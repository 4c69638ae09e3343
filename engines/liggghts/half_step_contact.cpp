#include "half_step_contact.hpp"

#include <ricochet/support/require.hpp>
#include <ricochet/fractional/memory_kernel.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::liggghts {

namespace {

// The arms must fit the history's fixed slots; worse than 1 % is no memory.
MemoryKernel fitting_kernel(double alpha, double dt, double memory) {
  support::require(alpha >= 0 && alpha < 1, "alpha", alpha, "0 <= alpha < 1 (a contact that ends)");
  support::require_positive("dt", dt);
  support::require(std::isfinite(memory) && memory >= dt, "memory", memory, "at least one time step");
  MemoryKernel kernel = affordable_kernel(alpha, {dt, memory, 1e-7}, HalfStepContact::arm_slots);
  support::require(kernel.error() <= 1e-2, "memory/dt", memory / dt, "short enough for 12 arms");
  return kernel;
}

}  // namespace

double start_weight(double p, double theta) noexcept {
  const double first = 1 + theta;
  const double last = first + 2;
  const double sum = std::pow(first, p) + std::pow(first + 1, p);
  const double power = std::pow(last, p);
  const double inverse = 1 / last;
  const double tail =
      power * (last / (1 + p) - 0.5 + inverse * p / 12 - inverse * inverse * inverse * p * (1 - p) * (2 - p) / 720);
  return tail - sum;
}

HalfStepContact::HalfStepContact(double alpha, double dt, double memory)
    : kernel_(fitting_kernel(alpha, dt, memory)), law_(Fractional(1, 1, alpha), kernel_, dt) {}

FractionalArms::Memory HalfStepContact::memory_of(const double* history) const noexcept {
  FractionalArms::Memory memory;
  std::copy_n(history + arms, law_.arms(), memory.elongation.begin());
  return memory;
}

void HalfStepContact::start(double* history, double now, double half_step_rate, double dt) const noexcept {
  // A pair that already overlapped before it was first seen (inserted so, or a jumping wall) is loaded over one step.
  const double mean = std::max(half_step_rate, now / dt);
  const double theta = now / (mean * dt);
  const double p = 1 - alpha();
  FractionalArms::Memory memory;
  law_.advance(memory, {0, mean}, {now, mean}, theta * dt);
  std::copy_n(memory.elongation.begin(), arm_slots, history + arms);
  history[rate] = mean;
  history[older_rate] = 0;
  history[force] = start_weight(p, theta) * mean * std::pow(dt, p) / std::tgamma(1 + p);
}

double HalfStepContact::step_otherwise(double* history, Approach before, Approach after, double dt) const noexcept {
  FractionalArms::Memory memory = memory_of(history);
  law_.advance(memory, before, after, dt);
  std::copy_n(memory.elongation.begin(), law_.arms(), history + arms);
  return law_.force(after, memory);
}

double HalfStepContact::stored_energy(const double* history) const noexcept {
  return history[force] > 0 ? law_.stored_energy({history[overlap], history[rate]}, memory_of(history)) : 0;
}

double HalfStepContact::dissipated_energy(const double* before, const double* after, double dt) const noexcept {
  const bool started = before[stamp] + 1 != after[stamp];
  const double repulsion_before = started ? 0 : repulsion(before);
  const double mean = after[rate];
  if (started) {  // the work of a rate that is constant from t_b on
    const double since = after[overlap] / mean;
    const double work = mean * mean * std::pow(since, 2 - alpha()) / std::tgamma(3 - alpha());
    return work - stored_energy(after);
  }
  if (repulsion_before > 0 && after[force] > 0) {
    const double power_before = law_.dissipated_power({before[overlap], mean}, memory_of(before));
    return 0.5 * dt * (power_before + law_.dissipated_power({after[overlap], mean}, memory_of(after)));
  }
  const double work = 0.5 * (repulsion_before + repulsion(after)) * (after[overlap] - before[overlap]);
  return work + stored_energy(before) - stored_energy(after);
}

}  // namespace ricochet::liggghts
