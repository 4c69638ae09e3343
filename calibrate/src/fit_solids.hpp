#pragma once

#include "fit_base.hpp"
#include "forward.hpp"

#include <ricochet/collision/reduction.hpp>

namespace ricochet::calibration {

// The laws of real solids as functions of the impact: docs/theory/solids.md says what of them can be told.

/// A linear one. Its restitution is one number at every speed, so what `Held` holds of it stays; u = (the loss of its
/// Reduction's coordinates[, ln k]). What sets the loss is taken to be the same for bodies of all sizes.
template <class Law>
class HeldModel : public LossModel {
 public:
  static constexpr bool follows_speed = false;
  HeldModel(const FitRequest& request, bool with_times);
  Prediction predict(const Eigen::VectorXd& u, const Shot& s) const override;
  std::vector<NamedValue> parameters(const Eigen::VectorXd& u) const override;

 private:
  double greatest_loss() const override { return greatest_loss_; }
  Reduced reduced(double loss) const;

  double greatest_loss_;
  mutable double last_loss_;  // all impacts of one u have the same: the last collision is remembered
  mutable Reduced last_;
};
using KelvinVoigtModel = HeldModel<FractionalKelvinVoigt>;
using ZenerModel = HeldModel<FractionalZener>;

/// fractional-hertz: u = (ln g at 1 m/s, ln(α/(1 − α))[, ln k]), where g goes with v^{α/5}, so that two speeds tell α.
/// g → ∞ is the pure power law, k = 0.
class HertzModel : public FitModel {
 public:
  static constexpr bool follows_speed = true;
  HertzModel(const FitRequest& request, bool with_times) : mass_(request.mass_eff), with_times_(with_times) {}
  Box box() const override;
  Prediction predict(const Eigen::VectorXd& u, const Shot& s) const override;
  std::vector<NamedValue> parameters(const Eigen::VectorXd& u) const override;
  std::vector<Eigen::VectorXd> starts(const std::vector<Measurement>& data) const override;

 private:
  double mass_;
  bool with_times_;
};

}  // namespace ricochet::calibration
