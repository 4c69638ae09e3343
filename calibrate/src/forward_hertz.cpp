#include "forward_hertz.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::calibration {
namespace {

Reduced collided(double alpha, double log_group) {
  const auto out = collide(FractionalHertz(1, std::exp(log_group), alpha), {1, 1});
  return {out.en, out.tcol};
}

/// The N Chebyshev points on [−1, 1], and what each weighs in the barycentric formula.
template <std::size_t N>
struct Points {
  std::array<double, N> at, weight;
  Points() {
    for (std::size_t j = 0; j < N; ++j) {
      const double angle = std::numbers::pi * (static_cast<double>(j) + 0.5) / N;
      at[j] = std::cos(angle);
      weight[j] = (j % 2 == 0 ? 1 : -1) * std::sin(angle);
    }
  }
  static const Points& all() {
    static const Points points;
    return points;
  }
};

template <std::size_t N>
double abscissa(std::size_t j, double from, double to) {
  return 0.5 * (from + to) + 0.5 * (to - from) * Points<N>::all().at[j];
}

/// What the values at the points of [from, to] have of the polynomial's at x.
template <std::size_t N>
std::array<double, N> shares(double x, double from, double to) {
  const Points<N>& points = Points<N>::all();
  const double place = (2 * x - from - to) / (to - from);
  std::array<double, N> share{};
  double sum = 0;
  for (std::size_t j = 0; j < N; ++j) {
    if (place == points.at[j]) {
      share.fill(0);
      share[j] = 1;
      return share;
    }
    share[j] = points.weight[j] / (place - points.at[j]);
    sum += share[j];
  }
  for (double& s : share) s /= sum;
  return share;
}

}  // namespace

const ForwardHertz::Cell& ForwardHertz::cell(std::size_t column, std::size_t row) const {
  Place& place = cells_[column][row];
  std::call_once(place.made, [&] {
    auto made = std::make_unique<Cell>();
    const double from = low + static_cast<double>(row) * width;
    for (std::size_t i = 0; i < across; ++i)
      for (std::size_t j = 0; j < along; ++j) {
        const double root = abscissa<across>(i, roots[column], roots[column + 1]);
        const Reduced r = collided(root * root * root, abscissa<along>(j, from, from + width));
        made->en[i][j] = r.en;
        made->log_tcol[i][j] = std::log(r.tcol);
      }
    place.cell = std::move(made);
  });
  return *place.cell;
}

Reduced ForwardHertz::operator()(double alpha, double log_group) const {
  const double root = std::cbrt(alpha), place = (log_group - low) / width;
  const auto most = static_cast<double>(root > dashpot_like ? few : count);
  if (!(root >= roots.front() && root < roots.back() && place >= 0 && place < most)) return collided(alpha, log_group);
  const auto column = static_cast<std::size_t>(std::upper_bound(roots.begin(), roots.end(), root) - roots.begin()) - 1;
  const auto row = static_cast<std::size_t>(place);
  const double from = low + static_cast<double>(row) * width;
  const auto by_root = shares<across>(root, roots[column], roots[column + 1]);
  const auto by_group = shares<along>(log_group, from, from + width);
  const Cell& values = cell(column, row);
  double en = 0, log_tcol = 0;
  for (std::size_t i = 0; i < across; ++i)
    for (std::size_t j = 0; j < along; ++j) {
      const double share = by_root[i] * by_group[j];
      en += share * values.en[i][j];
      log_tcol += share * values.log_tcol[i][j];
    }
  return {en, std::exp(log_tcol)};
}

}  // namespace ricochet::calibration
