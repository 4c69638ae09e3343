#include "stretch.hpp"

#include <ricochet/support/root.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

namespace ricochet::collision {
namespace {

/// Lagrange's polynomial through values at 0, 1, 2, …
template <class Value>
double lagrange(std::span<const Instant> points, Value value, double at) {
  double sum = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    double term = value(points[i]);
    for (std::size_t j = 0; j < points.size(); ++j)
      if (j != i) term *= (at - static_cast<double>(j)) / (static_cast<double>(i) - static_cast<double>(j));
    sum += term;
  }
  return sum;
}

}  // namespace

double Stretch::from_graded_end(int n, double length) const noexcept {
  const double share = static_cast<double>(graded_ == Graded::at_start ? n : steps_ - n) / steps_;
  const double square = share * share;
  static_assert(grading == 4);
  return graded_ == Graded::at_start ? length * square * square : -length * square * square;
}

Instant Stretch::run(double length) {
  contact_.back();
  path_.assign(1, start_);
  const double graded_end = start_.time + (graded_ == Graded::at_start ? 0 : length);
  double now = from_graded_end(0, length);
  for (int n = 1; n <= steps_; ++n) {
    const double then = from_graded_end(n, length);
    Instant next = contact_.step(path_.back(), then - now);
    contact_.accept();
    next.time = graded_end + then;
    path_.push_back(next);
    now = then;
  }
  return path_.back();
}

std::optional<Instant> Stretch::run_to(const std::function<double(const Instant&)>& event, double guess, double doubt,
                                       std::size_t budget) {
  const auto spent = [&] { return contact_.evaluations() >= budget; };
  double last = 0, best = 0, least = std::numeric_limits<double>::infinity();
  const auto value = [&](double length) {
    if (spent()) return 0.0;  // ends the search, whose result is then not used
    const double at_end = event(run(length));
    last = length;
    if (at_end != 0 && std::abs(at_end) < least) least = std::abs(at_end), best = length;
    // A force that stays 0 past its end counts as fallen below.
    return at_end == 0 ? -1e-300 : at_end;
  };
  double low = guess, high = guess, at_low = value(guess), at_high = at_low;
  for (double reach = doubt; at_low <= 0 && low > 0.25 * guess && !spent(); reach *= 4)
    high = low, at_high = at_low, low = std::max(0.2 * guess, low - reach), at_low = value(low);
  for (double reach = doubt; at_high > 0 && high < 4 * guess && !spent(); reach *= 4)
    low = high, at_low = at_high, high += reach, at_high = value(high);
  if (!(at_low > 0 && at_high <= 0)) return std::nullopt;
  support::root_bracket(value, low, high, at_low, at_high, {.relative = 1e-15, .evaluations = 60});
  if (spent()) return std::nullopt;
  return last == best ? path_.back() : run(best);
}

Instant Stretch::peak_force() const {
  constexpr std::ptrdiff_t most = 9;
  const auto top = std::max_element(path_.begin(), path_.end(),
                                    [](const Instant& a, const Instant& b) { return a.force < b.force; });
  const std::ptrdiff_t size = std::ssize(path_), at = top - path_.begin(), count = std::min(most, size);
  const std::ptrdiff_t first = std::clamp<std::ptrdiff_t>(at - count / 2, 0, size - count);
  const std::span<const Instant> points(&path_[static_cast<std::size_t>(first)], static_cast<std::size_t>(count));
  const auto force = [&](double n) {
    return lagrange(
        points, [](const Instant& p) { return p.force; }, n);
  };
  const double middle = static_cast<double>(at - first);
  const double low = std::max(0.0, middle - 1), high = std::min(static_cast<double>(count - 1), middle + 1);
  const auto [n, negative] =
      boost::math::tools::brent_find_minima([&](double where) { return -force(where); }, low, high, 40);
  if (!(-negative > top->force)) return *top;
  Instant peak = *top;
  peak.force = -negative;
  peak.time = lagrange(
      points, [](const Instant& p) { return p.time; }, n);
  return peak;
}

}  // namespace ricochet::collision
