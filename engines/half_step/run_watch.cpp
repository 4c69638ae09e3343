#include "run_watch.hpp"

#include <fmt/format.h>

namespace ricochet::half_step {

std::optional<RunWatch::Remark> RunWatch::look_at_kernel(double chosen_for, double dt) {
  if (dt == chosen_for) return std::nullopt;
  return Remark{
      fmt::format("timestep = {:.6g}: the memory kernel stays the one chosen for timestep = {:.6g}", dt, chosen_for)};
}

void RunWatch::begin_run(std::size_t kinds, std::int64_t first, std::int64_t last) {
  lightest_.assign(kinds, std::numeric_limits<double>::infinity());
  was_reset_ = next_first_ >= 0 && first != next_first_;
  first_ = first;
  next_first_ = last;
  coarse_said_ = soft_said_ = false;
}

std::optional<RunWatch::Remark> RunWatch::look_at_step(std::size_t kind, double mass_eff, double tcol, double dt) {
  lightest_[kind] = mass_eff;
  const double steps = tcol / dt;
  if (steps < least_steps)
    return Remark{fmt::format("timestep = {:.6g}: must be at most 1/{} of the shortest collision time, {:.6g} (1/{} is "
                              "advised)",
                              dt, least_steps, tcol, advised_steps),
                  true};
  if (steps * (1 + known_to) >= advised_steps || coarse_said_) return std::nullopt;
  coarse_said_ = true;
  return Remark{
      fmt::format("timestep = {:.6g} leaves {:.3g} steps to the shortest collision time, {:.6g}; {} are "
                  "advised",
                  dt, steps, tcol, advised_steps)};
}

RunWatch::Remark RunWatch::soft(double overlap, double radius) {
  soft_said_ = true;
  return {
      fmt::format("an overlap of {:.3g} % of the smaller radius: the contact is too soft for this load (of one "
                  "collision time the stiffness falls with the mass: small grains need a shorter one)",
                  100 * overlap / radius)};
}

// Later on it may be that of grains that have been apart.
std::optional<RunWatch::Remark> RunWatch::look_at_memory(std::int64_t now) {
  if (!was_reset_) return std::nullopt;
  was_reset_ = false;
  if (now != first_) return std::nullopt;
  return Remark{"reset_timestep while grains touch: their contacts have lost their memory and start anew"};
}

}  // namespace ricochet::half_step
