#include "grade.hpp"

#include <algorithm>
#include <cmath>

namespace ricochet::verify::conformance {

namespace {

constexpr double falls = 0.35, most_growth = 2.5, spread = 2;

/// Richardson's, of neighbours, by first order.
std::vector<double> extrapolations(const std::vector<double>& h, const std::vector<double>& d) {
  std::vector<double> all;
  for (std::size_t i = 1; i < h.size(); ++i) all.push_back((h[i - 1] * d[i] - h[i] * d[i - 1]) / (h[i - 1] - h[i]));
  return all;
}

std::vector<double> differences(const std::vector<double>& of) {
  std::vector<double> all;
  for (std::size_t i = 1; i < of.size(); ++i) all.push_back(std::abs(of[i] - of[i - 1]));
  return all;
}

/// The greater of the last two differences of neighbours where these do not fall, else 0.
double wandering(const std::vector<double>& h, const std::vector<double>& values, double noise) {
  const std::vector<double> gaps = differences(values);
  double fine = 0, coarse = 0, last = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const double rate = gaps[i] / h[i];
    if (i + 2 < gaps.size())
      coarse = std::max(coarse, rate);
    else if (gaps[i] > noise)
      fine = std::max(fine, rate), last = std::max(last, gaps[i]);
  }
  return fine > most_growth * coarse ? last : 0;
}

}  // namespace

Limit limit_of(const std::vector<double>& h, const std::vector<double>& values, double noise) {
  const std::vector<double> limits = extrapolations(h, values), falling = differences(limits);
  const double wanders = wandering(h, values, noise);
  Limit limit{.value = values.back(), .uncertainty = spread * wanders, .settles = wanders == 0};
  if (!limit.settles) return limit;
  const std::size_t last = falling.size() - 1;
  limit.smooth = true;
  for (std::size_t i = last; i + 2 > last && i > 0; --i)
    limit.smooth = limit.smooth && (falling[i] <= falls * falling[i - 1] || falling[i] <= noise);
  if (limit.smooth) return limit.value = limits.back(), limit.uncertainty = spread * falling[last], limit;
  for (std::size_t i = 0; i + 1 < h.size(); ++i)
    limit.uncertainty = std::max(limit.uncertainty, spread * h.back() * std::abs(values[i] - values.back()) / h[i]);
  return limit;
}

}  // namespace ricochet::verify::conformance
