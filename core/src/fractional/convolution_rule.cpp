#include <ricochet/fractional/operators.hpp>
#include <ricochet/support/require.hpp>

#include <cmath>
#include <utility>

namespace ricochet {

ConvolutionRule::ConvolutionRule(std::vector<double> weights, std::vector<double> first, std::vector<double> second)
    : weights_(std::move(weights)), first_(std::move(first)), second_(std::move(second)) {
  const auto fits = [this](const std::vector<double>& v) { return v.empty() || v.size() == weights_.size(); };
  support::require(!weights_.empty(), "weights", 0, "at least one");
  support::require(fits(first_), "first weights", static_cast<double>(first_.size()), "none or one a weight");
  support::require(fits(second_), "second weights", static_cast<double>(second_.size()), "none or one a weight");
  for (const auto* some : {&weights_, &first_, &second_})
    for (const double weight : *some) support::require(std::isfinite(weight), "weight", weight, "finite");
}

void ConvolutionRule::check(std::span<const double> samples) const {
  support::require(!samples.empty() && samples.size() <= size(), "samples", static_cast<double>(samples.size()),
                   "at least one and at most the rule's size");
}

double ConvolutionRule::edge(std::span<const double> samples, std::size_t n) const {
  return (first_.empty() ? 0 : first_[n] * samples[0]) + (second_.empty() || n == 0 ? 0 : second_[n] * samples[1]);
}

double ConvolutionRule::last(std::span<const double> samples) const {
  check(samples);
  const std::size_t n = samples.size() - 1;
  double sum = edge(samples, n);
  for (std::size_t l = 0; l <= n; ++l) sum += weights_[n - l] * samples[l];
  return sum;
}

std::vector<double> ConvolutionRule::all(std::span<const double> samples) const {
  check(samples);
  std::vector<double> y(samples.size());
  for (std::size_t n = 0; n < samples.size(); ++n) y[n] = last(samples.first(n + 1));
  return y;
}

}  // namespace ricochet
