#pragma once

// Header only; needs the standard library alone.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <numeric>
#include <ostream>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ricochet::verify {

/// What a scheme is said to do: error ~ C h^stated. Judged from both sides, because a scheme that beats its stated
/// order is mislabelled.
struct OrderClaim {
  double stated = 0;        ///< > 0, must be given
  double allowed = 0.1;     ///< > 0: of |observed − stated|
  double rounding = 1e-10;  ///< ≥ 0: greatest error that rounding may make. @@
};

/// Order between two meshes, log(e₁/e₂)/log(h₁/h₂); NaN where an error is not a number > 0.
inline double pairwise_order(double h1, double e1, double h2, double e2) {
  const bool usable = e1 > 0 && e2 > 0 && std::isfinite(e1) && std::isfinite(e2);
  return usable ? std::log(e1 / e2) / std::log(h1 / h2) : std::numeric_limits<double>::quiet_NaN();
}

/// What the errors on a sequence of meshes show.
struct ObservedOrder {
  enum class Verdict { confirmed, lower, higher, undecided };

  std::vector<double> h, error;                             ///< coarsest first
  std::vector<double> pairwise;                             ///< [i]: between meshes i − 1 and i; [0] is NaN
  double order = std::numeric_limits<double>::quiet_NaN();  ///< slope of log error over log h, least squares in range
  /// The greater of the slope's standard error and half the distance of the range's extreme pairwise orders.
  double uncertainty = std::numeric_limits<double>::quiet_NaN();
  std::size_t first = 0, last = 0;  ///< the range: meshes first … last − 1
  double floor = 0;                 ///< where the errors stop falling; 0: not seen
  Verdict verdict = Verdict::undecided;
  std::string said = {};  ///< the verdict, and what was left out, in words

  /// The order is the stated one: for `CHECK(observe_order(…))` and `EXPECT_TRUE(observe_order(…))`.
  explicit operator bool() const { return verdict == Verdict::confirmed; }
};

inline std::ostream& operator<<(std::ostream& out, const ObservedOrder& observed) { return out << observed.said; }

namespace order {

struct Line {
  double slope = 0, squares = 0, slope_error = 0;  ///< squares: sum of squared residuals
};

/// Least squares of y over x in [first, last).
inline Line fitted_line(std::span<const double> x, std::span<const double> y, std::size_t first, std::size_t last) {
  Line line;
  const auto n = static_cast<double>(last - first);
  double mx = 0, my = 0, sxx = 0, sxy = 0;
  for (std::size_t i = first; i < last; ++i) mx += x[i] / n, my += y[i] / n;
  for (std::size_t i = first; i < last; ++i) sxx += (x[i] - mx) * (x[i] - mx), sxy += (x[i] - mx) * (y[i] - my);
  if (last - first < 2) return line;
  line.slope = sxy / sxx;
  for (std::size_t i = first; i < last; ++i) {
    const double miss = y[i] - my - line.slope * (x[i] - mx);
    line.squares += miss * miss;
  }
  if (last - first > 2) line.slope_error = std::sqrt(line.squares / (n - 2) / sxx);
  return line;
}

/// Where errors small enough to be rounding no longer fall evenly: the first mesh whose pairwise order is farther
/// than 1/2 from the one before (at first, from the stated one). Returns the greatest error from there on, 0 if there
/// is none.
inline double floor_of(const ObservedOrder& o, const OrderClaim& claim) {
  double before = claim.stated;
  for (std::size_t i = 1; i < o.error.size(); ++i) {
    const bool even = std::fabs(o.pairwise[i] - before) <= 0.5;  // false for a NaN
    if (!even && o.error[i] <= claim.rounding)
      return *std::max_element(o.error.begin() + static_cast<std::ptrdiff_t>(i), o.error.end());
    before = o.pairwise[i];
  }
  return 0;
}

inline std::string text(double value) {
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(3);
  out << value;
  return out.str();
}

/// Meshes from the coarsest on whose error stands far enough above the floor: twenty times, so that rounding moves a
/// pairwise order of halved meshes by no more than 0.07.
inline std::size_t usable_meshes(const ObservedOrder& o) {
  std::size_t m = 0;
  while (m < o.error.size() && o.error[m] > 0 && o.error[m] >= 20 * o.floor) ++m;
  return m;
}

/// Extends the range from the three finest usable meshes to coarser ones as long as their pairwise order lies within
/// `allowed` of the range's mean; fits there.
inline void fit_range(ObservedOrder& o, std::span<const double> x, std::span<const double> y, double allowed) {
  const auto mean = [&o] {
    return std::accumulate(o.pairwise.begin() + static_cast<std::ptrdiff_t>(o.first) + 1,
                           o.pairwise.begin() + static_cast<std::ptrdiff_t>(o.last), 0.0) /
           static_cast<double>(o.last - o.first - 1);
  };
  o.first = o.last - 3;
  while (o.first > 0 && std::fabs(o.pairwise[o.first] - mean()) <= allowed) --o.first;
  const auto begin = o.pairwise.begin();
  const auto [low, high] = std::minmax_element(begin + static_cast<std::ptrdiff_t>(o.first) + 1,
                                               begin + static_cast<std::ptrdiff_t>(o.last));
  const Line line = fitted_line(x, y, o.first, o.last);
  o.order = line.slope;
  o.uncertainty = std::max(line.slope_error, (*high - *low) / 2);
}

inline void judge(ObservedOrder& o, const OrderClaim& claim) {
  using Verdict = ObservedOrder::Verdict;
  const std::string observed = "order " + text(o.order) + " +- " + text(o.uncertainty) + ", stated " +
                               text(claim.stated) + " +- " + text(claim.allowed);
  if (o.order < claim.stated - claim.allowed)
    o.verdict = Verdict::lower, o.said = "lower than stated: " + observed;
  else if (o.order > claim.stated + claim.allowed)
    o.verdict = Verdict::higher, o.said = "higher than stated: " + observed;
  else if (o.uncertainty > claim.allowed)
    o.verdict = Verdict::undecided, o.said = "undecided, the pairwise orders have not settled: " + observed;
  else
    o.verdict = Verdict::confirmed, o.said = "confirmed: " + observed;
  if (o.first > 0) o.said += "; pre-asymptotic above h = " + text(o.h[o.first]);
  if (o.last < o.h.size() && o.floor > 0) o.said += "; errors below h = " + text(o.h[o.last - 1]) + " near the floor";
}

inline void require(bool holds, const std::string& message) {
  if (!holds) throw std::invalid_argument(message);
}

inline void require_claim(const OrderClaim& claim) {
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  require(positive(claim.stated), "stated = " + text(claim.stated) + ": must be a finite number > 0");
  require(positive(claim.allowed), "allowed = " + text(claim.allowed) + ": must be a finite number > 0");
  require(std::isfinite(claim.rounding) && claim.rounding >= 0,
          "rounding = " + text(claim.rounding) + ": must be a finite number >= 0");
}

/// The meshes, coarsest first, with what belongs to them.
inline std::vector<std::pair<double, double>> sorted_meshes(std::span<const double> h, std::span<const double> y) {
  require(h.size() == y.size(), "meshes = " + std::to_string(h.size()) + ": must be as many as errors or values, " +
                                    std::to_string(y.size()));
  require(h.size() >= 3, "meshes = " + std::to_string(h.size()) + ": must be at least 3");
  std::vector<std::pair<double, double>> meshes;
  for (std::size_t i = 0; i < h.size(); ++i) {
    require(std::isfinite(h[i]) && h[i] > 0, "h = " + text(h[i]) + ": must be a finite number > 0");
    require(std::isfinite(y[i]), "error or value at h = " + text(h[i]) + ": must be a finite number");
    meshes.emplace_back(h[i], y[i]);
  }
  std::sort(meshes.begin(), meshes.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  for (std::size_t i = 1; i < meshes.size(); ++i)
    require(meshes[i].first < meshes[i - 1].first, "h = " + text(meshes[i].first) + ": must stand once");
  return meshes;
}

}  // namespace order

/// The order that errors on three meshes or more show, in any order and with any refinement ratios.
///
/// Left out are, on the fine side, meshes whose error is less than twenty times the floor of rounding: errors below
/// `claim.rounding` count only as long as they fall evenly, so that the pairwise orders differ by at most 1/2 from one
/// to the next; and, on the coarse side, meshes whose pairwise order is farther than `claim.allowed` from those of the
/// finer ones: they are not yet asymptotic. What is left, three meshes at least, is fitted. lower, higher: the fitted
/// order lies outside stated ± allowed; undecided: it lies inside, but its uncertainty is greater than `allowed`, or
/// fewer than three meshes are left; else confirmed.
///
/// Throws std::invalid_argument for fewer than three meshes, h not finite and > 0 or given twice, errors that are not
/// finite, and a claim outside its domain. Errors may carry a sign, which is dropped.
inline ObservedOrder observe_order(std::span<const double> h, std::span<const double> error, const OrderClaim& claim) {
  order::require_claim(claim);
  ObservedOrder o;
  std::vector<double> x;
  for (const auto& [step, e] : order::sorted_meshes(h, error)) {
    o.h.push_back(step), o.error.push_back(std::fabs(e)), x.push_back(std::log(step));
    const std::size_t i = o.h.size() - 1;
    o.pairwise.push_back(i == 0 ? std::numeric_limits<double>::quiet_NaN()
                                : pairwise_order(o.h[i - 1], o.error[i - 1], o.h[i], o.error[i]));
  }
  const double level = order::floor_of(o, claim);
  if (level <= claim.rounding) o.floor = level;
  o.last = order::usable_meshes(o);
  if (o.last < 3) {
    o.said = "undecided: only " + std::to_string(o.last) + " of " + std::to_string(o.h.size()) +
             " meshes have an error above " + (o.floor > 0 ? "the floor of rounding, " + order::text(o.floor) : "zero");
    return o;
  }
  std::vector<double> y;
  for (std::size_t i = 0; i < o.last; ++i) y.push_back(std::log(o.error[i]));
  order::fit_range(o, x, y, claim.allowed);
  order::judge(o, claim);
  return o;
}

/// The same of a function that gives the error for an h.
template <class Error>
requires requires(Error error, double h) { double(error(h)); }
ObservedOrder observe_order(const Error& error, std::span<const double> h, const OrderClaim& claim) {
  std::vector<double> errors;
  for (const double step : h) errors.push_back(error(step));
  return observe_order(h, errors, claim);
}

/// `coarsest`, and `meshes` − 1 more, each h the `ratio`-th part of the one before.
inline std::vector<double> refined(double coarsest, std::size_t meshes, double ratio = 2) {
  std::vector<double> h;
  for (std::size_t i = 0; i < meshes; ++i) h.push_back(coarsest / std::pow(ratio, static_cast<double>(i)));
  return h;
}

/// The order that values show, measured against the value on the finest mesh. That has an error too, which would
/// raise the order: meshes whose error is by the stated order less than fifty times as great are left out (it moves a
/// pairwise order of halved meshes by no more than 0.03). Throws as above; also where fewer than three meshes are
/// left.
inline ObservedOrder observe_order_by_finest(std::span<const double> h, std::span<const double> value,
                                             const OrderClaim& claim) {
  order::require_claim(claim);
  const auto meshes = order::sorted_meshes(h, value);
  const auto [finest, reference] = meshes.back();
  std::vector<double> kept, errors;
  for (const auto& [step, v] : meshes)
    if (std::pow(finest / step, claim.stated) <= 1.0 / 50) kept.push_back(step), errors.push_back(v - reference);
  order::require(kept.size() >= 3, "meshes = " + std::to_string(kept.size()) +
                                       ": must be at least 3 that are by the stated order fifty times less accurate "
                                       "than the finest, which is the reference");
  return observe_order(kept, errors, claim);
}

/// The order that values show, measured against their limit, which Richardson's extrapolation of the two finest meshes
/// gives with the observed order (found by iteration, so that the stated one does not colour what is observed). The
/// finest mesh is used up by it; four meshes or more. Throws as above. undecided where the iteration does not settle.
inline ObservedOrder observe_order_by_richardson(std::span<const double> h, std::span<const double> value,
                                                 const OrderClaim& claim) {
  order::require_claim(claim);
  const auto meshes = order::sorted_meshes(h, value);
  const std::size_t n = meshes.size();
  order::require(n >= 4, "meshes = " + std::to_string(n) + ": must be at least 4 for Richardson's extrapolation");
  const auto [h2, v2] = meshes[n - 1];
  const auto [h1, v1] = meshes[n - 2];
  double order = claim.stated;
  for (int i = 0; i < 100; ++i) {
    const double limit = v2 + (v2 - v1) / (std::pow(h1 / h2, order) - 1);
    std::vector<double> kept, errors;
    for (std::size_t m = 0; m + 1 < n; ++m) kept.push_back(meshes[m].first), errors.push_back(meshes[m].second - limit);
    ObservedOrder o = observe_order(kept, errors, claim);
    if (!(o.order > 0.05) || std::fabs(o.order - order) < 1e-9) return o;
    order = o.order;
  }
  ObservedOrder o;
  o.said = "undecided: the extrapolation does not settle";
  return o;
}

}  // namespace ricochet::verify
