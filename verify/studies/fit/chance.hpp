#pragma once

#include <utility>

namespace ricochet::verify {

/// A normal variable passes four standard deviations on one side by chance this often.
inline constexpr double by_chance = 3.167e-5;

/// Least and greatest share of `trials` in which something of that probability comes to pass, but for `by_chance` on
/// either side: quantiles of the binomial distribution.
std::pair<double, double> plausible_shares(double probability, int trials);

/// The 0.1 % points of F of `upper` and `lower` degrees of freedom on either side.
std::pair<double, double> plausible_f(double upper, double lower);

}  // namespace ricochet::verify
