#include "limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::collision {
namespace {

/// The next row of Romberg's table, from its last.
std::vector<double> romberg_row(const std::vector<double>& last, double value) {
  std::vector<double> row{value};
  double power = 1;
  for (const double above : last) {
    power *= 4;
    row.push_back(row.back() + (row.back() - above) / (power - 1));
  }
  return row;
}

/// The next ascending diagonal of the epsilon table, from its last: ε_{k+1} = ε_{k−1} + 1/(ε_k − ε_k'). A difference of
/// 0 means that ε_k has converged: the row ends there.
std::vector<double> wynn_row(const std::vector<double>& last, double value) {
  std::vector<double> row{value};
  for (std::size_t k = 0; k < last.size(); ++k) {
    const double difference = row[k] - last[k];
    if (difference == 0) break;
    row.push_back((k > 0 ? last[k - 1] : 0.0) + 1 / difference);
  }
  return row;
}

}  // namespace

void Limit::judge(double estimate, std::vector<double>& past) {
  past.push_back(estimate);
  const std::size_t n = past.size();
  if (n < 3) return;
  const double moved = std::max(std::abs(past[n - 1] - past[n - 2]), 0.01 * std::abs(past[n - 2] - past[n - 3]));
  if (moved < doubt_) doubt_ = moved, value_ = estimate;
}

void Limit::add(double value) {
  romberg_ = romberg_row(romberg_, value);
  wynn_ = wynn_row(wynn_, value);
  value_ = value;
  doubt_ = std::numeric_limits<double>::infinity();
  judge(romberg_.back(), of_romberg_);
  judge(wynn_[(wynn_.size() - 1) / 2 * 2], of_wynn_);  // odd entries are no estimates
}

double Limit::next() const {
  double value = romberg_.back(), power = std::pow(4.0, static_cast<double>(romberg_.size() - 1));
  for (std::size_t k = romberg_.size() - 1; k > 0; --k, power /= 4)
    value = ((power - 1) * value + romberg_[k - 1]) / power;
  return value;
}

}  // namespace ricochet::collision
