#include "fit_base.hpp"

namespace ricochet::calibration {

using Eigen::VectorXd;

Box LossModel::box() const {
  if (!with_times_) return {vector({least_loss}), vector({greatest_loss()})};
  return {vector({least_loss, -greatest_log}), vector({greatest_loss(), greatest_log})};
}

std::vector<VectorXd> LossModel::starts(const std::vector<Measurement>& data) const {
  const Measurement& usual = typical(data);
  std::vector<VectorXd> all;
  for (int i = -12; i <= 4 && 0.5 * i <= greatest_loss(); ++i) {
    VectorXd u(with_times_ ? 2 : 1);
    u[0] = 0.5 * i;
    if (with_times_) {
      u[1] = 0;
      const double now = predict(u, {usual.velocity}).tcol;
      if (!(now > 0)) continue;
      u[1] = time_power() * std::log(now / usual.tcol);  // from the time that k = 1 gives to the usual one
    }
    all.push_back(u);
  }
  return all;
}

}  // namespace ricochet::calibration
