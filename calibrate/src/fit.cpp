#include "fit_findings.hpp"
#include "fit_model.hpp"

#include <ricochet/support/require.hpp>

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <nlopt.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double far_off = 1e300;

/// The data against a model, as weighted residuals of u; remembers the best u it was asked about.
class Residuals {
 public:
  Residuals(const FitRequest& request, const FitModel& model, const std::vector<Measurement>& data)
      : model_(model), data_(data) {
    for (const Measurement& m : data) shots_.push_back(shot_of(request, m));
  }

  VectorXd operator()(const VectorXd& u) const {
    std::vector<double> r;
    for (std::size_t i = 0; i < data_.size(); ++i) {
      const Measurement& m = data_[i];
      const Prediction p = model_.predict(u, shots_[i]);
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
  std::vector<Shot> shots_;
};

double objective(const std::vector<double>& x, std::vector<double>& gradient, void* data) {
  auto& residuals = *static_cast<Residuals*>(data);
  const VectorXd u = Eigen::Map<const VectorXd>(x.data(), static_cast<Index>(x.size()));
  std::fill(gradient.begin(), gradient.end(), 0);
  const double value = u.allFinite() ? residuals.value(u) : far_off;
  if (!(value < far_off)) return far_off;  // where only a line search that lost its way comes
  if (!gradient.empty()) {
    const VectorXd g = 2 / residuals.scale * residuals.jacobian(u).transpose() * residuals(u);
    if (g.allFinite()) std::copy(g.begin(), g.end(), gradient.begin());
  }
  return value / residuals.scale;
}

/// Gauss-Newton from the best point while it gains: the last digits, which χ² itself is too flat to show.
void polish(Residuals& residuals, const Box& box) {
  for (int step = 0; step < 20; ++step) {
    const double before = residuals.best_value;
    const MatrixXd j = residuals.jacobian(residuals.best);
    const VectorXd move = j.colPivHouseholderQr().solve(residuals(residuals.best));
    if (!move.allFinite()) return;
    residuals.value((residuals.best - move).cwiseMax(box.low).cwiseMin(box.high));
    if (!(residuals.best_value < before * (1 - 1e-12))) return;
  }
}

/// NLopt's SLSQP from the best point so far, kept near it: the scan was fine, and far off the forward model is slow.
void minimise(Residuals& residuals, const Box& box) {
  residuals.scale = std::max(residuals.best_value, 1e-300);
  std::vector<double> x(residuals.best.begin(), residuals.best.end());
  nlopt::opt optimizer(nlopt::LD_SLSQP, static_cast<unsigned>(x.size()));
  optimizer.set_min_objective(objective, &residuals);
  const VectorXd low = box.low.cwiseMax((residuals.best.array() - 2).matrix());
  const VectorXd high = box.high.cwiseMin((residuals.best.array() + 2).matrix());
  optimizer.set_lower_bounds({low.begin(), low.end()});
  optimizer.set_upper_bounds({high.begin(), high.end()});
  optimizer.set_ftol_rel(1e-10);
  optimizer.set_maxeval(100);
  double value = 0;
  try {
    optimizer.optimize(x, value);
  } catch (const std::runtime_error&) {  // rounding is all that is left; the best point counts
  }
}

/// The u of least χ²: from the best of the model's starts, begun anew until a run gains nothing.
VectorXd least_squares(const FitRequest& request, const FitModel& model, const std::vector<Measurement>& data) {
  const Box box = model.box();
  Residuals residuals(request, model, data);
  for (const auto& start : model.starts(data)) residuals.value(start.cwiseMax(box.low).cwiseMin(box.high));
  if (!(residuals.best_value < far_off)) throw NotConverged("no start comes near these data");
  for (double before = std::numeric_limits<double>::infinity(); residuals.best_value < before * (1 - 1e-6);) {
    before = residuals.best_value;
    polish(residuals, box);  // where a start lies near, it is all there is to do, and strays less than a line search
    minimise(residuals, box);
    polish(residuals, box);
  }
  return residuals.best;
}

/// d(parameters)/du, by central differences.
MatrixXd slope_of(const FitModel& model, const VectorXd& u) {
  constexpr double step = 1e-5;
  MatrixXd slope(u.size(), u.size());
  for (Index i = 0; i < u.size(); ++i) {
    VectorXd ahead = u, behind = u;
    ahead[i] += step;
    behind[i] -= step;
    const auto a = model.parameters(ahead), b = model.parameters(behind);
    for (Index p = 0; p < u.size(); ++p)
      slope(p, i) = (a[static_cast<std::size_t>(p)].value - b[static_cast<std::size_t>(p)].value) / (2 * step);
  }
  return slope;
}

/// Throws where these parameters, as many as are named, cannot be told from the data.
[[noreturn]] void cannot_tell(const std::vector<std::string>& names) {
  if (names.size() == 1)
    throw NotConverged(fmt::format("{} has no effect on these data, which cannot tell it", names.front()));
  throw NotConverged(fmt::format("these data cannot tell {} apart", fmt::join(names, " and ")));
}

/// For each unknown the parameter that follows it most, by which it is called.
std::vector<std::string> names_of(const FitModel& model, const VectorXd& u) {
  const auto parameters = model.parameters(u);
  MatrixXd share = slope_of(model, u).cwiseAbs();
  for (Index p = 0; p < u.size(); ++p) share.row(p) /= std::abs(parameters[static_cast<std::size_t>(p)].value);
  std::vector<std::string> names;
  for (Index i = 0; i < u.size(); ++i) {
    Index most = 0;
    share.col(i).maxCoeff(&most);
    names.push_back(parameters[static_cast<std::size_t>(most)].name);
  }
  return names;
}

/// (JᵀJ)⁻¹, from columns of unit length; throws where a direction leaves the data unchanged.
MatrixXd covariance_of(const MatrixXd& jacobian, const std::vector<std::string>& names) {
  const VectorXd length = jacobian.colwise().norm();
  for (Index i = 0; i < length.size(); ++i)
    if (!(length[i] > 0)) cannot_tell({names[static_cast<std::size_t>(i)]});
  const MatrixXd scaled = jacobian * length.cwiseInverse().asDiagonal();
  const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(scaled.transpose() * scaled);  // eigenvalues rise
  if (!(eigen.eigenvalues()[0] > 1e-12)) {
    std::vector<std::string> mixed;
    for (Index i = 0; i < length.size(); ++i)
      if (std::abs(eigen.eigenvectors()(i, 0)) > 0.1) mixed.push_back(names[static_cast<std::size_t>(i)]);
    cannot_tell(mixed);
  }
  const MatrixXd inverse =
      eigen.eigenvectors() * eigen.eigenvalues().cwiseInverse().asDiagonal() * eigen.eigenvectors().transpose();
  return length.cwiseInverse().asDiagonal() * inverse * length.cwiseInverse().asDiagonal();
}

/// The parameters with errors √diag C and correlations, C = S (JᵀJ)⁻¹ Sᵀ scatter².
void report(Fit& fit, const FitModel& model, const VectorXd& u, const MatrixXd& covariance, double scatter) {
  const MatrixXd slope = slope_of(model, u);
  const MatrixXd c = slope * covariance * slope.transpose();
  const auto parameters = model.parameters(u);
  for (Index p = 0; p < u.size(); ++p) {
    const auto& parameter = parameters[static_cast<std::size_t>(p)];
    fit.parameters.push_back({parameter.name, parameter.value, scatter * std::sqrt(c(p, p)), parameter.unit});
    fit.correlations.emplace_back();
    for (Index q = 0; q < u.size(); ++q) fit.correlations.back().push_back(c(p, q) / std::sqrt(c(p, p) * c(q, q)));
  }
}

std::vector<std::string> names_at_the_edge(const std::vector<std::string>& names, const VectorXd& u, const Box& box) {
  std::vector<std::string> found;
  for (Index i = 0; i < u.size(); ++i)
    if (u[i] <= box.low[i] || u[i] >= box.high[i]) found.push_back(names[static_cast<std::size_t>(i)]);
  return found;
}

/// χ² and what follows from it.
void judge(Fit& fit, const VectorXd& residuals) {
  const double n = static_cast<double>(residuals.size()), p = static_cast<double>(fit.unknowns());
  // Where σ is not known, no less than what the forward model's own error leaves.
  const double least = fit.errors_known ? 0 : n * model_error * model_error;
  fit.aic = fit.errors_known ? fit.chi2 + 2 * p : n * std::log(std::max(fit.chi2, least) / n) + 2 * (p + 1);
  const double estimated = fit.errors_known ? p : p + 1;
  if (n > estimated + 1) fit.aicc = fit.aic + 2 * estimated * (estimated + 1) / (n - estimated - 1);
  if (fit.errors_known) fit.probability = gsl_cdf_chisq_Q(fit.chi2, static_cast<double>(fit.freedom));
}

}  // namespace

Fit fit_law(const FitRequest& request, const std::vector<Measurement>& data) {
  require_fit(request, data);
  const bool with_times = data[0].tcol > 0;
  const auto model = fit_model(request, with_times);
  require_observations(request, data, model->unknowns());
  const VectorXd u = least_squares(request, *model, data);
  const Residuals residuals(request, *model, data);
  const VectorXd r = residuals(u);

  Fit fit{.request = request,
          .parameters = {},
          .correlations = {},
          .predictions = {},
          .chi2 = r.squaredNorm(),
          .observations = static_cast<std::size_t>(r.size()),
          .errors_known = data[0].en_sigma > 0,
          .probability = 1};
  fit.freedom = fit.observations - static_cast<std::size_t>(u.size());
  const double scatter = std::sqrt(fit.chi2 / static_cast<double>(fit.freedom));
  const auto names = names_of(*model, u);
  report(fit, *model, u, covariance_of(residuals.jacobian(u), names), fit.errors_known ? 1 : scatter);
  judge(fit, r);
  for (const Measurement& m : data) fit.predictions.push_back(model->predict(u, shot_of(request, m)));
  if (!with_times)
    for (Prediction& p : fit.predictions) p.tcol = 0;
  fit.solution.assign(u.begin(), u.end());
  fit.findings = findings(fit, names_at_the_edge(names, u, model->box()), r, data);
  return fit;
}

Prediction predict(const Fit& fit, double velocity) {
  support::require_positive("velocity", velocity);
  const bool with_times = fit.observations > fit.predictions.size();
  const VectorXd u = Eigen::Map<const VectorXd>(fit.solution.data(), static_cast<Index>(fit.solution.size()));
  Prediction p = fit_model(fit.request, with_times)->predict(u, {velocity});
  if (!with_times) p.tcol = 0;
  return p;
}

}  // namespace ricochet::calibration
