#include "conversion_fit.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/support/root.hpp>

#include <console/exit.hpp>

#include <fmt/format.h>
#include <nlopt.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::column {

namespace {

constexpr double largest_alpha = 0.96;  // closed forms of the contact end there

/// α(1) = α₁ whatever a and b: one bead is not fitted.
struct Curve {
  double first;
  ColumnCase c;
  std::size_t stride;
  std::vector<double> target;  // event-driven share of 1, 2, … beads
  std::size_t evaluations = 0;

  double share_of(double alpha, std::size_t n) const {
    return share(run_fractional(std::clamp(alpha, 1e-4, largest_alpha), n, c));
  }
  double sum_of_squares(const ConversionLaw& law) {
    ++evaluations;
    double sum = 0;
    for (std::size_t n = 2; n <= target.size(); n += stride) {
      const double miss = share_of(law(n), n) - target[n - 1];
      sum += miss * miss;
    }
    return sum;
  }
};

double objective(const std::vector<double>& x, std::vector<double>&, void* data) {
  Curve& curve = *static_cast<Curve*>(data);
  return curve.sum_of_squares({curve.first, x[0], x[1]});
}

/// α whose column loses `target`, to seven digits: the share rises with α.
double exact_alpha(const Curve& curve, std::size_t n, double target) {
  const auto excess = [&](double alpha) { return curve.share_of(alpha, n) - target; };
  const double low = 1e-3, high = largest_alpha, at_low = excess(low), at_high = excess(high);
  if (at_low > 0 || at_high < 0) throw console::Failed("no conversion degree gives the event-driven share");
  return support::root(excess, low, high, at_low, at_high, {.relative = 1e-7});
}

ConversionLaw minimise(Curve& curve) {
  nlopt::opt search(nlopt::LN_BOBYQA, 2);
  search.set_lower_bounds({0.0, 0.3});
  search.set_upper_bounds({3.0, 3.0});
  search.set_initial_step({0.1, 0.1});
  search.set_min_objective(objective, &curve);
  search.set_xtol_rel(1e-4);
  search.set_maxeval(200);
  std::vector<double> x{0.5, 1.2};
  double least = 0;
  try {
    if (search.optimize(x, least) == nlopt::MAXEVAL_REACHED)
      throw console::Failed("alpha(nc): NLopt does not converge");
  } catch (const nlopt::roundoff_limited&) {  // x then holds the best point, to rounding
  }
  return {curve.first, x[0], x[1]};
}

}  // namespace

double ConversionLaw::exponent(std::size_t beads) const {
  return std::pow(1 + a * (static_cast<double>(beads) - 1), b);
}

double ConversionLaw::operator()(std::size_t beads) const { return -std::expm1(exponent(beads) * std::log1p(-first)); }

ConversionFit fit_conversion(std::size_t most, std::size_t stride, const ColumnCase& c) {
  Curve curve{conversion_degree(c.en), c, stride, {}};
  for (std::size_t n = 1; n <= most; ++n) {
    const auto target = event_driven_share(n, c);
    if (!target) throw console::Failed(fmt::format("alpha(nc): the event-driven column of {} beads collapses", n));
    curve.target.push_back(*target);
  }
  ConversionFit fit{minimise(curve), {}};
  fit.evaluations = curve.evaluations;
  const ConversionLaw simple{curve.first, 1, 1};
  for (std::size_t n = 1; n <= most; ++n) {
    const double target = curve.target[n - 1], alpha = exact_alpha(curve, n, target);
    fit.points.push_back(
        {n, target, alpha, std::log1p(-alpha) / std::log1p(-curve.first), curve.share_of(fit.law(n), n)});
    const double miss = std::abs(fit.points.back().fitted_share - target);
    fit.worst = std::max(fit.worst, miss);
    fit.rms += miss * miss / static_cast<double>(most);
    fit.simple_worst = std::max(fit.simple_worst, std::abs(curve.share_of(simple(n), n) - target));
  }
  fit.rms = std::sqrt(fit.rms);
  return fit;
}

}  // namespace ricochet::verify::column
