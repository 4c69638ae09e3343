#pragma once

#include "sources.hpp"

#include <optional>

namespace ricochet::verify {

/// Data with a third of their speeds, the slowest or the fastest, left out of the fits.
struct Thirds {
  std::string left_out;  ///< "slowest", "fastest"
  std::vector<calibration::Measurement> kept, rest;
};
std::array<Thirds, 2> thirds(std::vector<calibration::Measurement> data);

/// What the fits to two thirds say of the third.
struct Foretold {
  Thirds of;
  std::vector<calibration::Fit> fits;  ///< to what was kept
  std::vector<double> miss;            ///< root mean square of what each misses e_n by in what was left out

  std::size_t preferred() const { return calibration::preferred(fits).best.front(); }  ///< by the AIC of what was kept
  std::size_t nearest() const;
};
Foretold foretell(const Thirds& of);

/// Chow's predictive test: what n − n₁ further measurements add to the sum of squares of a fit, each, over what a
/// degree of freedom of the fit to n₁ has. Where the law holds and the noise is Gaussian, of one size and independent,
/// it is an F of (n − n₁, n₁ − p) degrees of freedom, as far as the law is linear in its parameters within their errors
/// (G. C. Chow, Econometrica 28, 591 (1960)).
double chow(const calibration::Fit& all, const calibration::Fit& part);

/// How often synthetic data of fractional-hertz with known Gaussian noise pass that test's 95 % point where σ is
/// known, χ²(all) − χ²(part) of n − n₁ degrees of freedom, when the fastest third is left out: 0.95 as far as errors
/// and forward model are right.
double share_foretold(int trials);

/// How often the AIC prefers an α that follows the speed to the constant one that made the data: by chance it does
/// where a χ² of one degree of freedom passes 2, in 15.73 % (S. S. Wilks, Ann. Math. Stat. 9, 60 (1938)).
double share_misled(int trials);
inline constexpr double misled_by_chance = 0.157299;

}  // namespace ricochet::verify
