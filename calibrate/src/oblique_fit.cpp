#include <calibrate/oblique_fit.hpp>

#include <ricochet/collision/oblique.hpp>
#include <ricochet/collision/tangential_restitution.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/text.hpp>

#include <Eigen/Dense>

#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <nlopt.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <utility>

namespace ricochet::calibration {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;
using support::require;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// The two unknowns: ln μ, and β₀ of a damped spring or, of one without dashpot, how far its contact turns, √(k_t/m_t)
/// t_col: beyond π, half a period, β₀ would not tell.
using Point = std::array<double, 2>;

void check(const ObliqueFitRequest& request, const std::vector<ObliqueMeasurement>& data) {
  if (request.form == TangentialForm::mindlin)
    throw std::invalid_argument("tangential = mindlin: must be linear or linear-undamped");
  support::require_positive("tcol", request.tcol);
  support::require_positive("mass_eff", request.mass_eff);
  std::optional<bool> known;
  std::size_t observations = 0;
  for (const ObliqueMeasurement& m : data) {
    support::require_positive("normal_velocity", m.normal_velocity);
    support::require_positive("tangential_velocity", m.tangential_velocity);
    for (const auto& o : {m.et, m.rebound_angle, m.spin}) {
      if (!o) continue;
      ++observations;
      require(o->sigma >= 0, "sigma", o->sigma, ">= 0");
      require(known.value_or(o->sigma > 0) == (o->sigma > 0), "sigma", o->sigma, "> 0 for every number or for none");
      known = o->sigma > 0;
    }
    if (m.spin) require(request.radius > 0, "radius", request.radius, "> 0 where spins were measured");
  }
  require(observations > 2, "observations", static_cast<double>(observations), "more than the unknowns, 2");
}

/// The data against the contact of a point.
class ObliqueModel {
 public:
  ObliqueModel(const ObliqueFitRequest& request, const std::vector<ObliqueMeasurement>& data)
      : request_(request), data_(data) {}

  bool damped() const { return request_.form == TangentialForm::linear; }
  double least() const { return damped() ? 1e-3 : 0.1; }
  double greatest() const { return damped() ? 1 : 3 * pi; }
  LinearTangential spring(const Point& x) const {
    if (damped()) return tangential_for(x[1], request_.tcol, request_.mass_eff);
    return LinearTangential(tangential_mass_ratio * request_.mass_eff * std::pow(x[1] / request_.tcol, 2));
  }

  ObliquePrediction at(const Point& x, const ObliqueMeasurement& m) const {
    const double mu = std::exp(x[0]);
    const TangentialContact contact{.law = spring(x), .friction = {mu, mu, 0}};
    const double radius = request_.radius > 0 ? request_.radius : 1;
    const ObliqueImpact impact{
        .i = {.mass = request_.mass_eff, .radius = radius, .velocity = {m.tangential_velocity, 0, m.normal_velocity}}};
    const auto out = collide(request_.normal, contact, impact, {.end = request_.end});
    if (!out.separated()) throw NotConverged("an oblique collision could not be followed");
    return {.et = out.et.value(),
            .rebound_angle = std::atan2(out.velocity_i.x, -out.velocity_i.z),
            .spin = request_.spin_share * std::abs(out.spin_i.y),
            // With a spring every contact sticks for a moment at the first touch.
            .slides = out.impulse_ratio > 0.995 * mu};
  }

  VectorXd residuals(const Point& x) const {
    std::vector<double> r;
    r.reserve(3 * data_.size());
    for (const ObliqueMeasurement& m : data_) {
      const ObliquePrediction p = at(x, m);
      const double speed = std::hypot(m.normal_velocity, m.tangential_velocity);
      const auto add = [&](const std::optional<Observed>& o, double value, double unit) {
        if (o) r.push_back((value - o->value) / (o->sigma > 0 ? o->sigma : unit));
      };
      add(m.et, p.et, 1);
      add(m.rebound_angle, p.rebound_angle, 1);
      add(m.spin, p.spin, speed / std::max(request_.radius, 1e-30));
    }
    return Eigen::Map<VectorXd>(r.data(), static_cast<Index>(r.size()));
  }

  Matrix jacobian(const Point& x) const {
    constexpr double step = 1e-4;
    Matrix j;
    for (std::size_t i = 0; i < 2; ++i) {
      Point ahead = x, behind = x;
      ahead[i] += step;
      behind[i] -= step;
      if (i == 1) {
        ahead[1] = std::min(ahead[1], greatest());
        behind[1] = std::max(behind[1], least());
      }
      const VectorXd column = (residuals(ahead) - residuals(behind)) / (ahead[i] - behind[i]);
      if (i == 0) j.resize(column.size(), 2);
      j.col(static_cast<Index>(i)) = column;
    }
    return j;
  }

  double value(const Point& x) {
    const double sum = residuals(x).squaredNorm();
    if (sum < least_sum) {
      least_sum = sum;
      best = x;
    }
    return sum;
  }

  Point clamped(const Point& x) const {
    return {std::clamp(x[0], least_log_mu, greatest_log_mu), std::clamp(x[1], least(), greatest())};
  }

  static constexpr double least_log_mu = -7, greatest_log_mu = 3;
  double least_sum = std::numeric_limits<double>::max();
  Point best{-1, 0.5};

 private:
  const ObliqueFitRequest& request_;
  const std::vector<ObliqueMeasurement>& data_;
};

double objective(const std::vector<double>& x, std::vector<double>&, void* data) {
  return static_cast<ObliqueModel*>(data)->value({x[0], x[1]});
}

/// BOBYQA from one point.
void search_from(ObliqueModel& model, const Point& start) {
  nlopt::opt optimizer(nlopt::LN_BOBYQA, 2);
  optimizer.set_min_objective(objective, &model);
  optimizer.set_lower_bounds({ObliqueModel::least_log_mu, model.least()});
  optimizer.set_upper_bounds({ObliqueModel::greatest_log_mu, model.greatest()});
  optimizer.set_initial_step(0.1);
  optimizer.set_xtol_rel(1e-9);
  optimizer.set_maxeval(100);
  std::vector<double> x(start.begin(), start.end());
  double value = 0;
  try {
    optimizer.optimize(x, value);
  } catch (const nlopt::roundoff_limited&) {  // the best point counts
  }
}

/// From the best points of a scan with a weak and with a stiff spring.
void search(ObliqueModel& model) {
  std::array<std::pair<double, Point>, 2> starts{std::pair(1e300, model.best), std::pair(1e300, model.best)};
  for (const double place : {0.15, 0.3, 0.45, 0.55, 0.7, 0.9})
    for (const double mu : {0.02, 0.05, 0.1, 0.2, 0.4, 0.8}) {
      const Point x{std::log(mu), (model.damped() ? 1 : 2 * pi) * place};
      auto& best = starts.at(place > 0.5 ? 1 : 0);
      if (const double value = model.value(x); value < best.first) best = {value, x};
    }
  for (const auto& [value, start] : starts)
    if (value < 1e300) search_from(model, start);
  for (int step = 0; step < 6; ++step) {  // Gauss-Newton takes the last digits
    const double before = model.least_sum;
    const VectorXd move = model.jacobian(model.best).colPivHouseholderQr().solve(model.residuals(model.best));
    if (!move.allFinite() || move.norm() > 1) return;
    model.value(model.clamped({model.best[0] - move[0], model.best[1] - move[1]}));
    if (!(model.least_sum < before * (1 - 1e-12))) return;
  }
}

/// μ alone, beside a spring of half a period: where every impact then slides throughout and no more is left over than a
/// second parameter would take by chance (two standard errors of Student's t), the data know nothing of the spring. A
/// weak one, which is strained all along, would fit them about as well.
std::optional<Point> sliding_alone(const ObliqueModel& model, const std::vector<ObliqueMeasurement>& data,
                                   std::size_t observations) {
  const double second = model.damped() ? 0.5 : pi;
  const auto all_slide = [&](const Point& x) {
    return std::all_of(data.begin(), data.end(), [&](const ObliqueMeasurement& m) { return model.at(x, m).slides; });
  };
  if (!all_slide({model.best[0], second})) return std::nullopt;
  double low = model.best[0] - 1, high = model.best[0] + 1;
  const auto left = [&](double log_mu) { return model.residuals({log_mu, second}).squaredNorm(); };
  for (int i = 0; i < 40; ++i) {
    const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
    (left(a) < left(b) ? high : low) = left(a) < left(b) ? b : a;
  }
  const Point found{0.5 * (low + high), second};
  if (!all_slide(found)) return std::nullopt;
  const double freedom = static_cast<double>(observations) - 2, t = gsl_cdf_tdist_Pinv(0.97725, freedom);
  const double chance = std::max(model.least_sum / freedom, 1e-12) * t * t;
  return left(found[0]) - model.least_sum < chance ? std::optional(found) : std::nullopt;
}

/// The parameters that the data tell with errors, from (JᵀJ)⁻¹; what they do not, in words.
void tell(ObliqueFit& fit, const Matrix& j, double second, double scatter, bool all_slide, bool none_slides) {
  const std::string name = fit.turn ? "sqrt(k_t/m_t) tcol" : "beta0";
  const double of_mu = j.col(0).squaredNorm(), of_beta = j.col(1).squaredNorm(), mixed = j.col(0).dot(j.col(1));
  const bool mu_told = of_mu > 1e-12, beta_told = !all_slide && of_beta > 1e-12 * std::max(1.0, of_mu);
  const double rest = of_mu * of_beta - mixed * mixed;
  if (all_slide)
    fit.findings.push_back("every impact slides throughout: the spring shows in none of them, mu alone is told");
  if (none_slides)
    fit.findings.push_back("no impact slides throughout: mu shows only in how the contacts begin and end");
  if (mu_told && beta_told && rest > 1e-10 * of_mu * of_beta) {
    fit.parameters.push_back({"mu", fit.mu, fit.mu * scatter * std::sqrt(of_beta / rest), ""});
    fit.parameters.push_back({name, second, scatter * std::sqrt(of_mu / rest), ""});
    fit.correlation = -mixed / std::sqrt(of_mu * of_beta);
  } else if (mu_told) {
    fit.parameters.push_back({"mu", fit.mu, fit.mu * scatter / std::sqrt(of_mu), ""});
    if (beta_told) fit.findings.push_back(fmt::format("these data cannot tell mu and {} apart", name));
  } else if (beta_told) {
    fit.parameters.push_back({name, second, scatter / std::sqrt(of_beta), ""});
  }
  for (const Estimate& p : fit.parameters)
    if (!(p.error < std::abs(p.value)))
      fit.findings.push_back(fmt::format("{} is not determined: its standard error is as large as itself", p.name));
}

}  // namespace

ObliqueFit fit_oblique(const ObliqueFitRequest& request, const std::vector<ObliqueMeasurement>& data) {
  check(request, data);
  ObliqueModel model(request, data);
  search(model);
  std::size_t observations = 0;
  for (const ObliqueMeasurement& m : data)
    observations +=
        std::size_t{m.et.has_value()} + std::size_t{m.rebound_angle.has_value()} + std::size_t{m.spin.has_value()};
  if (const auto alone = sliding_alone(model, data, observations)) {
    model.best = *alone;
    model.least_sum = model.residuals(*alone).squaredNorm();
  }
  ObliqueFit fit{.law = model.spring(model.best), .mu = std::exp(model.best[0]), .chi2 = model.least_sum};
  fit.observations = observations;
  fit.beta0 = sticking_restitution(fit.law, request.tcol, request.mass_eff);
  if (!model.damped()) fit.turn = model.best[1];
  bool all = true, none = true;
  for (const ObliqueMeasurement& m : data) {
    fit.predictions.push_back(model.at(model.best, m));
    all = all && fit.predictions.back().slides;
    none = none && !fit.predictions.back().slides;
    for (const auto& o : {m.et, m.rebound_angle, m.spin}) {
      if (o) fit.errors_known = o->sigma > 0;
    }
  }
  fit.freedom = fit.observations - 2;
  const double over = fit.chi2 / static_cast<double>(fit.freedom);
  tell(fit, model.jacobian(model.best), model.best[1], fit.errors_known ? 1 : std::sqrt(over), all, none);
  if (!all && (model.best[1] >= model.greatest() || model.best[1] <= model.least()))
    fit.findings.push_back("the spring has run to the end of its range: the data only tell that it is there or beyond");
  if (!fit.errors_known) return fit;
  fit.probability = gsl_cdf_chisq_Q(fit.chi2, static_cast<double>(fit.freedom));
  if (fit.probability < 1e-3)
    fit.findings.push_back("misfit: a chi2 this large comes by chance less than once in a thousand");
  return fit;
}

}  // namespace ricochet::calibration
