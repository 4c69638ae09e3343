#pragma once

#include "fit_model.hpp"

#include <cmath>
#include <initializer_list>

namespace ricochet::calibration {

// What the models of a fit have in common.

inline double logistic(double x) { return 1 / (1 + std::exp(-x)); }

inline Eigen::VectorXd vector(std::initializer_list<double> values) {
  Eigen::VectorXd v(static_cast<Eigen::Index>(values.size()));
  std::copy(values.begin(), values.end(), v.begin());
  return v;
}

/// e_n = 1 − O(e^u) for the loss that belongs to u: below −16 data cannot tell it from 1, nor central differences its
/// slope.
inline constexpr double least_loss = -16;
/// ln(α/(α_max − α)): at 6.9, α is a thousandth short of where nothing rebounds.
inline constexpr double greatest_logit = 6.9;
/// |ln k|, |ln c|, far outside what times and masses within 10^±50 need and inside what doubles hold.
inline constexpr double greatest_log = 400;

/// The impact that stands for the data, where a start needs one.
inline const Measurement& typical(const std::vector<Measurement>& data) { return data[data.size() / 2]; }

/// With times: u = (a measure of the loss, ln of the stiffness). Without: u = (the measure), and the stiffness does not
/// matter.
class LossModel : public FitModel {
 public:
  LossModel(const FitRequest& request, bool with_times) : request_(request), with_times_(with_times) {}
  Box box() const override;
  std::vector<Eigen::VectorXd> starts(const std::vector<Measurement>& data) const override;

 protected:
  /// t_col ∝ k^{−1/time_power}.
  virtual double time_power() const { return 2; }
  virtual double greatest_loss() const = 0;
  bool by_force() const { return request_.end == ContactEnd::force; }
  double stiffness(const Eigen::VectorXd& u) const { return with_times_ ? std::exp(u[1]) : 1; }
  double mass() const { return request_.mass_eff; }

  FitRequest request_;
  bool with_times_;
};

}  // namespace ricochet::calibration
