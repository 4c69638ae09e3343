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

/// What an extrapolation makes of an error of 1 in each of its two values.
double raised(double coarse, double fine) { return (coarse + fine) / (coarse - fine); }

/// ρ, what smooth extrapolations fall by from one step to a finer one.
double fall(double coarse, double fine) { return std::pow(falls, std::log2(coarse / fine)); }

std::vector<double> differences(const std::vector<double>& of) {
  std::vector<double> all;
  for (std::size_t i = 1; i < of.size(); ++i) all.push_back(std::abs(of[i] - of[i - 1]));
  return all;
}

/// The greater of the last two differences of neighbours where these do not fall, else 0.
double wandering(const std::vector<double>& h, const std::vector<double>& values, double floor) {
  const std::vector<double> gaps = differences(values);
  double fine = 0, coarse = 0, last = 0;
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const double rate = gaps[i] / h[i];
    if (i + 2 < gaps.size())
      coarse = std::max(coarse, rate);
    else if (gaps[i] > floor)
      fine = std::max(fine, rate), last = std::max(last, gaps[i]);
  }
  return fine > most_growth * coarse ? last : 0;
}

/// How far off the finest value is if the last two orders that its neighbours' changes show are both below 1, by the
/// lower of them; else 0.
double slow_tail(const std::vector<double>& h, const std::vector<double>& values) {
  const std::vector<double> gaps = differences(values);
  const std::size_t last = gaps.size() - 1;
  double order = 1;
  for (const std::size_t i : {last - 1, last}) {
    const double shown = std::log(gaps[i - 1] / gaps[i]) / std::log(h[i] / h[i + 1]);
    if (!(shown < 1)) return 0;
    order = std::min(order, std::max(shown, 1.0 / 3));
  }
  const double left = std::pow(h[last + 1] / h[last], order);
  return gaps[last] * left / (1 - left);
}

}  // namespace

Limit limit_of(const std::vector<double>& h, const std::vector<double>& values, double floor, double digits) {
  const std::vector<double> limits = extrapolations(h, values), gaps = differences(limits);
  const double wanders = wandering(h, values, floor);
  Limit limit{.value = values.back(), .uncertainty = spread * wanders, .settles = wanders == 0};
  if (!limit.settles) return limit;
  const std::size_t last = gaps.size() - 1, first = last < 2 ? 0 : last - 2;
  limit.smooth = true;
  double envelope = gaps[first];
  for (std::size_t i = first + 1; i <= last; ++i) {
    const double noise = (raised(h[i], h[i + 1]) + raised(h[i + 1], h[i + 2])) * digits;
    const double rho = fall(h[i + 1], h[i + 2]);
    limit.smooth = limit.smooth && (gaps[i] <= rho * gaps[i - 1] || gaps[i] <= std::max(floor, noise));
    envelope = std::max(gaps[i], rho * envelope);
  }
  if (limit.smooth) {
    const double rho = fall(h[last + 1], h[last + 2]);
    const double closer = std::max(1.0, rho / (1 - rho) * (1 - falls) / falls);
    limit.value = limits.back();
    limit.uncertainty = spread * closer * envelope + raised(h[last + 1], h[last + 2]) * digits;
    return limit;
  }
  for (std::size_t i = 0; i + 1 < h.size(); ++i)
    limit.uncertainty = std::max(limit.uncertainty, spread * h.back() * std::abs(values[i] - values.back()) / h[i]);
  limit.uncertainty = std::max(limit.uncertainty, spread * slow_tail(h, values));
  return limit;
}

}  // namespace ricochet::verify::conformance
