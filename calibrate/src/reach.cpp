#include "reach.hpp"

#include "solution.hpp"

#include <algorithm>
#include <cmath>

namespace ricochet::calibration {
namespace {

double cube(double x) { return x * x * x; }

/// Is e_n far enough from 0 for the tolerance, and every parameter a normal double?
bool reaches(const Request& request, double en, double tolerance) {
  const auto found = solve_directly(request.law, request.end, en);
  if (!found || rounding_error(found->law, request.end, en) > tolerance) return false;
  return request.law == LawName::fractional || at_impact(found->law, request.target.tcol, request.target.impact);
}

/// The next number of three digits: what is told of a range is reachable to its last digit.
double rounded_up(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return unit > 0 ? std::min(1.0, std::ceil(x / unit) * unit) : x;
}

}  // namespace

double rounding_error(const AnyLaw& law, ContactEnd end, double en) {
  const bool by_overlap = end == ContactEnd::overlap;
  if (const auto* fractional = std::get_if<Fractional>(&law))
    return by_overlap ? 1e-15 / (en * en) : 2e-16 / (1 - fractional->alpha());
  if (!by_overlap) return 0;
  return (std::holds_alternative<Tsuji>(law) ? 1e-15 : 1e-16) * cube(-std::log(en));
}

double check_error(const AnyLaw& law, ContactEnd end, double en) {
  const bool resolved_in_v0 = std::holds_alternative<Fractional>(law) && end == ContactEnd::force;
  return 1e-11 + rounding_error(law, end, en) + (resolved_in_v0 ? 1e-14 / en : 0);
}

Infeasible out_of_reach(const Request& request, double tolerance) {
  double missed = std::log(request.target.en), reached = 0;
  for (int halving = 0; halving < 30; ++halving) {
    const double middle = 0.5 * (missed + reached);
    (reaches(request, std::exp(middle), tolerance) ? reached : missed) = middle;
  }
  return {request.law,
          request.end,
          "below, the rounding of its parameters to doubles keeps the law from the tolerance",
          "en",
          request.target.en,
          rounded_up(std::exp(reached)),
          1};
}

}  // namespace ricochet::calibration
