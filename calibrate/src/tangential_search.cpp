#include "tangential_search.hpp"

#include <nlopt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <stdexcept>
#include <vector>

namespace ricochet::calibration {
namespace {

/// From ln of the parameters over their units, m_t/t², m_t/t and, of mindlin, √m less.
TangentialLaw law_at(TangentialForm form, std::span<const double> x, const Sticking& stuck, double unit_k) {
  const double k = unit_k * std::exp(x[0]);
  if (form == TangentialForm::mindlin) return MindlinTangential(k);
  return LinearTangential(k, x.size() > 1 ? stuck.mass() / stuck.tcol() * std::exp(x[1]) : 0);
}

/// The search's view: the squared misses of β₀ and, of the damped form, of the strain.
struct Miss {
  TangentialForm form;
  double beta0 = 0, unit_k = 0;
  const Sticking& stuck;
  std::vector<double> best = {};
  double least = std::numeric_limits<double>::max();

  double operator()(const std::vector<double>& x) {
    const Stuck out = stuck(law_at(form, x, stuck, unit_k));
    const double strain = form == TangentialForm::linear ? out.strain : 0;
    const double sum = std::pow(out.beta - beta0, 2) + strain * strain;
    if (sum < least) {
      least = sum;
      best = x;
    }
    return sum;
  }
};

double objective(const std::vector<double>& x, std::vector<double>&, void* data) {
  return (*static_cast<Miss*>(data))(x);
}

}  // namespace

Searched searched(TangentialForm form, double beta0, double unit_k, const TangentialLaw& ours, double highest,
                  const Sticking& stuck) {
  const auto parameters = values(ours);
  const double log_k = std::log(parameters.at(0) / unit_k);
  std::vector<double> low{log_k - 1}, high{std::min(log_k + 1, highest)}, x{log_k - 0.5};
  if (parameters.at(1) > 0) {
    const double log_c = std::log(parameters.at(1) * stuck.tcol() / stuck.mass());
    low.push_back(log_c - 1);
    high.push_back(log_c + 1);
    x.push_back(log_c + 0.5);
  }
  Miss miss{form, beta0, unit_k, stuck, x};
  double step = 0.25;
  for (double before = std::numeric_limits<double>::infinity(); miss.least > 1e-24 && miss.least < 0.25 * before;) {
    before = miss.least;
    nlopt::opt optimizer(nlopt::LN_BOBYQA, static_cast<unsigned>(x.size()));
    optimizer.set_min_objective(objective, &miss);
    optimizer.set_lower_bounds(low);
    optimizer.set_upper_bounds(high);
    optimizer.set_stopval(1e-26);
    optimizer.set_xtol_rel(1e-14);
    optimizer.set_maxeval(200);
    optimizer.set_initial_step(step);
    x = miss.best;
    double value = 0;
    try {
      optimizer.optimize(x, value);
    } catch (const std::runtime_error&) {  // rounding is all that is left; the best point counts
    }
    step = std::clamp(std::sqrt(miss.least), 1e-9, 0.25);
  }
  return {law_at(form, miss.best, stuck, unit_k), std::sqrt(miss.least)};
}

double apart(const TangentialLaw& law, const TangentialLaw& other) {
  const auto ours = values(law), theirs = values(other);
  double greatest = 0;
  for (std::size_t i = 0; i < ours.size(); ++i)
    if (const double size = std::max(ours[i], theirs[i]); size > 0)
      greatest = std::max(greatest, std::abs(ours[i] - theirs[i]) / size);
  return greatest;
}

}  // namespace ricochet::calibration
