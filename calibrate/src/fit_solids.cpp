#include "fit_solids.hpp"

#include "forward_hertz.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace ricochet::calibration {
namespace {

using Eigen::VectorXd;

Reduced collided(const auto& law, ContactEnd end) {
  const auto out = collide(law, {1, 1}, {end});
  return {out.en, out.tcol};
}

/// The loss up to which the bodies part and less is kept the greater it is.
template <class Law>
double greatest_loss_of(const FitRequest& request) {
  // A little before the least e_n, that data still tell the loss.
  if constexpr (std::is_same_v<Law, FractionalZener>) return Reduction<Law>::lossiest(request.held) - 0.02;
  double high = 10;
  const auto parts = [&](double loss) {
    return collided(Reduction<Law>::at({0, loss}, request.held), request.end).tcol > 0;
  };
  if (parts(high)) return high;
  for (double low = least_loss; high - low > 1e-3;) {
    const double middle = 0.5 * (low + high);
    (parts(middle) ? low : high) = middle;
  }
  return high - 0.02;  // e_n falls to 0 there with an infinite slope
}

const ForwardHertz& forward_hertz() {
  static const ForwardHertz forward;
  return forward;
}

/// e_n on a grid by Kelvin and Voigt's law, which keeps what the Hertzian one of the same α and g does to 0.03: near
/// enough to say where a search shall begin, at a twentieth of the cost.
class RoughHertz {
 public:
  static constexpr std::array degrees{0.01, 0.03, 0.07, 0.15, 0.3, 0.5, 0.7, 0.9};
  static constexpr double low = -9, step = 0.5;
  static constexpr std::size_t count = 31;

  RoughHertz() {
    for (std::size_t i = 0; i < degrees.size(); ++i)
      for (std::size_t j = 0; j < count; ++j) en_[i][j] = collided(law(i, group(j)), ContactEnd::force).en;
  }
  static double group(std::size_t j) { return low + static_cast<double>(j) * step; }
  double operator()(std::size_t degree, double log_group) const {
    const double place = std::clamp((log_group - low) / step, 0.0, static_cast<double>(count) - 1.001);
    const auto j = static_cast<std::size_t>(place);
    return std::lerp(en_[degree][j], en_[degree][j + 1], place - static_cast<double>(j));
  }

 private:
  static FractionalKelvinVoigt law(std::size_t degree, double log_group) {
    return {1, std::exp(log_group), degrees[degree]};
  }
  std::array<std::array<double, count>, degrees.size()> en_{};
};

}  // namespace

template <class Law>
HeldModel<Law>::HeldModel(const FitRequest& request, bool with_times)
    : LossModel(request, with_times),
      greatest_loss_(greatest_loss_of<Law>(request)),
      last_loss_(std::numeric_limits<double>::quiet_NaN()),
      last_{0, 0} {}

template <class Law>
Reduced HeldModel<Law>::reduced(double loss) const {
  if (loss != last_loss_) last_ = collided(Reduction<Law>::at({0, loss}, request_.held), request_.end);
  last_loss_ = loss;
  return last_;
}

template <class Law>
Prediction HeldModel<Law>::predict(const VectorXd& u, const Shot& s) const {
  const Reduced r = reduced(u[0]);
  return {r.en, r.tcol * std::sqrt(mass() * s.mass_ratio / stiffness(u))};
}

template <class Law>
std::vector<NamedValue> HeldModel<Law>::parameters(const VectorXd& u) const {
  if (with_times_) {
    const auto unit = Reduction<Law>::at({u[1] - std::log(mass()), u[0]}, request_.held);
    const auto law = Reduction<Law>::in_si(unit, 1, {1, mass()});
    if (!law) throw NotConverged("no double carries its parameters");
    return law->identifiable();
  }
  if constexpr (std::is_same_v<Law, FractionalZener>) {
    const double alpha = request_.held.alpha;
    return {{"tau sqrt(k/m)", alpha > 0 ? std::exp((u[0] - std::log(request_.held.stiffening)) / alpha) : 1, ""}};
  } else {
    return {Law::loss_measure(std::exp(u[0]))};
  }
}

template class HeldModel<FractionalKelvinVoigt>;
template class HeldModel<FractionalZener>;

Box HertzModel::box() const {
  // From 1 − e_n < 5e-5 to where e_n is that of k = 0 to a per mille.
  constexpr double least = -10, greatest = hertz_without_spring;
  if (!with_times_) return {vector({least, -greatest_logit}), vector({greatest, greatest_logit})};
  return {vector({least, -greatest_logit, -greatest_log}), vector({greatest, greatest_logit, greatest_log})};
}

Prediction HertzModel::predict(const VectorXd& u, const Shot& s) const {
  // k of this shot over that of the request, as c is of c: both are their material's times √R.
  const double alpha = logistic(u[1]), stiffer = std::sqrt(s.radius_ratio);
  const double faster = std::log(s.velocity) + 2 * std::log(stiffer / s.mass_ratio);  // than T_H at 1 m/s, ×5
  const Reduced r = forward_hertz()(alpha, u[0] + alpha / 5 * faster);
  if (!with_times_) return {r.en, 0};
  return {r.en, r.tcol * std::exp(-faster / 5) * std::pow(mass_ / std::exp(u[2]), 0.4)};
}

std::vector<NamedValue> HertzModel::parameters(const VectorXd& u) const {
  const double group = std::exp(u[0]), alpha = logistic(u[1]);
  if (!with_times_) return {{"alpha", alpha, ""}, {"(c/k) (k/m)^(2 alpha/5) at 1 m/s", group, ""}};
  const double k = std::exp(u[2]);
  return ricochet::parameters(FractionalHertz(k, group * k * std::pow(mass_ / k, 0.4 * alpha), alpha));
}

std::vector<VectorXd> HertzModel::starts(const std::vector<Measurement>& data) const {
  static const RoughHertz rough;
  const Measurement& usual = typical(data);
  std::vector<std::pair<double, VectorXd>> found;
  for (std::size_t i = 0; i < RoughHertz::degrees.size(); ++i) {
    const double alpha = RoughHertz::degrees[i], slope = alpha / 5;
    const double at_one = -slope * std::log(usual.velocity);
    double least = std::numeric_limits<double>::infinity(), best = 0;
    for (std::size_t j = 0; j < RoughHertz::count; ++j) {
      double sum = 0;
      for (const Measurement& m : data) {
        const double off = rough(i, RoughHertz::group(j) + slope * std::log(m.velocity / usual.velocity)) - m.en;
        sum += m.en_sigma > 0 ? off * off / (m.en_sigma * m.en_sigma) : off * off;
      }
      if (sum < least) least = sum, best = RoughHertz::group(j) + at_one;
    }
    VectorXd u = vector({best, std::log(alpha / (1 - alpha)), 0});
    if (with_times_) u[2] = 2.5 * std::log(predict(u, {usual.velocity}).tcol / usual.tcol);
    if (!with_times_) u.conservativeResize(2);
    found.emplace_back(least, u);
  }
  std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return {found[0].second, found[1].second, found[2].second};
}

}  // namespace ricochet::calibration
