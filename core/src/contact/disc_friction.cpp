#include <ricochet/contact/friction.hpp>

#include <gsl/gsl_sf_ellint.h>

#include <numbers>

namespace ricochet {
namespace {

// K(k) = (π/2) Σ k_n k^{2n}, E(k) = (π/2) Σ e_n k^{2n} with k_n = ((2n−1)!!/(2n)!!)², e_n = −k_n/(2n−1).
// `k`, `e` are the present pair, `k1`, `e1` the next.
struct EllipticTerms {
  double k = 1, e = 1, k1 = 0.25, e1 = -0.25;
  int n = 0;

  void next() noexcept {
    ++n;
    k = k1, e = e1;
    const double ratio = (2.0 * n + 1) / (2.0 * n + 2);
    k1 = k * ratio * ratio;
    e1 = -k1 / (2.0 * n + 1);
  }
};

// 4^{-27} < 2^{-53}: enough for λ² ≤ 1/4.
constexpr int series_terms = 27;

// F = (2/3) Σ (e_{n+1} + e_n + k_n − k_{n+1}) λ^{2n+1}
double force_near_zero(double lambda) noexcept {
  double sum = 0, power = lambda;
  EllipticTerms t;
  for (int n = 0; n < series_terms; ++n, t.next(), power *= lambda * lambda) sum += (t.e1 + t.e + t.k - t.k1) * power;
  return 2.0 / 3 * sum;
}

// With q = λ⁻²: F = (2/3) Σ (e_{n+1} − k_{n+1} + e_n + k_n) qⁿ and
// 𝒯 = (2/9) λ Σ_{n≥1} (4e_n − 5k_n + 3k_{n−1} + 2(k_{n+1} − e_{n+1})) qⁿ; the term n = 0 vanishes.
DiscFriction near_infinity(double lambda) noexcept {
  const double inverse = 1 / lambda, q = inverse * inverse;
  EllipticTerms t;
  double force = t.e1 - t.k1 + t.e + t.k, torque = 0, power = q;
  double torque_power = inverse;  // λ qⁿ, also where λ overflows its square
  for (int n = 1; n < series_terms; ++n, power *= q, torque_power *= q) {
    const double k_before = t.k;
    t.next();
    force += (t.e1 - t.k1 + t.e + t.k) * power;
    torque += (4 * t.e - 5 * t.k + 3 * k_before + 2 * (t.k1 - t.e1)) * torque_power;
  }
  return {2.0 / 3 * force, 2.0 / 9 * torque};
}

}  // namespace

DiscFriction disc_friction(double lambda) noexcept {
  using std::numbers::pi;
  if (lambda == 1) return {8 / (3 * pi), 8 / (9 * pi)};
  if (lambda > 2) return near_infinity(lambda);
  const double square = lambda * lambda;
  if (lambda > 1) {
    const double k = gsl_sf_ellint_Kcomp(1 / lambda, GSL_PREC_DOUBLE);
    const double e = gsl_sf_ellint_Ecomp(1 / lambda, GSL_PREC_DOUBLE);
    return {4 * ((square + 1) * e - (square - 1) * k) / (3 * pi),
            4 * lambda * ((4 - 2 * square) * e + (2 * square - 5 + 3 / square) * k) / (9 * pi)};
  }
  const double k = gsl_sf_ellint_Kcomp(lambda, GSL_PREC_DOUBLE);
  const double e = gsl_sf_ellint_Ecomp(lambda, GSL_PREC_DOUBLE);
  const double torque = 4 * ((4 - 2 * square) * e + (square - 1) * k) / (9 * pi);
  if (lambda < 0.5) return {force_near_zero(lambda), torque};
  return {4 * ((square + 1) * e + (square - 1) * k) / (3 * pi * lambda), torque};
}

}  // namespace ricochet
