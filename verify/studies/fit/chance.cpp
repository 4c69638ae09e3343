#include "chance.hpp"

#include <gsl/gsl_cdf.h>

namespace ricochet::verify {

std::pair<double, double> plausible_shares(double probability, int trials) {
  const auto n = static_cast<unsigned>(trials);
  unsigned least = 0, greatest = n;
  while (gsl_cdf_binomial_P(least, probability, n) < by_chance) ++least;
  while (gsl_cdf_binomial_Q(greatest - 1, probability, n) < by_chance) --greatest;
  return {static_cast<double>(least) / n, static_cast<double>(greatest) / n};
}

std::pair<double, double> plausible_f(double upper, double lower) {
  return {gsl_cdf_fdist_Pinv(1e-3, upper, lower), gsl_cdf_fdist_Qinv(1e-3, upper, lower)};
}

}  // namespace ricochet::verify
