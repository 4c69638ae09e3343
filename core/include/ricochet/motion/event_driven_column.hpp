#pragma once

#include <ricochet/motion/column.hpp>

namespace ricochet {

/// The event-driven ("hard sphere") counterpart of a Column: collisions last no time and turn an approach rate u into
/// −e_n u. What a column of any law with constant restitution tends to as its gaps grow.
struct EventDrivenResult {
  enum class Status {
    separated,    ///< no neighbours approach by more than 1e-12 of the greatest initial speed
    collapsed,    ///< `limit` collisions were not enough: inelastic collapse, infinitely many in a finite time
    out_of_range  ///< masses, gaps or velocities so far apart that a result is no double; all others are then 0
  };
  Status status = Status::separated;
  double time = 0;               ///< of the last collision [s]
  double energy_ratio = 0;       ///< kinetic energy at the end over that at the start
  std::vector<double> velocity;  ///< at the end [m/s]
  std::size_t collisions = 0;
};

/// Exact up to rounding: gaps close linearly, the next collision is the soonest of all gaps; gaps that close together
/// (or are 0) collide from the plate upwards. Cost O(log nc) a collision. `en` in [0, 1]; no gravity.
/// Throws std::invalid_argument as `run_column`, for gravity ≠ 0 or another `en`.
EventDrivenResult event_driven_column(const Column& column, double en, std::size_t limit = 10'000'000);

}  // namespace ricochet
