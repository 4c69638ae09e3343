#include "../../core/src/fractional/complex_power.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <random>
#include <vector>

using namespace ricochet::fractional;

namespace {

constexpr std::size_t count = 997;  // not a multiple of any vector's length

struct Logarithms {
  std::vector<double> size, argument;
  Logarithms() {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> sizes(-10, 10), arguments(-3.14159265, 3.14159265);
    for (std::size_t k = 0; k < count; ++k) size.push_back(sizes(random)), argument.push_back(arguments(random));
  }
};

struct Values {
  std::vector<double> re = std::vector<double>(count), im = re;
  std::complex<long double> operator[](std::size_t k) const { return {re[k], im[k]}; }
};

/// s^e − 1 without cancellation, by the identities that long double has functions for.
std::complex<long double> less_one(long double log_size, long double turn) {
  const long double growth = std::expm1(log_size), sine = std::sin(turn / 2);
  return {growth - (1 + growth) * 2 * sine * sine, (1 + growth) * std::sin(turn)};
}

}  // namespace

TEST_CASE("Complex powers keep their bound, and so do powers less one") {
  const Logarithms logs;
  Values power, less;
  for (const double e : {0.0, 1e-12, 1e-3, -0.3, 0.5, 0.97, 1.0, -1.7, 2.0, 3.0, 5.3, -17.0, 64.0, -64.0}) {
    complex_powers(count, logs.size.data(), logs.argument.data(), e, power.re.data(), power.im.data());
    if (std::abs(e) <= 2)
      complex_powers_less_one(count, logs.size.data(), logs.argument.data(), e, less.re.data(), less.im.data());
    long double worst = 0, worst_less = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const long double log_size = static_cast<long double>(e) * logs.size[k],
                        turn = static_cast<long double>(e) * logs.argument[k];
      const auto exact = std::polar(std::exp(log_size), turn);
      const long double rounded = 1.2e-16L * (std::abs(log_size) + std::abs(turn));
      worst = std::max(worst, std::abs(power[k] - exact) / (std::abs(exact) * (5e-16L + rounded)));
      if (e == 0 || std::abs(e) > 2) continue;
      const auto exact_less = less_one(log_size, turn);
      const long double allowed = 1e-15L * std::abs(exact_less) + rounded * std::abs(exact);
      worst_less = std::max(worst_less, std::abs(less[k] - exact_less) / allowed);
    }
    CAPTURE(e, worst, worst_less);
    CHECK(worst < 1);
    CHECK(worst_less < 1);
  }
}
