#pragma once

#include <ricochet/collision/collision.hpp>

#include "graded_clock.hpp"
#include "normal_path.hpp"

#include <algorithm>

namespace ricochet::collision {

/// A motion given by ζ, ζ', R, R' at a reading of the clock, and before or after the turning point.
template <class Motion>
class ClockPath final : public NormalPath {
 public:
  ClockPath(const Motion& motion, const Collision& by_force, double velocity)
      : NormalPath(1, 2, by_force.overlap_end == 0),
        motion_(motion),
        clock_{by_force.time_max_overlap, by_force.tcol - by_force.time_max_overlap},
        end_rate_(-by_force.en * velocity) {}

  NormalInstant at(double s, bool loading) const override {
    const GradedClock::Reading clock = clock_.at(inside(s), loading);
    NormalInstant now = motion_(clock, loading);
    now.pace = clock.pace;
    now.force = std::max(0.0, now.force);
    if (closes_ && clock.rest < 1e-4 * clock_.rebound) now.overlap = last_overlap(clock.rest, now.rate, end_rate_);
    return now;
  }

 private:
  Motion motion_;
  GradedClock clock_;
  double end_rate_;
};

}  // namespace ricochet::collision
