#include <ricochet/collision/reach.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet {
namespace {

/// The next number of three digits, as close to its decimals as a double comes: what is told of a range is reachable to
/// its last digit.
double rounded_up(double x) {
  const double units = std::pow(10, 2 - std::floor(std::log10(x)));
  return std::isfinite(units) ? std::min(1.0, std::ceil(x * units) / units) : x;
}

}  // namespace

bool reaches(LawKind kind, ContactEnd end, double en, double tcol, const Impact& impact, double tolerance,
             const Held& held) {
  const auto found = unit_law(kind, en, end, held);
  if (!found || rounding_error(found->law, end, en) > tolerance) return false;
  return kind == kind_of<Fractional> || at_impact(found->law, tcol, impact);
}

double restitution_bound(LawKind kind, ContactEnd end, const Held& held) {
  return kind.visit([&]<class Law>(std::type_identity<Law>) {
    if constexpr (HoldsDegree<Law>)
      return Reduction<Law>::restitution_bound(end, held);
    else
      return 0.0;
  });
}

double least_restitution(LawKind kind, ContactEnd end, double missed, double tcol, const Impact& impact,
                         double tolerance, const Held& held) {
  const auto reached_at = [&](double en) { return reaches(kind, end, en, tcol, impact, tolerance, held); };
  const double bound = restitution_bound(kind, end, held);
  if (bound >= 1) return 1;
  // What is told of a bound that the law comes close to is a search saved.
  if (const double told = rounded_up(bound); bound > missed && told < 1 && reached_at(told)) return told;
  double below = std::log(std::max(missed, bound)), reached = 0;
  for (int halving = 0; halving < 30; ++halving) {
    const double middle = 0.5 * (below + reached);
    (reached_at(std::exp(middle)) ? reached : below) = middle;
  }
  return rounded_up(std::exp(reached));
}

}  // namespace ricochet
