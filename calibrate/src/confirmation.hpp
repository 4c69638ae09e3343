#pragma once

#include <algorithm>

namespace ricochet::calibration {

/// What a collision says of an answer that was to hit a target to `tolerance`.
enum class Confirmation {
  full,          ///< it misses by no more than that
  within_error,  ///< by more, but by no more than the collision itself may be off
  missed
};

/// Of a miss, where the collision is off by `error` at most; all relative.
constexpr Confirmation confirmed(double miss, double tolerance, double error) noexcept {
  if (!(miss <= std::max(tolerance, error))) return Confirmation::missed;
  return miss <= tolerance ? Confirmation::full : Confirmation::within_error;
}

}  // namespace ricochet::calibration
