#include <ricochet/fractional/decay_moments.hpp>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <catch2/catch.hpp>

#include <cmath>
#include <limits>

using namespace ricochet::fractional;

namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;

struct ExactMoments {
  Exact decay, rising, falling, rising_twice, falling_once;
};

/// The closed forms in 100 digits, of which x ≥ 1e-9 cancels at most 27.
ExactMoments exact_moments(const Exact& x) {
  const Exact e = exp(-x), rising = (1 - (1 + x) * e) / (x * x), falling = (x - 1 + e) / (x * x);
  return {e, rising, falling, (2 - (2 + 2 * x + x * x) * e) / (x * x * x), (Exact(0.5) - falling) / x};
}

template <class Real>
double off(Real value, const Exact& exact) {
  return static_cast<double>(abs((Exact(value) - exact) / exact) / std::numeric_limits<Real>::epsilon());
}

template <class Real>
void check_moments() {
  for (Real x = Real(1e-9); x < 500; x *= Real(1.07)) {
    const auto m = decay_moments(x);
    const auto exact = exact_moments(x);
    CAPTURE(x);
    // Of the closed forms' numerators at ½ the header derives 11, 4, 70 and 25 ε; of the series 2 ε.
    const bool series = x < Real(0.5);
    CHECK(off(m.decay, exact.decay) < 1.5 + static_cast<double>(std::fmin(x, Real(1))));
    CHECK(off(m.rising, exact.rising) < (series ? 3 : 11));
    CHECK(off(m.falling, exact.falling) < (series ? 3 : 5));
    CHECK(off(m.rising_twice, exact.rising_twice) < (series ? 3 : 70));
    CHECK(off(m.falling_once, exact.falling_once) < (series ? 3 : 25));
    CHECK(off(decay_mean(x), (1 - exact.decay) / Exact(x)) < 1.5);
  }
}

}  // namespace

TEST_CASE("The moments of a decay are those of the closed forms in 100 digits, to rounding") {
  check_moments<double>();
  check_moments<long double>();
}

TEST_CASE("Without decay the moments are those of the polynomials") {
  const auto m = decay_moments(0.0);
  CHECK(m.decay == 1);
  CHECK(m.rising == 0.5);
  CHECK(m.falling == 0.5);
  CHECK(std::abs(m.rising_twice - 1.0 / 3) < 1e-16);
  CHECK(std::abs(m.falling_once - 1.0 / 6) < 1e-16);
  CHECK(decay_mean(0.0) == 1);
}
