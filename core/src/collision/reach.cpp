#include <ricochet/collision/reach.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet {
namespace {

/// The next number of three digits: what is told of a range is reachable to its last digit.
double rounded_up(double x) {
  const double unit = std::pow(10, std::floor(std::log10(x)) - 2);
  return unit > 0 ? std::min(1.0, std::ceil(x / unit) * unit) : x;
}

}  // namespace

bool reaches(LawKind kind, ContactEnd end, double en, double tcol, const Impact& impact, double tolerance) {
  const auto found = unit_law(kind, en, end);
  if (!found || rounding_error(found->law, end, en) > tolerance) return false;
  return kind == kind_of<Fractional> || at_impact(found->law, tcol, impact);
}

double least_restitution(LawKind kind, ContactEnd end, double missed, double tcol, const Impact& impact,
                         double tolerance) {
  double below = std::log(missed), reached = 0;
  for (int halving = 0; halving < 30; ++halving) {
    const double middle = 0.5 * (below + reached);
    (reaches(kind, end, std::exp(middle), tcol, impact, tolerance) ? reached : below) = middle;
  }
  return rounded_up(std::exp(reached));
}

}  // namespace ricochet
