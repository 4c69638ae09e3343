#include "reach.hpp"

#include <ricochet/collision/reach.hpp>

namespace ricochet::calibration {

Infeasible out_of_reach(const Request& request, double tolerance) {
  const auto& [tcol, en, impact] = request.target;
  return {request.law,
          request.end,
          "outside, the rounding of its parameters to doubles keeps the law from the tolerance",
          "en",
          en,
          least_restitution(request.law, request.end, en, tcol, impact, tolerance),
          1};
}

}  // namespace ricochet::calibration
