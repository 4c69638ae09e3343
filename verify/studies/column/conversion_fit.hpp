#pragma once

#include "case.hpp"

#include <cstddef>
#include <vector>

namespace ricochet::verify::column {

/// The conversion degree as a function of the number of beads, α(nc) = 1 − (1 − α₁)^{s(nc)} with
/// s(nc) = (1 + a (nc − 1))^b, so that α(1) = α₁.
struct ConversionLaw {
  double first;  ///< α₁
  double a, b;
  double exponent(std::size_t beads) const;  ///< s(nc)
  double operator()(std::size_t beads) const;
};

/// What the α(nc) of one column came out as.
struct ConversionPoint {
  std::size_t beads;
  double target;          ///< event-driven share
  double exact_alpha;     ///< whose column has exactly that share
  double exact_exponent;  ///< s that belongs to it
  double fitted_share;    ///< of the fitted α(nc)
};

struct ConversionFit {
  ConversionLaw law;
  std::vector<ConversionPoint> points;
  double worst = 0;  ///< greatest |fitted share − event-driven share|
  double rms = 0;
  std::size_t evaluations = 0;  ///< of the whole curve, by NLopt
  double simple_worst = 0;      ///< the same greatest error for the paper's s = nc
};

/// Finds a and b by NLopt (BOBYQA) so that the fractional columns of 2, 2 + stride, … `most` beads follow the
/// event-driven shares in the sense of least squares; errors are then measured at every number of beads up to `most`.
/// Throws console::Failed if NLopt does not converge or an event-driven column collapses.
ConversionFit fit_conversion(std::size_t most, std::size_t stride, const ColumnCase& c);

}  // namespace ricochet::verify::column
