#include "reach.hpp"

#include <ricochet/collision/reach.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>

#include <string>

namespace ricochet::calibration {

namespace {

/// What keeps a law from an e_n: where something of it is held, that, and else the rounding of its parameters.
std::string why(const Request& request) {
  const auto& [alpha, stiffening] = request.held;
  if (request.target.en >= restitution_bound(request.law, request.end, request.held))
    return "outside, the rounding of its parameters to doubles keeps the law from the tolerance";
  const bool stiffens = request.law == kind_of<FractionalZener>;
  return fmt::format("no loss leaves less at alpha = {}{}, which {} held", support::shortest(alpha),
                     stiffens ? fmt::format(" and k1/k = {}", support::shortest(stiffening)) : "",
                     stiffens ? "are" : "is");
}

}  // namespace

Infeasible out_of_reach(const Request& request, double tolerance) {
  const auto& [tcol, en, impact] = request.target;
  return {request.law,
          request.end,
          why(request),
          "en",
          en,
          least_restitution(request.law, request.end, en, tcol, impact, tolerance, request.held),
          1};
}

}  // namespace ricochet::calibration
