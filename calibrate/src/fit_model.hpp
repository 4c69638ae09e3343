#pragma once

#include <calibrate/fit.hpp>

#include <Eigen/Dense>

#include <memory>

namespace ricochet::calibration {

/// Error of a model's e_n, and relative of its t_col.
inline constexpr double model_error = 1e-9;

/// ln g of fractional-hertz at 1 m/s, up to which a fit goes: there k = 0 but in name.
inline constexpr double hertz_without_spring = 9;

/// Where the search goes: beyond, the law differs from an elastic or a wholly lossy one by less than can be told, or
/// the bodies no longer part.
struct Box {
  Eigen::VectorXd low, high;
};

/// One impact in the eyes of a model: how its bodies differ from those whose parameters are told.
struct Shot {
  double velocity = 0;
  double mass_ratio = 1;    ///< effective mass over the request's
  double radius_ratio = 1;  ///< effective radius over the request's
};
Shot shot_of(const FitRequest& request, const Measurement& m);

/// A law as a function of the impact, under parameters u within a box.
class FitModel {
 public:
  virtual ~FitModel() = default;
  virtual Box box() const = 0;
  Eigen::Index unknowns() const { return box().low.size(); }
  virtual Prediction predict(const Eigen::VectorXd& u, const Shot& shot) const = 0;
  /// What is told the user, as a function of u: one for each unknown.
  virtual std::vector<NamedValue> parameters(const Eigen::VectorXd& u) const = 0;
  /// Starting points, among which the fit takes the best: losses from small to great.
  virtual std::vector<Eigen::VectorXd> starts(const std::vector<Measurement>& data) const = 0;
};

/// The model of a request; with_times: the data have collision times, so that stiffness can be told.
std::unique_ptr<FitModel> fit_model(const FitRequest& request, bool with_times);

}  // namespace ricochet::calibration
