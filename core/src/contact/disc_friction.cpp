#include "disc_resistance.hpp"

#include <ricochet/contact/friction.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ricochet {

using contact::DiscCurve;

namespace {

struct Elliptic {
  double k, e;
};

// K and E of modulus 0 ≤ k < 1 together by Gauss's arithmetic-geometric mean: K = π/(2 agm(1, k')),
// E = K (1 − Σ 2^{n−1} c_n²), c_0 = k. By hand because one mean gives both: 50 ns, where Boost's R_F and R_G take 210
// and GSL's Carlson forms 700, with which a contact-step that slides and spins cost a quarter and three quarters more.
Elliptic elliptic(double modulus) noexcept {
  double a = 1, b = std::sqrt((1 - modulus) * (1 + modulus)), sum = 0.5 * modulus * modulus, weight = 1;
  for (int n = 0; n < 8 && a - b > 1e-8 * a; ++n, weight *= 2) {
    const double c = 0.5 * (a - b), mean = 0.5 * (a + b);
    sum += weight * c * c;
    b = std::sqrt(a * b), a = mean;
  }
  const double k = std::numbers::pi / (a + b);  // one more mean, whose c² is below rounding
  return {k, k * (1 - sum)};
}

// Terms of the series about λ = 0 and λ = ∞, which serve for λ² ≤ 1/4 and λ⁻² ≤ 1/4: there the closed forms would lose
// F to cancellation as λ → 0 and both as λ → ∞, and a polynomial saves the mean's square roots. 4^{-40} is far below
// rounding.
constexpr std::size_t terms = 40;
using Series = std::array<double, terms>;

// Coefficients of the four series, from K(k) = (π/2) Σ k_n k^{2n}, E(k) = (π/2) Σ e_n k^{2n} with
// k_n = ((2n−1)!!/(2n)!!)² and e_n = −k_n/(2n−1):
//   F = λ Σ small_n λ^{2n}                     small_n = (2/3)(e_{n+1} + e_n + k_n − k_{n+1})
//   𝒯 = Σ turn_n λ^{2n}                        turn_n = (2/9)(4e_n − 2e_{n−1} + k_{n−1} − k_n), e_{−1} = k_{−1} = 0
//   F = Σ large_n λ^{−2n}                      large_n = (2/3)(e_{n+1} − k_{n+1} + e_n + k_n)
//   𝒯 = λ⁻¹ Σ torque_n λ^{−2n}                 torque_{n−1} = (2/9)(4e_n − 5k_n + 3k_{n−1} + 2(k_{n+1} − e_{n+1}))
struct Coefficients {
  Series small{}, turn{}, large{}, torque{};

  constexpr Coefficients() {
    constexpr std::size_t known = terms + 2;
    std::array<double, known> k{}, e{};
    k[0] = e[0] = 1;
    for (std::size_t n = 1; n < k.size(); ++n) {
      const double ratio = (2.0 * double(n) - 1) / (2.0 * double(n));
      k[n] = k[n - 1] * ratio * ratio;
      e[n] = -k[n] / (2.0 * double(n) - 1);
    }
    for (std::size_t n = 0; n < terms; ++n) {
      small[n] = 2.0 / 3 * (e[n + 1] + e[n] + k[n] - k[n + 1]);
      turn[n] = 2.0 / 9 * (4 * e[n] - k[n] + (n > 0 ? k[n - 1] - 2 * e[n - 1] : 0));
      large[n] = 2.0 / 3 * (e[n + 1] - k[n + 1] + e[n] + k[n]);
      torque[n] = 2.0 / 9 * (4 * e[n + 1] - 5 * k[n + 1] + 3 * k[n] + 2 * (k[n + 2] - e[n + 2]));
    }
  }
};
constexpr Coefficients coefficients;

// A function of q on [centre − half, centre + half] as a polynomial in y = (q − centre)/half.
template <std::size_t Count>
struct Piece {
  double centre, half;
  std::array<double, Count> c{};

  // Of its series in q: what stands beyond the last of Count powers gives way to lower ones, yⁿ → yⁿ − 2^{1−n} T_n(y),
  // the highest first.
  constexpr Piece(Series b, double from, double to) : centre(0.5 * (from + to)), half(0.5 * (to - from)) {
    for (std::size_t i = 0; i < terms; ++i)
      for (std::size_t n = terms - 1; n > i; --n) b[n - 1] += centre * b[n];
    double power = 1;
    for (double& each : b) each *= power, power *= half;
    for (std::size_t n = terms - 1; n >= Count; --n) {
      double t = b[n];
      for (std::size_t k = 0; 2 * k + 2 <= n; ++k) {
        const double left = double(n - 2 * k);
        t *= -left * (left - 1) / (4 * double(k + 1) * double(n - k - 1));
        b[n - 2 * k - 2] -= t;
      }
    }
    for (std::size_t n = 0; n < Count; ++n) c[n] = b[n];
  }

  double value(double q) const noexcept {
    const double y = (q - centre) / half;
    double p = c[Count - 1];
    for (std::size_t n = Count - 1; n-- > 0;) p = p * y + c[n];
    return p;
  }
  // With q dp/dq.
  std::array<double, 2> with_slope(double q) const noexcept {
    const double y = (q - centre) / half;
    double p = c[Count - 1], slope = 0;
    for (std::size_t n = Count - 1; n-- > 0;) slope = slope * y + p, p = p * y + c[n];
    return {p, q / half * slope};
  }
};

// Both functions about one end of the range of λ. All are analytic up to q = 1, so that on the two pieces Chebyshev's
// coefficients fall by 126 and by 15 a term.
struct End {
  Piece<8> force_near, torque_near;
  Piece<15> force_far, torque_far;

  constexpr End(const Series& force, const Series& torque)
      : force_near(force, 0, border),
        torque_near(torque, 0, border),
        force_far(force, border, 0.25),
        torque_far(torque, border, 0.25) {}
  static constexpr double border = 1.0 / 32;

  struct Values {
    double force, force_slope, torque;
  };
  Values at(double q) const noexcept {
    if (q < border) {
      const auto [force, slope] = force_near.with_slope(q);
      return {force, slope, torque_near.value(q)};
    }
    const auto [force, slope] = force_far.with_slope(q);
    return {force, slope, torque_far.value(q)};
  }
};
constexpr End zero(coefficients.small, coefficients.turn), infinity(coefficients.large, coefficients.torque);

DiscCurve near_infinity(double lambda) noexcept {
  const double inverse = 1 / lambda;
  const auto [force, slope, torque] = infinity.at(inverse * inverse);
  return {force, inverse * torque, -2 * inverse * slope};
}

DiscCurve near_zero(double lambda) noexcept {
  const auto [force, slope, torque] = zero.at(lambda * lambda);
  return {lambda * force, torque, force + 2 * slope};
}

}  // namespace

DiscCurve contact::disc_curve(double lambda) noexcept {
  using std::numbers::pi;
  if (lambda < 0.5) return near_zero(lambda);
  if (lambda > 2) return near_infinity(lambda);
  const double square = lambda * lambda;
  if (lambda == 1) return {8 / (3 * pi), 8 / (9 * pi), 4 / (3 * pi)};
  if (lambda > 1) {
    const auto [k, e] = elliptic(1 / lambda);
    return {4 * ((square + 1) * e - (square - 1) * k) / (3 * pi),
            4 * lambda * ((4 - 2 * square) * e + (2 * square - 5 + 3 / square) * k) / (9 * pi),
            4 * ((2 * square - 1) * e - 2 * (square - 1) * k) / (3 * pi * lambda)};
  }
  const auto [k, e] = elliptic(lambda);
  return {4 * ((square + 1) * e + (square - 1) * k) / (3 * pi * lambda),
          4 * ((4 - 2 * square) * e + (square - 1) * k) / (9 * pi),
          4 * ((2 * square - 1) * e - (square - 1) * k) / (3 * pi * square)};
}

DiscFriction disc_friction(double lambda) noexcept {
  const contact::DiscCurve at = contact::disc_curve(lambda);
  return {at.force, at.torque};
}

}  // namespace ricochet
