#pragma once

#include <cstddef>

namespace ricochet::calibration {

inline constexpr double standard_gravity = 9.80665;  ///< [m/s²]

/// Consecutive flights of a ball that bounces on the same plate: from one impact to the one `count` impacts later.
struct Flights {
  double start = 0;   ///< of the first impact [s]
  double length = 0;  ///< of all of them [s], > 0
  double count = 1;   ///< a whole number
  double sigma = 0;   ///< standard error of either end [s]; 0: not known

  double mean() const { return length / count; }
};

/// An impact as flights tell it.
struct Bounce {
  double velocity = 0;  ///< [m/s]
  double en = 0;
  double en_sigma = 0;  ///< 0: not known
};

/// A ball that flies for T falls back at v = gT/2 and then flies for e_n T, as no air holds it up and contacts take no
/// time. The flight at t and that at t' under a constant e_n thus differ by T' − T = −(1 − e_n)(t' − t), and the first
/// of N flights has the mean T̄ = T(1 − e_n^N)/(N(1 − e_n)). So from two runs of N flights that begin at t and t'
///
///   e_n^N = 1 − N(T̄ − T̄')/(t' − t),   v = g(T + T'/e_n)/4,
///
/// v the middle one of the impacts from t on and before t'. Of two single flights, one after the other, that is
/// e_n = T'/T and v = gT/2. It is exact where e_n is the same from t to t'; else it is that of a speed between, which
/// v is to second order in what the speed falls. The error of e_n is that of independent errors of the runs' ends, to
/// first order.
///
/// Throws std::invalid_argument for lengths and counts that are not finite and > 0, an `after` that does not begin and
/// end after `before` or has another count, and a mean flight longer than the one before, which no e_n ≤ 1 makes.
Bounce bounce_between(const Flights& before, const Flights& after);

}  // namespace ricochet::calibration
