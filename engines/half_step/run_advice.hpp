#pragma once

#include <string>
#include <string_view>

namespace ricochet::half_step {

// What an engine's driver tells of the run that it is in, in the same words whatever the engine.

/// Collision times over time steps: fewer than the first are warned of, than the second refused.
inline constexpr double advised_steps = 20, least_steps = 4;
/// Overlaps of more than this part of the smaller radius are warned of.
inline constexpr double soft_overlap = 0.1;
/// A contact that lasts longer than this many steps is carried on by the kernel's spring, unless its user says more.
inline constexpr double default_memory_steps = 1e3;

/// Of a time step dt [s] above tcol/least_steps, tcol [s] the shortest collision time.
std::string too_coarse(double dt, double tcol);
/// Of one between that and tcol/advised_steps.
std::string coarse(double dt, double tcol);
/// Of an overlap of this share of the smaller radius; `tcol` is what the engine's users call the collision time.
std::string too_soft(double share, std::string_view tcol);
/// Of contacts whose last step is not the one before.
inline constexpr std::string_view forgotten =
    "reset_timestep while grains touch: their contacts have lost their memory and start anew";
/// Of a run whose time step is not the one that the arms were chosen for.
inline constexpr std::string_view kept_kernel = "keeps the memory kernel chosen for the first run's time step";

}  // namespace ricochet::half_step
