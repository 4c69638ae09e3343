#include "complex_power.hpp"

#include <bit>
#include <cstdint>

namespace ricochet::fractional {

namespace {

// Adding and subtracting it rounds to the nearest integer, which meanwhile stands in the lowest bits.
constexpr double to_integer = 0x1.8p52;

std::uint64_t bits(double x) noexcept { return std::bit_cast<std::uint64_t>(x); }

/// e^x = 2^n (1 + rest) for |x| ≤ 700: x = n ln 2 + r, |r| ≤ ½ ln 2, where the Taylor polynomial of degree 13 errs by
/// 4e-18.
struct Exponential {
  std::uint64_t n;  // modulo 2^12
  double rest;
  double times_power(double y) const noexcept { return std::bit_cast<double>(bits(y) + (n << 52)); }  // 2^n y, y ≠ 0
};

[[gnu::always_inline]] inline Exponential exponential(double x) noexcept {
  constexpr double per_log2 = 1.4426950408889634, log2_high = 0x1.62e42feep-1, log2_low = 0x1.a39ef35793c76p-33;
  const double shifted = x * per_log2 + to_integer, n = shifted - to_integer;
  const double r = (x - n * log2_high) - n * log2_low;
  double p = 1. / 6227020800;
  p = p * r + 1. / 479001600;
  p = p * r + 1. / 39916800;
  p = p * r + 1. / 3628800;
  p = p * r + 1. / 362880;
  p = p * r + 1. / 40320;
  p = p * r + 1. / 5040;
  p = p * r + 1. / 720;
  p = p * r + 1. / 120;
  p = p * r + 1. / 24;
  p = p * r + 1. / 6;
  p = p * r + 0.5;
  return {bits(shifted), r + r * r * p};
}

struct Turn {
  double cosine, sine;
};

/// cos z and sin z for |z| ≤ 1e4, to an absolute error of 2e-16: z = n π/2 + r, |r| ≤ π/4, where the Taylor polynomials
/// of degree 16 and 17 err by 2e-18 and 1e-19.
[[gnu::always_inline]] inline Turn turn_by(double z) noexcept {
  // π/2 in three parts, the first two of 33 bits, so that their products with n are exact.
  constexpr double per_quarter = 0.6366197723675814, high = 0x1.921fb544p+0, middle = 0x1.0b4611a6p-34,
                   low = 0x1.3198a2e037073p-69;
  const double shifted = z * per_quarter + to_integer, n = shifted - to_integer;
  const double r = ((z - n * high) - n * middle) - n * low, r2 = r * r;
  double s = 1. / 355687428096000;
  s = s * r2 - 1. / 1307674368000;
  s = s * r2 + 1. / 6227020800;
  s = s * r2 - 1. / 39916800;
  s = s * r2 + 1. / 362880;
  s = s * r2 - 1. / 5040;
  s = s * r2 + 1. / 120;
  s = s * r2 - 1. / 6;
  s = r + r * r2 * s;
  double c = 1. / 20922789888000;
  c = c * r2 - 1. / 87178291200;
  c = c * r2 + 1. / 479001600;
  c = c * r2 - 1. / 3628800;
  c = c * r2 + 1. / 40320;
  c = c * r2 - 1. / 720;
  c = c * r2 + 1. / 24;
  c = (1 - 0.5 * r2) + r2 * r2 * c;
  // An odd number of quarters exchanges the two; the signs are (n + 1) div 2 and n div 2 halves of a turn.
  const std::uint64_t quarters = bits(shifted), odd = 0 - (quarters & 1);
  const std::uint64_t cosine = (bits(s) & odd) | (bits(c) & ~odd), sine = (bits(c) & odd) | (bits(s) & ~odd);
  return {std::bit_cast<double>(cosine ^ ((quarters + 1) >> 1 << 63)),
          std::bit_cast<double>(sine ^ (quarters >> 1 << 63))};
}

}  // namespace

void complex_powers(std::size_t count, const double* log_size, const double* argument, double exponent,
                    double* __restrict re, double* __restrict im) noexcept {
  for (std::size_t k = 0; k < count; ++k) {
    const Exponential e = exponential(exponent * log_size[k]);
    const double size = e.times_power(1 + e.rest);
    const Turn turn = turn_by(exponent * argument[k]);
    re[k] = size * turn.cosine;
    im[k] = size * turn.sine;
  }
}

void complex_powers_less_one(std::size_t count, const double* log_size, const double* argument, double exponent,
                             double* __restrict re, double* __restrict im) noexcept {
  for (std::size_t k = 0; k < count; ++k) {
    // With |s|^e − 1 = 2^n − 1 + 2^n rest and cos z − 1 = −2 sin² ½z nothing cancels.
    const Exponential e = exponential(exponent * log_size[k]);
    const double power = e.times_power(1), growth = (power - 1) + power * e.rest;
    const Turn half = turn_by(0.5 * (exponent * argument[k]));
    const double turn = -2 * half.sine * half.sine;
    re[k] = growth + turn + growth * turn;
    im[k] = (growth + 1) * (2 * half.sine * half.cosine);
  }
}

}  // namespace ricochet::fractional
