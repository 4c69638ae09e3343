#include "fit_findings.hpp"

#include <ricochet/support/require.hpp>
#include <ricochet/support/text.hpp>

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace ricochet::calibration {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Beyond, squares and powers would leave the range of doubles.
constexpr double widest = 1e30;

void require_scale(const char* name, double value) {
  support::require_positive(name, value);
  support::require(value >= 1 / widest && value <= widest, name, value, "in [1e-30, 1e30]");
}

/// Restitutions and times.
std::size_t observations_in(const std::vector<Measurement>& data) { return data.size() * (data[0].tcol > 0 ? 2 : 1); }

/// Does the restitution that is left over follow the speed? So it is where the slope of the residuals against ln v is
/// four standard errors from 0, both by their own scatter and by what is known of it: the stated errors, or the
/// model's. Where the scatter alone tells its size, so many more as Student's t comes by chance once in a thousand.
bool rest_follows_speed(const Fit& fit, const VectorXd& r, const std::vector<Measurement>& data) {
  const Index stride = data[0].tcol > 0 ? 2 : 1;
  const Index count = static_cast<Index>(data.size());
  VectorXd x(count), y(count);
  for (Index i = 0; i < count; ++i) {
    x[i] = std::log(data[static_cast<std::size_t>(i)].velocity);
    y[i] = r[i * stride];
  }
  x.array() -= x.mean();
  y.array() -= y.mean();
  const double xx = x.squaredNorm(), sigma = fit.errors_known ? 1 : model_error;
  if (count < 3 || !(xx > 0)) return false;
  const double along = x.dot(y) / std::sqrt(xx);
  const double rest = std::max(y.squaredNorm() - along * along, 0.0) / static_cast<double>(count - 2);
  const double errors =
      fit.errors_known ? 4 : std::max(4.0, gsl_cdf_tdist_Qinv(0.5 * 1e-3, static_cast<double>(count - 2)));
  return along * along > errors * errors * std::max(rest, sigma * sigma);
}

/// Of what the data tell and what not, whatever they are.
void add_limits(std::vector<std::string>& said, const FitRequest& request, bool with_times) {
  if (!with_times) said.push_back("no collision times: the stiffness cannot be told, only what sets the restitution");
  if (request.law == kind_of<Fractional> && !request.alpha_of_speed && with_times)
    said.push_back("k and c cannot be told apart: only c^alpha k^(1-alpha) shows");
  std::vector<std::string> kept;
  for (const NamedValue& value : held(request))
    kept.push_back(fmt::format("{} = {}", value.name, support::shortest(value.value)));
  if (!kept.empty())
    said.push_back(fmt::format("held, not fitted: {}; the law says the same at every speed, {}", fmt::join(kept, ", "),
                               with_times ? "a time and a restitution" : "one restitution"));
}

}  // namespace

void require_fit(const FitRequest& request, const std::vector<Measurement>& data) {
  using support::require;
  support::require_positive("mass_eff", request.mass_eff);
  if (!request.law.ends().offer(request.end))
    throw std::invalid_argument(
        fmt::format("end = {}: must be force for the law {}", text(request.end), request.law.name()));
  if (request.alpha_of_speed && request.law != kind_of<Fractional>)
    throw std::invalid_argument(fmt::format("alpha_of_speed = true: must be false for the law {}", request.law.name()));
  require(domains::degree.contains(request.held.alpha), "alpha", request.held.alpha, domains::degree.accepted);
  support::require_positive("k1/k", request.held.stiffening);
  require(!data.empty(), "measurements", 0, "at least 1");
  for (const Measurement& m : data) {
    require_scale("velocity", m.velocity);
    require(m.en > 0 && m.en <= 1, "en", m.en, "in (0, 1]");
    if (m.en_sigma != 0) require_scale("en_sigma", m.en_sigma);
    if (m.mass_eff != 0) require_scale("mass_eff", m.mass_eff);
    if (m.radius_eff != 0) require_scale("radius_eff", m.radius_eff);
    require((m.en_sigma > 0) == (data[0].en_sigma > 0), "en_sigma", m.en_sigma,
            "> 0 for every measurement or for none");
    require((m.tcol > 0) == (data[0].tcol > 0), "tcol", m.tcol, "> 0 for every measurement or for none");
    if (m.tcol == 0) continue;
    require_scale("tcol", m.tcol);
    require_scale("tcol_sigma", m.tcol_sigma);
    require(m.en_sigma > 0, "en_sigma", m.en_sigma,
            "> 0 where there are collision times, to weigh one against the other");
  }
}

void require_observations(const FitRequest& request, const std::vector<Measurement>& data, Index unknowns) {
  const std::size_t observations = observations_in(data), parameters = static_cast<std::size_t>(unknowns);
  if (observations <= parameters)
    throw std::invalid_argument(fmt::format("observations = {}: must be more than the parameters of {}, {}",
                                            observations, fit_name(request), parameters));
}

double median(std::vector<double> values) {
  const auto half = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), half, values.end());
  return *half;
}

std::vector<std::size_t> far_out(std::vector<double> residuals, double least) {
  if (residuals.size() < 5) return {};
  const double middle = median(residuals);  // one that is far out has drawn the fit away from all the others
  for (double& x : residuals) x = std::abs(x - middle);
  const double usual = std::max(median(residuals), least);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < residuals.size(); ++i)
    if (residuals[i] > 10 * usual) out.push_back(i);
  return out;
}

/// In units of its own error where that is known, and by a hundredth at least where not.
void add_outliers(std::vector<std::string>& said, const Fit& fit, const VectorXd& r,
                  const std::vector<Measurement>& data) {
  const Index stride = data[0].tcol > 0 ? 2 : 1;
  std::vector<double> off;
  for (Index i = 0; i < r.size(); i += stride) off.push_back(r[i]);
  const auto found = far_out(std::move(off), fit.errors_known ? 1.0 : 1e-3);
  for (const std::size_t i : found)
    said.push_back(
        fmt::format("{}: en = {} at {} m/s lies far outside the others: a slip? The fit takes it as it is",
                    data[i].line > 0 ? fmt::format("line {}", data[i].line) : fmt::format("measurement {}", i + 1),
                    support::significant(data[i].en, 4), support::significant(data[i].velocity, 4)));
}

std::vector<std::string> findings(const Fit& fit, const std::vector<std::string>& at_the_edge,
                                  const VectorXd& residuals, const std::vector<Measurement>& data) {
  std::vector<std::string> said;
  const bool with_times = data[0].tcol > 0;
  add_limits(said, fit.request, with_times);
  if (fit.errors_known && std::any_of(data.begin(), data.end(), [](const Measurement& m) {
        return m.en_sigma < 10 * model_error || m.tcol_sigma < 10 * model_error * m.tcol;
      }))
    said.push_back("stated errors come near the fit's own error, 1e-9, which is not in those of the parameters");
  if (rest_follows_speed(fit, residuals, data))
    said.push_back(follows_speed(fit.request)
                       ? "misfit: what the law leaves over follows the speed"
                       : "misfit: the law gives the same restitution at every speed, the data change with it");
  else if (fit.errors_known && fit.probability < 1e-3)
    said.push_back("misfit: a chi2 this large comes by chance less than once in a thousand");
  add_outliers(said, fit, residuals, data);
  for (const std::string& name : at_the_edge)
    said.push_back(
        fmt::format("{} has run to the end of its range: the data only tell that it is there or beyond", name));
  if (fit.request.law == kind_of<FractionalHertz> && fit.solution[0] > hertz_without_spring - 4)
    said.push_back(
        "the spring takes a hundredth or less: k = 0, the pure power law, fits with one restitution at every speed");
  for (const Estimate& p : fit.parameters)
    if (!(p.error < std::abs(p.value)) &&
        std::find(at_the_edge.begin(), at_the_edge.end(), p.name) == at_the_edge.end())
      said.push_back(fmt::format("{} is not determined: its standard error is as large as itself", p.name));
  return said;
}

}  // namespace ricochet::calibration
