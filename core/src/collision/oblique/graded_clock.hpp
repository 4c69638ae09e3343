#pragma once

namespace ricochet::collision {

/// Time as a function of 0 ≤ s ≤ 2, graded by fourth powers towards touch and end, where motions begin and end like
/// t^{1/2}, t^{1/4} or t^{1−α}; the turning point is at s = 1.
struct GradedClock {
  struct Reading {
    double time, rest, pace;  // t, t_col − t and dt/ds [s]
  };

  double turn = 0, rebound = 0;  // lengths [s] before and after the turning point

  Reading at(double s, bool loading) const noexcept {
    const double x = loading ? s : 2 - s, cube = x * x * x;
    if (loading) return {turn * cube * x, rebound + turn * (1 - cube * x), 4 * turn * cube};
    return {turn + rebound * (1 - cube * x), rebound * cube * x, 4 * rebound * cube};
  }
};

}  // namespace ricochet::collision
