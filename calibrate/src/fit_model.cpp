#include "fit_model.hpp"

#include "fit_base.hpp"
#include "fit_solids.hpp"
#include "forward.hpp"

#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <cmath>

namespace ricochet::calibration {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

const ForwardFractional& forward_fractional(ContactEnd end) {
  static const ForwardFractional by_force(ContactEnd::force);
  if (end == ContactEnd::force) return by_force;
  static const ForwardFractional by_overlap(ContactEnd::overlap);
  return by_overlap;
}

/// The α up to which the bodies part.
double greatest_alpha(ContactEnd end) { return end == ContactEnd::force ? 1 : overlap_limit; }

/// e_n and the collision time of a PowerLaw at k = m = v₀ = 1.
template <class Law>
Reduced reduced(double log_group, ContactEnd end) {
  static const ForwardDamped by_force(kind_of<Law>, ContactEnd::force);
  if (end == ContactEnd::force) return by_force(log_group);
  static const ForwardDamped by_overlap(kind_of<Law>, ContactEnd::overlap);
  return by_overlap(log_group);
}

template <>
Reduced reduced<Linear>(double log_group, ContactEnd end) {
  const auto out = collide(Linear(1, std::exp(log_group)), {1, 1}, {end});
  return {out.en, out.tcol};
}

/// The measure is ln γ at 1 m/s. With T = (m/(k v^{P−1}))^{1/(P+1)} and γ = c v^Q T^{Q+1}/m, γ goes with
/// v^{Q − (Q+1)(P−1)/(P+1)}: not at all for the linear law and Tsuji's, with v^{1/5} for Kuwabara and Kono's.
template <class Law>
class PowerModel : public LossModel {
  static constexpr double P = Law::stiffness_power, Q = Law::damping_power;
  static constexpr double speed_power = Q - (Q + 1) * (P - 1) / (P + 1);

 public:
  static constexpr bool follows_speed = speed_power != 0;
  using LossModel::LossModel;
  Prediction predict(const VectorXd& u, const Shot& s) const override {
    // k of this shot over that of the request.
    const double stiffer = P == 1 ? 1 : std::sqrt(s.radius_ratio);
    const Reduced r = reduced<Law>(u[0] + speed_power * std::log(s.velocity) + of_size(s, stiffer), request_.end);
    return {r.en, r.tcol * std::pow(mass() * s.mass_ratio / (stiffness(u) * stiffer * std::pow(s.velocity, P - 1)),
                                    1 / (P + 1))};
  }
  std::vector<NamedValue> parameters(const VectorXd& u) const override {
    const double k = stiffness(u), group = std::exp(u[0]);
    // c = γ m v^{−Q} T^{−Q−1} at v = 1 m/s.
    if (with_times_) return ricochet::parameters(Law(k, group * mass() * std::pow(k / mass(), (Q + 1) / (P + 1))));
    return {Law::loss_measure(group)};
  }

 private:
  /// ln of what γ = c k^{−q} m^{q−1}, q = (Q+1)/(P+1), is multiplied by where c goes with k; a law whose restitution
  /// does not follow the speed has it from its material, whatever the size.
  static double of_size(const Shot& s, double stiffer) {
    constexpr double q = (Q + 1) / (P + 1);
    return std::isfinite(Law::overdamped_from) ? 0 : (1 - q) * std::log(stiffer / s.mass_ratio);
  }
  double greatest_loss() const override { return by_force() ? 20 : std::log(Law::overdamped_from) - 0.02; }
  double time_power() const override { return P + 1; }
};

/// Any other law, by `collide` itself; the measure is the loss of its Reduction's coordinates.
template <class Law>
class CollidedModel : public LossModel {
 public:
  static constexpr bool follows_speed = !std::is_same_v<Law, Hysteretic>;
  using LossModel::LossModel;
  Prediction predict(const VectorXd& u, const Shot& s) const override {
    const auto out = collide(law(u), {s.velocity, mass() * s.mass_ratio}, {request_.end});
    return {out.en, out.tcol};
  }
  std::vector<NamedValue> parameters(const VectorXd& u) const override {
    if (with_times_) return ricochet::parameters(law(u));
    if constexpr (requires { law(u).loss_measure(); })
      return {law(u).loss_measure()};
    else
      return {ricochet::parameters(law(u))[1]};
  }

 private:
  double greatest_loss() const override { return 40; }
  Law law(const VectorXd& u) const { return Reduction<Law>::at({std::log(stiffness(u)), u[0]}); }
};

/// u = (ln α/(α_max − α), ln c^α k^{1−α}).
class FractionalModel : public LossModel {
 public:
  static constexpr bool follows_speed = false;
  using LossModel::LossModel;
  Prediction predict(const VectorXd& u, const Shot& s) const override {
    const double alpha = alpha_at(u);
    const Reduced r = forward_fractional(request_.end)(alpha);
    return {r.en, r.tcol * std::pow(stiffness(u) / (mass() * s.mass_ratio), -1 / (2 - alpha))};
  }
  std::vector<NamedValue> parameters(const VectorXd& u) const override {
    std::vector<NamedValue> all{{"alpha", alpha_at(u), ""}};
    if (with_times_) all.push_back({"c^alpha k^(1-alpha)", stiffness(u), "kg s^(alpha-2)"});
    return all;
  }

 private:
  double greatest_loss() const override { return greatest_logit; }
  double alpha_at(const VectorXd& u) const { return greatest_alpha(request_.end) * logistic(u[0]); }
};

/// u = (a, b[, ln k, ln c]): now k and c are told apart, because α changes.
class SpeedModel : public FitModel {
 public:
  SpeedModel(const FitRequest& request, bool with_times) : request_(request), with_times_(with_times) {}
  Box box() const override {
    // b = ±20 turns e_n from 1 to 0 within a third of a decade.
    if (!with_times_) return {vector({-1500, -20}), vector({1500, 20})};
    return {vector({-1500, -20, -greatest_log, -greatest_log}), vector({1500, 20, greatest_log, greatest_log})};
  }
  Prediction predict(const VectorXd& u, const Shot& s) const override {
    const double logit = std::min(u[0] + u[1] * std::log(s.velocity), greatest_logit);
    const double alpha = greatest_alpha(request_.end) * logistic(logit);
    const Reduced r = forward_fractional(request_.end)(alpha);
    if (!with_times_) return {r.en, 0};
    return {r.en, r.tcol * std::exp(-(alpha * u[3] + (1 - alpha) * u[2] - std::log(request_.mass_eff * s.mass_ratio)) /
                                    (2 - alpha))};
  }
  std::vector<NamedValue> parameters(const VectorXd& u) const override {
    std::vector<NamedValue> all{{"a", u[0], ""}, {"b", u[1], ""}};
    if (with_times_) {
      all.push_back({"k", std::exp(u[2]), "kg/s^2"});
      all.push_back({"c", std::exp(u[3]), "kg/s"});
    }
    return all;
  }
  std::vector<VectorXd> starts(const std::vector<Measurement>& data) const override {
    const double velocity = typical(data).velocity, tcol = typical(data).tcol;
    std::vector<VectorXd> all;
    for (int i = -10; i <= 6; ++i)
      for (const double slope : {-0.5, -0.2, 0.05, 0.2, 0.5}) {
        const double at_one = 0.5 * i - slope * std::log(velocity);
        if (!with_times_) {
          all.push_back(vector({at_one, slope}));
          continue;
        }
        const double k = request_.mass_eff * 10 / (tcol * tcol);
        all.push_back(vector({at_one, slope, std::log(k), std::log(k * tcol)}));
      }
    return all;
  }

 private:
  FitRequest request_;
  bool with_times_;
};

template <class Law>
struct ModelOf {
  using type = CollidedModel<Law>;
};
template <class Form>
struct ModelOf<PowerLaw<Form>> {
  using type = PowerModel<PowerLaw<Form>>;
};
template <>
struct ModelOf<Fractional> {
  using type = FractionalModel;
};
template <>
struct ModelOf<FractionalKelvinVoigt> {
  using type = KelvinVoigtModel;
};
template <>
struct ModelOf<FractionalHertz> {
  using type = HertzModel;
};
template <>
struct ModelOf<FractionalZener> {
  using type = ZenerModel;
};

}  // namespace

Shot shot_of(const FitRequest& request, const Measurement& m) {
  Shot shot{m.velocity};
  if (m.mass_eff > 0) shot.mass_ratio = m.mass_eff / request.mass_eff;
  if (m.radius_eff > 0 && request.radius_eff > 0) shot.radius_ratio = m.radius_eff / request.radius_eff;
  return shot;
}

bool follows_speed(const FitRequest& request) {
  return request.alpha_of_speed ||
         request.law.visit([]<class Law>(std::type_identity<Law>) { return ModelOf<Law>::type::follows_speed; });
}

std::unique_ptr<FitModel> fit_model(const FitRequest& request, bool with_times) {
  if (request.alpha_of_speed) return std::make_unique<SpeedModel>(request, with_times);
  return request.law.visit([&]<class Law>(std::type_identity<Law>) -> std::unique_ptr<FitModel> {
    return std::make_unique<typename ModelOf<Law>::type>(request, with_times);
  });
}

}  // namespace ricochet::calibration
