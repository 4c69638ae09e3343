#include <ricochet/support/require.hpp>
#include <ricochet/fractional/operators.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace ricochet {

namespace {

using Complex = std::complex<double>;

/// In-place transform of power-of-two length, forward with roots e^{−2πik/n}; roots are tabulated, not accumulated.
void transform(std::vector<Complex>& x, const std::vector<Complex>& roots) {
  const std::size_t n = x.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1;
    for (; j & bit; bit >>= 1) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(x[i], x[j]);
  }
  for (std::size_t length = 2; length <= n; length *= 2)
    for (std::size_t start = 0; start < n; start += length)
      for (std::size_t k = 0; k < length / 2; ++k) {
        const Complex even = x[start + k], odd = roots[k * (n / length)] * x[start + k + length / 2];
        x[start + k] = even + odd;
        x[start + k + length / 2] = even - odd;
      }
}

}  // namespace

ConvolutionRule::ConvolutionRule(std::vector<double> weights, std::vector<double> first, std::vector<double> second)
    : weights_(std::move(weights)), first_(std::move(first)), second_(std::move(second)) {
  const auto fits = [this](const std::vector<double>& v) { return v.empty() || v.size() == weights_.size(); };
  support::require(!weights_.empty(), "weights", 0, "at least one");
  support::require(fits(first_), "first weights", static_cast<double>(first_.size()), "none or one a weight");
  support::require(fits(second_), "second weights", static_cast<double>(second_.size()), "none or one a weight");
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

std::vector<double> ConvolutionRule::all_fast(std::span<const double> samples) const {
  check(samples);
  std::size_t length = 1;
  while (length < 2 * samples.size()) length *= 2;
  std::vector<Complex> roots(std::max<std::size_t>(1, length / 2));
  for (std::size_t k = 0; k < roots.size(); ++k)
    roots[k] = std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(length));
  // Two transforms in one would save a third and mix the rounding of weights and samples, whose sizes differ much.
  std::vector<Complex> x(length), w(length);
  for (std::size_t l = 0; l < samples.size(); ++l) x[l] = samples[l], w[l] = weights_[l];
  transform(x, roots);
  transform(w, roots);
  for (std::size_t k = 0; k < length; ++k) x[k] = std::conj(x[k] * w[k]);  // the inverse by conjugation
  transform(x, roots);
  std::vector<double> y(samples.size());
  for (std::size_t n = 0; n < y.size(); ++n) y[n] = x[n].real() / static_cast<double>(length) + edge(samples, n);
  return y;
}

}  // namespace ricochet
