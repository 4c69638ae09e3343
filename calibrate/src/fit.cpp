#include "fit_model.hpp"

#include <ricochet/detail/require.hpp>

#include <boost/math/special_functions/gamma.hpp>
#include <nlopt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The data against a model, as weighted residuals of u; remembers the best u it was asked about.
class Residuals {
 public:
  Residuals(const FitModel& model, const std::vector<Measurement>& data) : model_(model), data_(data) {}

  VectorXd operator()(const VectorXd& u) const {
    std::vector<double> r;
    for (const Measurement& m : data_) {
      const Prediction p = model_.predict(u, m.velocity);
      r.push_back((p.en - m.en) / (m.en_sigma > 0 ? m.en_sigma : 1));
      if (m.tcol > 0) r.push_back((p.tcol - m.tcol) / m.tcol_sigma);
    }
    return Eigen::Map<VectorXd>(r.data(), static_cast<Index>(r.size()));
  }

  MatrixXd jacobian(const VectorXd& u) const {
    constexpr double step = 1e-5;  // of a logarithm; central, so the error is of the order of 1e-10
    MatrixXd j;
    for (Index i = 0; i < u.size(); ++i) {
      VectorXd ahead = u, behind = u;
      ahead[i] += step;
      behind[i] -= step;
      const VectorXd column = ((*this)(ahead) - (*this)(behind)) / (2 * step);
      if (i == 0) j.resize(column.size(), u.size());
      j.col(i) = column;
    }
    return j;
  }

  double value(const VectorXd& u) {
    const double sum = (*this)(u).squaredNorm();
    if (sum < best_value) {
      best_value = sum;
      best = u;
    }
    return sum;
  }

  double scale = 1;  ///< what NLopt sees is χ² over this: its line searches want numbers near 1
  double best_value = std::numeric_limits<double>::max();
  VectorXd best;

 private:
  const FitModel& model_;
  const std::vector<Measurement>& data_;
};

double objective(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
  auto& residuals = *static_cast<Residuals*>(data);
  const VectorXd u = Eigen::Map<const VectorXd>(x.data(), static_cast<Index>(x.size()));
  const double value = residuals.value(u);
  if (!gradient.empty()) {
    const VectorXd g = 2 / residuals.scale * residuals.jacobian(u).transpose() * residuals(u);
    std::copy(g.begin(), g.end(), gradient.begin());
  }
  return value / residuals.scale;
}

/// Gauss-Newton from the best point while it gains: the last digits, which χ² itself is too flat to show.
void polish(Residuals& residuals) {
  for (int step = 0; step < 20; ++step) {
    const double before = residuals.best_value;
    const MatrixXd j = residuals.jacobian(residuals.best);
    const VectorXd move = j.colPivHouseholderQr().solve(residuals(residuals.best));
    if (!move.allFinite()) return;
    residuals.value(residuals.best - move);
    if (!(residuals.best_value < before * (1 - 1e-12))) return;
  }
}

/// NLopt's SLSQP from the best point so far, within a box that no data lead out of.
void minimise(Residuals& residuals) {
  residuals.scale = std::max(residuals.best_value, 1e-300);
  const auto n = static_cast<unsigned>(residuals.best.size());
  nlopt::opt optimizer(nlopt::LD_SLSQP, n);
  std::vector<double> x(residuals.best.begin(), residuals.best.end()), low(n), high(n);
  for (unsigned i = 0; i < n; ++i) {
    low[i] = x[i] - 15;
    high[i] = x[i] + 15;
  }
  optimizer.set_min_objective(objective, &residuals);
  optimizer.set_lower_bounds(low);
  optimizer.set_upper_bounds(high);
  optimizer.set_ftol_rel(1e-10);
  optimizer.set_maxeval(100);
  double value;
  try {
    optimizer.optimize(x, value);
  } catch (const std::runtime_error&) {  // rounding is all that is left; the best point counts
  }
}

void require_data(const FitRequest& request, const std::vector<Measurement>& data, Index unknowns) {
  using detail::require;
  using detail::require_positive;
  require_positive("mass_eff", request.mass_eff);
  std::size_t observations = 0;
  for (const Measurement& m : data) {
    require_positive("velocity", m.velocity);
    require(m.en > 0 && m.en <= 1, "en", m.en, "in (0, 1]");
    detail::require_not_negative("en_sigma", m.en_sigma);
    require((m.en_sigma > 0) == (data[0].en_sigma > 0), "en_sigma", m.en_sigma, "> 0 for every measurement or for none");
    require((m.tcol > 0) == (data[0].tcol > 0), "tcol", m.tcol, "> 0 for every measurement or for none");
    if (m.tcol > 0) {
      require_positive("tcol_sigma", m.tcol_sigma);
      require(m.en_sigma > 0, "en_sigma", m.en_sigma, "> 0 where there are collision times, to weigh one against the other");
    }
    observations += m.tcol > 0 ? 2 : 1;
  }
  require(observations > static_cast<std::size_t>(unknowns), "measurements", static_cast<double>(data.size()),
          "more than there are parameters");
  if (!offers(request.law, request.end) || (request.law == LawName::fractional && request.end == ContactEnd::overlap))
    throw std::invalid_argument("end = " + std::string(text(request.end)) + ": must be force for the law " +
                                std::string(text(request.law)));
}

/// Student's t of a slope of the restitution's residuals against ln v: does what is left over follow the speed?
double trend(const VectorXd& r, const std::vector<Measurement>& data) {
  const std::size_t stride = data[0].tcol > 0 ? 2 : 1;
  const double n = static_cast<double>(data.size());
  double x_mean = 0, y_mean = 0, xx = 0, xy = 0, yy = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    x_mean += std::log(data[i].velocity) / n;
    y_mean += r[static_cast<Index>(i * stride)] / n;
  }
  for (std::size_t i = 0; i < data.size(); ++i) {
    const double x = std::log(data[i].velocity) - x_mean, y = r[static_cast<Index>(i * stride)] - y_mean;
    xx += x * x, xy += x * y, yy += y * y;
  }
  const double rest = yy - (xx > 0 ? xy * xy / xx : 0);
  return n > 2 && xx > 0 && rest > 0 ? xy / std::sqrt(xx * rest / (n - 2)) : 0;
}

bool constant_restitution(const FitRequest& request) {
  return request.law != LawName::kuwabara_kono && !request.alpha_of_speed;
}

/// What these data cannot tell, and what this law cannot do.
std::vector<std::string> findings(const Fit& fit, const VectorXd& residuals, const std::vector<Measurement>& data) {
  std::vector<std::string> said;
  const bool with_times = data[0].tcol > 0;
  if (!with_times) said.push_back("no collision times: the stiffness cannot be told, only what sets the restitution");
  if (fit.request.law == LawName::fractional && !fit.request.alpha_of_speed && with_times)
    said.push_back("k and c cannot be told apart: only c^alpha k^(1-alpha) shows");
  const bool misses = fit.errors_known && fit.probability < 1e-3;
  if (constant_restitution(fit.request) && std::abs(trend(residuals, data)) > 4)
    said.push_back("misfit: the law gives the same restitution at every speed, the data change with it");
  else if (misses)
    said.push_back("misfit: a chi2 this large comes by chance less than once in a thousand");
  for (const Estimate& p : fit.parameters)
    if (!(p.error < std::abs(p.value)))
      said.push_back(p.name + " is not determined: its standard error is as large as itself");
  return said;
}

/// Reported parameters, errors and correlations from the covariance of u.
void report(Fit& fit, const FitModel& model, const VectorXd& u, const MatrixXd& covariance) {
  const auto at = model.parameters(u);
  const auto n = static_cast<Index>(at.size());
  MatrixXd slope(n, u.size());
  constexpr double step = 1e-5;
  for (Index i = 0; i < u.size(); ++i) {
    VectorXd ahead = u, behind = u;
    ahead[i] += step;
    behind[i] -= step;
    const auto a = model.parameters(ahead), b = model.parameters(behind);
    for (Index p = 0; p < n; ++p)
      slope(p, i) = (a[static_cast<std::size_t>(p)].value - b[static_cast<std::size_t>(p)].value) / (2 * step);
  }
  const MatrixXd c = slope * covariance * slope.transpose();
  for (Index p = 0; p < n; ++p) {
    const auto& parameter = at[static_cast<std::size_t>(p)];
    fit.parameters.push_back({parameter.name, parameter.value, std::sqrt(c(p, p)), parameter.unit});
    fit.correlations.emplace_back();
    for (Index q = 0; q < n; ++q) fit.correlations.back().push_back(c(p, q) / std::sqrt(c(p, p) * c(q, q)));
  }
}

/// (JᵀJ)⁻¹, from columns of unit length; throws where a direction leaves the data unchanged.
MatrixXd covariance_of(const MatrixXd& jacobian, const FitRequest& request) {
  const VectorXd length = jacobian.colwise().norm();
  if (!(length.minCoeff() > 0)) throw NotConverged(fit_name(request) + ": a parameter has no effect on these data");
  const MatrixXd scaled = jacobian * length.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scaled.transpose() * scaled);
  if (!(eigen.eigenvalues().minCoeff() > 1e-12))
    throw NotConverged(fit_name(request) + ": these data cannot tell its parameters apart");
  const MatrixXd inverse = eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
  return length.cwiseInverse().asDiagonal() * inverse * length.cwiseInverse().asDiagonal();
}

}  // namespace

std::string fit_name(const FitRequest& request) {
  return std::string(text(request.law)) + (request.alpha_of_speed ? ", alpha(v)" : "");
}

Fit fit_law(const FitRequest& request, const std::vector<Measurement>& data) {
  if (data.empty()) throw std::invalid_argument("measurements = 0: must be more than there are parameters");
  const bool with_times = data[0].tcol > 0;
  const auto model = fit_model(request, with_times);
  require_data(request, data, model->unknowns());
  Residuals residuals(*model, data);
  for (const auto& start : model->starts(data[data.size() / 2].velocity, data[data.size() / 2].tcol)) residuals.value(start);
  // Begun anew until a run gains nothing.
  for (double before = std::numeric_limits<double>::infinity(); residuals.best_value < before * (1 - 1e-6);) {
    before = residuals.best_value;
    minimise(residuals);
    polish(residuals);
  }
  const VectorXd u = residuals.best, r = residuals(u);
  const MatrixXd covariance = covariance_of(residuals.jacobian(u), request);

  Fit fit{request, {}, {}, {}, r.squaredNorm(), static_cast<std::size_t>(r.size()), 0, data[0].en_sigma > 0, 0, 1};
  fit.freedom = fit.observations - static_cast<std::size_t>(u.size());
  const double freedom = static_cast<double>(fit.freedom), n = static_cast<double>(fit.observations);
  report(fit, *model, u, fit.errors_known ? covariance : MatrixXd(covariance * (fit.chi2 / freedom)));
  const double count = static_cast<double>(u.size());
  fit.aic = fit.errors_known ? fit.chi2 + 2 * count
                             : n * std::log(std::max(fit.chi2, std::numeric_limits<double>::min()) / n) + 2 * (count + 1);
  if (fit.errors_known) fit.probability = boost::math::gamma_q(0.5 * freedom, 0.5 * fit.chi2);
  for (const Measurement& m : data) fit.predictions.push_back(model->predict(u, m.velocity));
  if (!with_times)
    for (Prediction& p : fit.predictions) p.tcol = 0;
  fit.solution.assign(u.begin(), u.end());
  fit.findings = findings(fit, r, data);
  return fit;
}

Prediction predict(const Fit& fit, double velocity) {
  detail::require_positive("velocity", velocity);
  const bool with_times = fit.observations > fit.predictions.size();
  const VectorXd u = Eigen::Map<const VectorXd>(fit.solution.data(), static_cast<Index>(fit.solution.size()));
  Prediction p = fit_model(fit.request, with_times)->predict(u, velocity);
  if (!with_times) p.tcol = 0;
  return p;
}

}  // namespace ricochet::calibration
