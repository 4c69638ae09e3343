#pragma once

#include "sticking.hpp"

#include <calibrate/tangential.hpp>

namespace ricochet::calibration {

/// Where the search ended, and by how much its point misses β₀ and, of the damped form, the strain of 0.
struct Searched {
  TangentialLaw law;
  double miss = 0;
};

/// BOBYQA within a factor e of `ours` and below `highest`, ln of the first parameter, where another period of the
/// spring begins; begun a factor √e away, and anew around its best point while that gains.
Searched searched(TangentialForm form, double beta0, double unit_k, const TangentialLaw& ours, double highest,
                  const Sticking& stuck);

/// Greatest relative difference of a parameter.
double apart(const TangentialLaw& law, const TangentialLaw& other);

}  // namespace ricochet::calibration
