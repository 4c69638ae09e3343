#pragma once

namespace ricochet {

/// A collision at one time, along the normal.
struct Instant {
  double time = 0;     ///< from t_b [s]
  double overlap = 0;  ///< ζ [m]
  double rate = 0;     ///< ζ' [m/s], positive while compressing
  double force = 0;    ///< signed, as the law's formula says [N]
};

}  // namespace ricochet
