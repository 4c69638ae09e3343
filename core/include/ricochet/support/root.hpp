#pragma once

#include <ricochet/support/require.hpp>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace ricochet::support {

/// When a bracket is narrow enough.
struct RootTolerance {
  /// Largest width of the last bracket, relative to its end nearer to 0. With 0 the ends become neighbouring doubles.
  double relative = 4 * std::numeric_limits<double>::epsilon();
  std::uintmax_t evaluations = 200;  ///< of f at most, after which the bracket is as wide as it then is
};

/// The last bracket {low', high'} around a root of f in [low, high], low < high, given at_low = f(low) and
/// at_high = f(high). f is continuous there and the two values have opposite signs; it is evaluated inside the bracket
/// only, so either may be a finite limit that f itself cannot be asked for. A value 0 is the root: both ends are then
/// the same. Throws std::invalid_argument if the signs are equal or one value is NaN.
///
/// Algorithm 748 (Alefeld, Potra & Shi, ACM Trans. Math. Softw. 21, 1995, 327) as Boost.Math has it: of order 1.6 an
/// evaluation at a simple root, some ten evaluations; at worst about three times bisection's.
template <class F>
std::pair<double, double> root_bracket(const F& f, double low, double high, double at_low, double at_high,
                                       RootTolerance tolerance = {}) {
  if (at_low == 0) return {low, low};
  if (at_high == 0) return {high, high};
  require((at_low < 0 && at_high > 0) || (at_low > 0 && at_high < 0), "f(high)", at_high,
          "of the other sign than f(low)");
  const auto narrow = [=](double a, double b) {
    return tolerance.relative > 0 ? std::abs(b - a) <= tolerance.relative * std::fmin(std::abs(a), std::abs(b))
                                  : std::nextafter(a, b) >= b;
  };
#ifdef __clang_analyzer__  // which loses sight of what Boost's steps assign before they read it
  return narrow(low, high) || f(low) > 0 ? std::pair{low, low} : std::pair{low, high};
#else
  std::uintmax_t evaluations = tolerance.evaluations;
  return boost::math::tools::toms748_solve(f, low, high, at_low, at_high, narrow, evaluations);
#endif
}

/// The root: the middle of that bracket. By default it is right to the last two bits that f resolves.
template <class F>
double root(const F& f, double low, double high, double at_low, double at_high, RootTolerance tolerance = {}) {
  const auto [left, right] = root_bracket(f, low, high, at_low, at_high, tolerance);
  return 0.5 * (left + right);
}

template <class F>
double root(const F& f, double low, double high, RootTolerance tolerance = {}) {
  return root(f, low, high, f(low), f(high), tolerance);
}

}  // namespace ricochet::support
