#include "fit_model.hpp"

#include "forward.hpp"

#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <cmath>

namespace ricochet::calibration {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

double logistic(double x) { return 1 / (1 + std::exp(-x)); }

VectorXd vector(std::initializer_list<double> values) {
  VectorXd v(static_cast<Index>(values.size()));
  std::copy(values.begin(), values.end(), v.begin());
  return v;
}

const ForwardFractional& forward_fractional(ContactEnd end) {
  static const ForwardFractional by_force(ContactEnd::force);
  if (end == ContactEnd::force) return by_force;
  static const ForwardFractional by_overlap(ContactEnd::overlap);
  return by_overlap;
}

/// The α up to which the bodies part.
double greatest_alpha(ContactEnd end) { return end == ContactEnd::force ? 1 : overlap_limit; }

/// e_n = 1 − O(e^u) for the loss that belongs to u: below −16 data cannot tell it from 1, nor central differences its
/// slope.
constexpr double least_loss = -16;
/// ln(α/(α_max − α)): at 6.9, α is a thousandth short of where nothing rebounds.
constexpr double greatest_logit = 6.9;
/// |ln k|, |ln c|, far outside what times and masses within 10^±50 need and inside what doubles hold.
constexpr double greatest_log = 400;

const ForwardDamped& forward_damped(LawName law, ContactEnd end) {
  static const ForwardDamped kuwabara_kono(LawName::kuwabara_kono, ContactEnd::force);
  if (law == LawName::kuwabara_kono) return kuwabara_kono;
  static const ForwardDamped by_force(LawName::tsuji, ContactEnd::force);
  static const ForwardDamped by_overlap(LawName::tsuji, ContactEnd::overlap);
  return end == ContactEnd::force ? by_force : by_overlap;
}

/// With times: u = (ln group, ln k). Without: u = (ln group), and k does not matter. `group` is what sets e_n at 1 m/s.
class Base : public FitModel {
 public:
  Base(const FitRequest& request, bool with_times) : request_(request), with_times_(with_times) {}
  Box box() const override {
    if (!with_times_) return {vector({least_loss}), vector({greatest_loss()})};
    return {vector({least_loss, -greatest_log}), vector({greatest_loss(), greatest_log})};
  }
  std::vector<VectorXd> starts(double velocity, double tcol) const override {
    std::vector<VectorXd> all;
    for (int i = -12; i <= 4 && 0.5 * i <= greatest_loss(); ++i) {
      VectorXd u(unknowns());
      u[0] = 0.5 * i;
      if (with_times_) {
        // t_col ∝ k^{−1/time_power}: from the time that k = 1 gives to the typical one.
        u[1] = 0;
        const double now = predict(u, velocity).tcol;
        if (!(now > 0)) continue;
        u[1] = time_power() * std::log(now / tcol);
      }
      all.push_back(u);
    }
    return all;
  }

 protected:
  virtual double time_power() const { return 2; }
  virtual double greatest_loss() const = 0;
  bool by_force() const { return request_.end == ContactEnd::force; }
  double stiffness(const VectorXd& u) const { return with_times_ ? std::exp(u[1]) : 1; }
  double mass() const { return request_.mass_eff; }

  FitRequest request_;
  bool with_times_;
};

/// group = β.
class LinearModel : public Base {
 public:
  using Base::Base;
  Prediction predict(const VectorXd& u, double velocity) const override {
    const auto out = collide(law(u), {velocity, mass()}, {request_.end});
    return {out.en, out.tcol};
  }
  std::vector<Parameter> parameters(const VectorXd& u) const override {
    if (with_times_) return calibration::parameters(law(u));
    return {{"damping ratio c/(2 sqrt(m k))", std::exp(u[0]), ""}};
  }

 private:
  double greatest_loss() const override {
    return by_force() ? 20 : -0.02;
  }  // by overlap nothing rebounds from β = 1 on
  Linear law(const VectorXd& u) const {
    const double k = stiffness(u);
    return Linear(k, 2 * std::exp(u[0]) * std::sqrt(mass() * k));
  }
};

/// group = k₂/k₁ − 1.
class HystereticModel : public Base {
 public:
  using Base::Base;
  Prediction predict(const VectorXd& u, double velocity) const override {
    const auto out = collide(law(u), {velocity, mass()});
    return {out.en, out.tcol};
  }
  std::vector<Parameter> parameters(const VectorXd& u) const override {
    if (with_times_) return calibration::parameters(law(u));
    return {{"k1/k2", 1 / (1 + std::exp(u[0])), ""}};
  }

 private:
  double greatest_loss() const override { return 40; }
  Hysteretic law(const VectorXd& u) const {
    const double k = stiffness(u);
    return Hysteretic(k, k * (1 + std::exp(u[0])));
  }
};

/// γ = group v^{s} of a Hertzian spring: T = (m/(k v^{1/2}))^{2/5}, and with the force c ζ^b ζ' γ = c v^b T^{b+1}/m, so
/// that s = b − (b+1)/5: 1/5 for Kuwabara-Kono (b = 1/2), 0 for Tsuji (b = 1/4).
class HertzianModel : public Base {
 public:
  using Base::Base;
  Prediction predict(const VectorXd& u, double velocity) const override {
    const Reduced r = forward_damped(request_.law, request_.end)(u[0] + speed_power() * std::log(velocity));
    return {r.en, r.tcol * std::pow(mass() / (stiffness(u) * std::sqrt(velocity)), 0.4)};
  }
  std::vector<Parameter> parameters(const VectorXd& u) const override {
    const double k = stiffness(u), group = std::exp(u[0]);
    // c = γ m v^{−b} T^{−b−1} at v = 1 m/s.
    const double c = group * mass() * std::pow(k / mass(), 0.4 * (exponent() + 1));
    if (with_times_)
      return is_kuwabara_kono() ? calibration::parameters(KuwabaraKono(k, c)) : calibration::parameters(Tsuji(k, c));
    if (is_kuwabara_kono()) return {{"c k^(-3/5) m^(-2/5)", group, "(s/m)^(1/5)"}};
    return {{"damping ratio c/sqrt(5 m k)", group / std::sqrt(5.0), ""}};
  }

 private:
  double greatest_loss() const override { return by_force() ? 20 : 0.5 * std::log(5.0) - 0.02; }  // γ = √5 β
  bool is_kuwabara_kono() const { return request_.law == LawName::kuwabara_kono; }
  double exponent() const { return is_kuwabara_kono() ? 0.5 : 0.25; }
  double speed_power() const { return exponent() - (exponent() + 1) / 5; }
  double time_power() const override { return 2.5; }
};

/// u = (ln α/(α_max − α), ln c^α k^{1−α}).
class FractionalModel : public Base {
 public:
  using Base::Base;
  Prediction predict(const VectorXd& u, double) const override {
    const double alpha = alpha_at(u);
    const Reduced r = forward_fractional(request_.end)(alpha);
    return {r.en, r.tcol * std::pow(stiffness(u) / mass(), -1 / (2 - alpha))};
  }
  std::vector<Parameter> parameters(const VectorXd& u) const override {
    std::vector<Parameter> all{{"alpha", alpha_at(u), ""}};
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
  Prediction predict(const VectorXd& u, double velocity) const override {
    const double logit = std::min(u[0] + u[1] * std::log(velocity), greatest_logit);
    const double alpha = greatest_alpha(request_.end) * logistic(logit);
    const Reduced r = forward_fractional(request_.end)(alpha);
    if (!with_times_) return {r.en, 0};
    return {r.en, r.tcol * std::exp(-(alpha * u[3] + (1 - alpha) * u[2] - std::log(request_.mass_eff)) / (2 - alpha))};
  }
  std::vector<Parameter> parameters(const VectorXd& u) const override {
    std::vector<Parameter> all{{"a", u[0], ""}, {"b", u[1], ""}};
    if (with_times_) {
      all.push_back({"k", std::exp(u[2]), "kg/s^2"});
      all.push_back({"c", std::exp(u[3]), "kg/s"});
    }
    return all;
  }
  std::vector<VectorXd> starts(double velocity, double tcol) const override {
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

}  // namespace

std::unique_ptr<FitModel> fit_model(const FitRequest& request, bool with_times) {
  switch (request.law) {
    case LawName::linear: return std::make_unique<LinearModel>(request, with_times);
    case LawName::hysteretic: return std::make_unique<HystereticModel>(request, with_times);
    case LawName::kuwabara_kono:
    case LawName::tsuji: return std::make_unique<HertzianModel>(request, with_times);
    case LawName::fractional: break;
  }
  if (request.alpha_of_speed) return std::make_unique<SpeedModel>(request, with_times);
  return std::make_unique<FractionalModel>(request, with_times);
}

}  // namespace ricochet::calibration
