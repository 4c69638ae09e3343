#include "solution.hpp"

#include <ricochet/contact/damping_ratio.hpp>
#include <ricochet/contact/fractional_contact.hpp>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

namespace ricochet::calibration {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How much more than the target a group loses; counts the collisions.
struct Losses {
  LawName law = LawName::linear;
  ContactEnd end = ContactEnd::force;
  double target = 0;  // −ln e_n
  std::size_t evaluations = 0;

  /// ln(loss/target), which is close to linear in the logarithm of the group; positive where the bodies do not part.
  double operator()(double group) {
    ++evaluations;
    const auto out = unit_collision(law, {0, group}, end);
    if (!out.separated() || out.en <= 0) return 1e3;
    return std::log(std::max(-std::log(out.en), 1e-300) / target);
  }
};

/// Widens [low, high] around the guess until the loss crosses the target between them; false when no group loses
/// enough, or none little enough.
bool bracket(Losses& losses, double guess, double& low, double& high, double& at_low, double& at_high) {
  constexpr double farthest = 200;
  low = high = guess;
  at_low = at_high = losses(guess);
  for (double step = 1; at_low > 0 && guess - low < farthest; step *= 1.6) at_low = losses(low -= step);
  for (double step = 1; at_high < 0 && high - guess < farthest; step *= 1.6) at_high = losses(high += step);
  return at_low <= 0 && at_high >= 0;
}

std::optional<Solution> solve_for_group(LawName law, ContactEnd end, double en) {
  Losses losses{law, end, -std::log(en)};
  double low = 0, high = 0, at_low = 0, at_high = 0;
  // Where little is lost the loss is proportional to the group, so its logarithm is the guess.
  if (!bracket(losses, std::log(losses.target), low, high, at_low, at_high)) return std::nullopt;
  std::uintmax_t trials = 200;
  const auto root = boost::math::tools::toms748_solve([&](double group) { return losses(group); }, low, high, at_low,
                                                      at_high, boost::math::tools::eps_tolerance<double>(), trials);
  const double group = root.first;
  const auto out = unit_collision(law, {0, group}, end);
  if (!out.separated()) return std::nullopt;
  return Solution{with_unit_tcol(law, group, out.tcol), "bracketed root", losses.evaluations + 1};
}

/// The group where it is known as a function of e_n: of the two laws whose restitution is a closed form of the damping
/// ratio β (with k = 1 in the impact's own scale c is 2β for the linear law and √5 β for Tsuji's), and the conversion
/// degree.
std::optional<double> closed_group(LawName law, ContactEnd end, double en) {
  if (law == LawName::linear) return std::log(2 * damping_of_restitution(en, end));
  if (law == LawName::tsuji) return std::log(std::sqrt(5.0) * damping_of_restitution(en, end));
  if (en == 1) return -infinity;
  if (law != LawName::fractional || en < 1e-6) return std::nullopt;
  const double alpha = conversion_degree(en, end);
  return std::log(alpha) - std::log1p(-alpha);
}

/// e = √(k₁/k₂), t = (π/2)√(m/k₁)(1 + e); k₂/k₁ − 1 = (1−e)(1+e)/e².
Coordinates hysteretic_by_force(double en) {
  return {2 * std::log(0.5 * std::numbers::pi * (1 + en)), std::log((1 - en) * (1 + en)) - 2 * std::log(en)};
}

}  // namespace

std::optional<Solution> solve_directly(LawName law, ContactEnd end, double en) {
  if (law == LawName::hysteretic) return Solution{hysteretic_by_force(en), "closed form", 0};
  if (const auto group = closed_group(law, end, en)) {
    const auto out = unit_collision(law, {0, *group}, end);
    // Past the last digits of α or β the bodies may no longer part; the root below then finds nothing either.
    if (out.separated()) return Solution{with_unit_tcol(law, *group, out.tcol), "closed form", 1};
  }
  return solve_for_group(law, end, en);
}

}  // namespace ricochet::calibration
