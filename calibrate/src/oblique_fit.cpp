#include "fit_findings.hpp"
#include "oblique_check.hpp"

#include <calibrate/oblique_fit.hpp>

#include <ricochet/collision/oblique.hpp>
#include <ricochet/collision/tangential_restitution.hpp>
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
#include <utility>

namespace ricochet::calibration {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using std::numbers::pi;
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, 2>;

/// The two unknowns: ln μ, and β₀ of a damped spring or, of one without dashpot, how far its contact turns, √(k_t/m_t)
/// t_col: beyond π, half a period, β₀ would not tell.
using Point = std::array<double, 2>;

/// The data against the contact of a point.
class ObliqueModel {
 public:
  ObliqueModel(const ObliqueFitRequest& request, const std::vector<ObliqueMeasurement>& data)
      : request_(request), data_(data) {}

  bool damped() const { return request_.form == TangentialForm::linear; }
  double least() const { return damped() ? 1e-3 : 0.1; }
  /// Of a spring with a dashpot short of 1, where the contact would come back as it went in.
  double greatest() const { return damped() ? 0.999 : 3 * pi; }
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

  /// Σ of the squared residuals; infinite where a collision could not be followed.
  double value(const Point& x) const {
    try {
      return residuals(x).squaredNorm();
    } catch (const NotConverged&) {
      return std::numeric_limits<double>::infinity();
    }
  }

  Point clamped(const Point& x) const {
    return {std::clamp(x[0], least_log_mu, greatest_log_mu), std::clamp(x[1], least(), greatest())};
  }

  static constexpr double least_log_mu = -7, greatest_log_mu = 3;

 private:
  const ObliqueFitRequest& request_;
  const std::vector<ObliqueMeasurement>& data_;
};

/// A place where the sum of squares is least around.
struct Minimum {
  Point x{};
  double sum = std::numeric_limits<double>::infinity();
};

bool less(const Minimum& a, const Minimum& b) { return a.sum < b.sum; }

/// What a search has seen so far.
struct Trial {
  const ObliqueModel& model;
  Minimum least;
  double worst = 0;

  void take(const Point& x, double sum) {
    if (sum < least.sum) least = {x, sum};
  }
};

/// What cannot be followed counts as worse than all before, and finite, since BOBYQA reckons with it.
double objective(const std::vector<double>& x, std::vector<double>&, void* data) {
  auto& trial = *static_cast<Trial*>(data);
  const double sum = trial.model.value({x[0], x[1]});
  if (!std::isfinite(sum)) return 10 * trial.worst;
  trial.worst = std::max(trial.worst, sum);
  trial.take({x[0], x[1]}, sum);
  return sum;
}

/// BOBYQA from one point.
void search_from(Trial& trial, double step, double tolerance, int evaluations) {
  const ObliqueModel& model = trial.model;
  nlopt::opt optimizer(nlopt::LN_BOBYQA, 2);
  optimizer.set_min_objective(objective, &trial);
  optimizer.set_lower_bounds({ObliqueModel::least_log_mu, model.least()});
  optimizer.set_upper_bounds({ObliqueModel::greatest_log_mu, model.greatest()});
  optimizer.set_initial_step(step);
  optimizer.set_xtol_rel(tolerance);
  optimizer.set_maxeval(evaluations);
  std::vector<double> x(trial.least.x.begin(), trial.least.x.end());
  double value = 0;
  try {
    optimizer.optimize(x, value);
  } catch (const nlopt::roundoff_limited&) {  // the best point counts
  }
}

/// Gauss-Newton takes the last digits.
void polish(Trial& trial) {
  const ObliqueModel& model = trial.model;
  for (int step = 0; step < 6; ++step) {
    const Minimum before = trial.least;
    VectorXd move;
    try {
      move = model.jacobian(before.x).colPivHouseholderQr().solve(model.residuals(before.x));
    } catch (const NotConverged&) {  // beside the point, which counts
      return;
    }
    if (!move.allFinite() || move.norm() > 1) return;
    const Point x = model.clamped({before.x[0] - move[0], before.x[1] - move[1]});
    trial.take(x, model.value(x));
    if (!(trial.least.sum < before.sum * (1 - 1e-12))) return;
  }
}

/// The points of a scan that none of their eight neighbours is below, the least first: a spring that turns back a
/// little sooner or later, or once more, is a valley of its own.
std::vector<Minimum> scan(const ObliqueModel& model) {
  constexpr int rows = 10;  // of ln μ, from 0.01 to 2
  const int columns = model.damped() ? 8 : 24;
  const auto at = [&](int i, int j) -> Point {
    const double across = (j + 0.5) / columns;
    return {std::log(0.01) + i * std::log(200.0) / (rows - 1), (model.damped() ? 1 : 3 * pi) * across};
  };
  Eigen::MatrixXd sums(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) sums(i, j) = model.value(at(i, j));
  std::vector<Minimum> all;
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) {
      const int top = std::max(i - 1, 0), left = std::max(j - 1, 0);
      const auto around = sums.block(top, left, std::min(i + 2, rows) - top, std::min(j + 2, columns) - left);
      if (std::isfinite(sums(i, j)) && sums(i, j) <= around.minCoeff()) all.push_back({at(i, j), sums(i, j)});
    }
  if (all.empty()) throw NotConverged("the oblique collisions of these data could not be followed");
  std::sort(all.begin(), all.end(), less);
  all.resize(std::min<std::size_t>(all.size(), 8));
  return all;
}

/// Twelve at most, spread over the angles: enough to tell the valleys.
std::vector<ObliqueMeasurement> thinned(std::vector<ObliqueMeasurement> data) {
  constexpr std::size_t enough = 12;
  if (data.size() <= enough) return data;
  std::stable_sort(data.begin(), data.end(), [](const ObliqueMeasurement& a, const ObliqueMeasurement& b) {
    return a.tangential_velocity * b.normal_velocity < b.tangential_velocity * a.normal_velocity;
  });
  std::vector<ObliqueMeasurement> some;
  some.reserve(enough);
  for (std::size_t i = 0; i < enough; ++i) some.push_back(data[i * (data.size() - 1) / (enough - 1)]);
  return some;
}

/// The minima around the best points of a scan, the least first; to its last digits only that one.
std::vector<Minimum> search(const ObliqueModel& model, const ObliqueFitRequest& request,
                            const std::vector<ObliqueMeasurement>& data, bool errors_known) {
  const auto some = thinned(data);
  const ObliqueModel rough(request, some);
  std::vector<Minimum> found = scan(rough);
  for (Minimum& start : found) {
    Trial trial{rough, start};
    search_from(trial, 0.1, 1e-5, 25);
    start = trial.least;
  }
  std::sort(found.begin(), found.end(), less);
  // What lies far above has no part in the answer.
  const double far = 100 * std::max(found.front().sum, errors_known ? 10 : 1e-6);
  found.erase(std::find_if(found.begin() + 1, found.end(), [&](const Minimum& m) { return m.sum > far; }), found.end());
  for (Minimum& m : found) {
    Trial trial{model, {m.x, model.value(m.x)}};
    polish(trial);
    m = trial.least;
  }
  std::sort(found.begin(), found.end(), less);
  Trial trial{model, found.front()};
  search_from(trial, 0.01, 1e-9, 60);
  polish(trial);
  found.front() = trial.least;
  return found;
}

/// How far Σ may rise by chance at `errors` standard errors of one parameter: errors² where σ is known, else that many
/// scatters of what is left over.
double chance(const ObliqueFit& fit, double sum, double errors) {
  const double scatter = fit.errors_known ? 1 : std::max(sum / static_cast<double>(fit.freedom), 1e-12);
  return scatter * errors * errors;
}

/// Least Σ over ln μ alone: a scan of the whole range, then golden section.
Minimum least_along_mu(const ObliqueModel& model, double second) {
  Minimum least;
  constexpr int parts = 25;
  constexpr double low_end = ObliqueModel::least_log_mu, high_end = ObliqueModel::greatest_log_mu;
  constexpr double part = (high_end - low_end) / parts;
  for (int i = 0; i <= parts; ++i) {
    const Point x{low_end + part * i, second};
    if (const double sum = model.value(x); sum < least.sum) least = {x, sum};
  }
  double low = std::max(least.x[0] - part, low_end), high = std::min(least.x[0] + part, high_end);
  constexpr double golden = 0.6180339887498949;
  const auto left = [&](double log_mu) { return model.value({log_mu, second}); };
  double a = high - golden * (high - low), b = low + golden * (high - low), at_a = left(a), at_b = left(b);
  for (int i = 0; i < 22; ++i) {
    if (at_a < at_b) {
      high = std::exchange(b, a), at_b = at_a;
      a = high - golden * (high - low), at_a = left(a);
    } else {
      low = std::exchange(a, b), at_a = at_b;
      b = low + golden * (high - low), at_b = left(b);
    }
  }
  return at_a < at_b ? Minimum{{a, second}, at_a} : Minimum{{b, second}, at_b};
}

/// μ alone, beside a spring of half a period: where every impact then slides throughout and no more is left over than a
/// second parameter would take by chance (two standard errors; where σ is not known, of Student's t up to 4, since with
/// a degree of freedom or two it would allow anything), the data know nothing of the spring. A weak one, which is
/// strained all along, would fit them about as well.
std::optional<Minimum> sliding_alone(const ObliqueModel& model, const std::vector<ObliqueMeasurement>& data,
                                     const ObliqueFit& fit, double least_sum) {
  const Minimum alone = least_along_mu(model, model.damped() ? 0.5 : pi);
  if (!std::isfinite(alone.sum)) return std::nullopt;
  const double freedom = static_cast<double>(fit.freedom);
  const double errors = fit.errors_known ? 2 : std::min(gsl_cdf_tdist_Pinv(0.97725, freedom), 4.0);
  if (alone.sum - least_sum > chance(fit, least_sum, errors)) return std::nullopt;
  const auto misfit = [](double chi2, double degrees) { return gsl_cdf_chisq_Q(chi2, degrees) < 1e-3; };
  if (fit.errors_known && misfit(alone.sum, freedom + 1) && !misfit(least_sum, freedom)) return std::nullopt;
  const bool all_slide =
      std::all_of(data.begin(), data.end(), [&](const ObliqueMeasurement& m) { return model.at(alone.x, m).slides; });
  return all_slide ? std::optional(alone) : std::nullopt;
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

/// Other valleys whose least is within three standard errors of the best one's; of one valley, along which Σ does not
/// rise between them, the errors tell.
void name_others(ObliqueFit& fit, const ObliqueModel& model, const ObliqueFitRequest& request,
                 const std::vector<Minimum>& minima) {
  const double allowed = chance(fit, minima.front().sum, 3);
  std::vector<Minimum> named{minima.front()};
  for (const Minimum& other : minima) {
    if (other.sum - minima.front().sum > allowed) break;
    const bool new_valley = std::all_of(named.begin(), named.end(), [&](const Minimum& one) {
      double ridge = 0;
      for (const double part : {0.2, 0.4, 0.6, 0.8})
        ridge = std::max(ridge, model.value({std::lerp(one.x[0], other.x[0], part),  //
                                             std::lerp(one.x[1], other.x[1], part)}));
      return ridge > std::max(one.sum, other.sum) + allowed / 9;
    });
    if (!new_valley) continue;
    named.push_back(other);
    const auto* normal = std::get_if<Linear>(&request.normal);
    const std::string stiffness =
        normal ? fmt::format("k_t/k = {}, ", support::significant(model.spring(other.x).k_t() / normal->k(), 3)) : "";
    fit.findings.push_back(
        fmt::format("another spring fits about as well: {}{} = {} with mu = {}, {} = {}", stiffness,
                    model.damped() ? "beta0" : "sqrt(k_t/m_t) tcol", support::significant(other.x[1], 4),
                    support::significant(std::exp(other.x[0]), 4), fit.errors_known ? "chi2" : "sum of squares",
                    support::significant(other.sum, 4)));
  }
}

/// Parameters at the end of their range.
void name_ends(ObliqueFit& fit, const ObliqueModel& model, const Point& best, bool all_slide) {
  constexpr double near = 1e-6;
  if (best[0] >= ObliqueModel::greatest_log_mu - near || best[0] <= ObliqueModel::least_log_mu + near)
    fit.findings.push_back("mu has run to the end of its range: the data only tell that it is there or beyond");
  if (all_slide) return;
  if (model.damped() && best[1] >= model.greatest() - near)
    fit.findings.push_back("beta0 has run to 0.999, the end of its range: it is 1, or the spring is not damped");
  else if (best[1] >= model.greatest() - near || best[1] <= model.least() + near)
    fit.findings.push_back("the spring has run to the end of its range: the data only tell that it is there or beyond");
}

/// What lies far outside of the others.
void name_outliers(ObliqueFit& fit, const VectorXd& residuals, const std::vector<ObliqueMeasurement>& data) {
  std::vector<std::string> names;
  names.reserve(static_cast<std::size_t>(residuals.size()));
  for (std::size_t i = 0; i < data.size(); ++i) {
    const ObliqueMeasurement& m = data[i];
    const std::string where = m.line > 0 ? fmt::format("line {}", m.line) : fmt::format("measurement {}", i + 1);
    const auto add = [&](const std::optional<Observed>& o, const char* name, double unit) {
      if (o) names.push_back(fmt::format("{}: {} = {}", where, name, support::significant(o->value / unit, 4)));
    };
    add(m.et, "et", 1);
    add(m.rebound_angle, "rebound_angle [deg]", pi / 180);
    add(m.spin, "spin", 1);
  }
  for (const std::size_t i : far_out({residuals.begin(), residuals.end()}, fit.errors_known ? 1.0 : 1e-3))
    fit.findings.push_back(names[i] + " lies far outside the others: a slip, or what this law does not do");
}

/// How many numbers were measured, and whether with their errors.
void count(ObliqueFit& fit, const std::vector<ObliqueMeasurement>& data) {
  for (const ObliqueMeasurement& m : data)
    for (const auto& o : {m.et, m.rebound_angle, m.spin}) {
      if (!o) continue;
      ++fit.observations;
      fit.errors_known = o->sigma > 0;
    }
  fit.freedom = fit.observations - 2;
}

}  // namespace

ObliqueFit fit_oblique(const ObliqueFitRequest& request, const std::vector<ObliqueMeasurement>& data) {
  require_oblique(request, data);
  const ObliqueModel model(request, data);
  ObliqueFit fit{};
  count(fit, data);
  const std::vector<Minimum> minima = search(model, request, data, fit.errors_known);
  const auto alone = sliding_alone(model, data, fit, minima.front().sum);
  const Minimum best = alone.value_or(minima.front());
  fit.law = model.spring(best.x);
  fit.mu = std::exp(best.x[0]);
  fit.chi2 = best.sum;
  fit.beta0 = sticking_restitution(fit.law, request.tcol, request.mass_eff);
  if (!model.damped()) fit.turn = best.x[1];
  bool all = true, none = true;
  for (const ObliqueMeasurement& m : data) {
    fit.predictions.push_back(model.at(best.x, m));
    all = all && fit.predictions.back().slides;
    none = none && !fit.predictions.back().slides;
  }
  const double over = fit.chi2 / static_cast<double>(fit.freedom);
  tell(fit, model.jacobian(best.x), best.x[1], fit.errors_known ? 1 : std::sqrt(over), all, none);
  name_ends(fit, model, best.x, all);
  if (!alone && !all) name_others(fit, model, request, minima);
  name_outliers(fit, model.residuals(best.x), data);
  if (!fit.errors_known) return fit;
  fit.probability = gsl_cdf_chisq_Q(fit.chi2, static_cast<double>(fit.freedom));
  if (fit.probability < 1e-3)
    fit.findings.push_back("misfit: a chi2 this large comes by chance less than once in a thousand");
  return fit;
}

}  // namespace ricochet::calibration
