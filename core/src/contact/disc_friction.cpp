#include <ricochet/contact/friction.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace ricochet {
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

// 4^{-27} < 2^{-53}: enough for λ² ≤ 1/4, where the closed forms would lose F to cancellation as λ → 0 and both as
// λ → ∞, and where the sums save the mean's square roots.
constexpr std::size_t terms = 27;
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

// Σ c_n qⁿ, q ≤ 1/4, with no more terms than q needs: q^needed < 2⁻⁵³.
double sum(const Series& c, double q) noexcept {
  const std::size_t needed = q < 0.01   ? q < 1e-4 ? 5 : 8
                             : q < 0.05 ? q < 0.02 ? 10 : 13
                             : q < 0.1  ? 16
                             : q < 0.17 ? 21
                                        : terms;
  double value = 0;
  for (std::size_t n = needed; n-- > 0;) value = value * q + c[n];
  return value;
}

DiscFriction near_infinity(double lambda) noexcept {
  const double inverse = 1 / lambda, q = inverse * inverse;
  return {sum(coefficients.large, q), inverse * sum(coefficients.torque, q)};
}

DiscFriction near_zero(double lambda) noexcept {
  const double q = lambda * lambda;
  return {lambda * sum(coefficients.small, q), sum(coefficients.turn, q)};
}

}  // namespace

DiscFriction disc_friction(double lambda) noexcept {
  using std::numbers::pi;
  if (lambda == 1) return {8 / (3 * pi), 8 / (9 * pi)};
  if (lambda < 0.5) return near_zero(lambda);
  if (lambda > 2) return near_infinity(lambda);
  const double square = lambda * lambda;
  if (lambda > 1) {
    const auto [k, e] = elliptic(1 / lambda);
    return {4 * ((square + 1) * e - (square - 1) * k) / (3 * pi),
            4 * lambda * ((4 - 2 * square) * e + (2 * square - 5 + 3 / square) * k) / (9 * pi)};
  }
  const auto [k, e] = elliptic(lambda);
  return {4 * ((square + 1) * e + (square - 1) * k) / (3 * pi * lambda),
          4 * ((4 - 2 * square) * e + (square - 1) * k) / (9 * pi)};
}

}  // namespace ricochet
