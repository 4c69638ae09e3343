#include "approach.hpp"

#include <ricochet/support/root.hpp>

#include "power_series.hpp"

#include <cmath>
#include <span>

namespace ricochet::collision {
namespace {

constexpr int terms = 40;

double polynomial(std::span<const double> coefficients, double z) {
  double sum = 0;
  for (std::size_t j = coefficients.size(); j-- > 0;) sum = sum * z + coefficients[j];
  return sum;
}

/// Γ(x)/Γ(x−α): what D^α makes of t^{x−1}.
double gamma_quotient(double x, double alpha) { return std::exp(std::lgamma(x) - std::lgamma(x - alpha)); }

}  // namespace

SphereApproach::SphereApproach(double alpha) : alpha_(alpha), p_(2.5 - alpha), overlap_{1} {
  std::vector<double> power{1};
  for (int j = 0; j < terms; ++j) {
    const double at = p_ * j, next = p_ * (j + 1);
    rate_.push_back((1 + at) * overlap_.back());
    power_rate_.push_back((1.5 + at) * power.back());
    force_.push_back(power.back() * gamma_quotient(2.5 + at, alpha));
    derivative_.push_back(overlap_.back() * gamma_quotient(2 + at, alpha));
    overlap_.push_back(-force_.back() / ((1 + next) * next));
    power.push_back(next_of_power<double>(overlap_, power, 1.5));
  }
  overlap_.pop_back();
  double after = 1;
  while (rate(after) > 0) after += 0.25;
  turn_ = support::root([this](double t) { return rate(t); }, after - 0.25, after);
}

double SphereApproach::overlap(double t) const { return t * polynomial(overlap_, std::pow(t, p_)); }

double SphereApproach::rate(double t) const { return polynomial(rate_, std::pow(t, p_)); }

double SphereApproach::reduced_power_rate(double t) const { return polynomial(power_rate_, std::pow(t, p_)); }

double SphereApproach::turning_force() const {
  return std::pow(turn_, 1.5 - alpha_) * polynomial(force_, std::pow(turn_, p_));
}
double SphereApproach::turning_derivative() const {
  return std::pow(turn_, 1 - alpha_) * polynomial(derivative_, std::pow(turn_, p_));
}

}  // namespace ricochet::collision
