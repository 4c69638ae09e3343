#pragma once

#include <ricochet/contact/fractional_kelvin_voigt.hpp>
#include <ricochet/contact/fractional_zener.hpp>

namespace ricochet {

/// A collision of m = v₀ = 1 that ends by force.
struct SeriesRebound {
  double tcol, en;
  int terms;  ///< of the series
};

/// Collisions of the linear laws of real solids by their power series, which know no transform and no panels. With
/// α = p/q, q = 20 or 100, and w = s^{−1/q} the transform of the motion, s^{−2}/(1 + s^{−2}M(s)), is a power series in
/// w:
///   fractional-kelvin-voigt  s^{−2}M = k w^{2q} + c w^{2q−p}
///   fractional-zener         s^{−2}M = k w^{2q} + k₁ Σ_{n≥0} (−τ^{−α})^n w^{2q+np}
/// and with A_n the coefficients of 1/(1 + s^{−2}M) it is x = Σ A_n t^{1+n/q}/Γ(2+n/q), entire in t^{1/q}.
/// In long double; the terms up to t^60 are summed, which reach times of 10 in units of √(m/(k + k₁)) and τ. Error of
/// t_col and e_n: 1e-12 relative there. Domain: α a multiple of 1/100 between 0.01 and 1, a collision that ends by
/// then; throws std::invalid_argument otherwise. For studies.
SeriesRebound series_rebound(const FractionalKelvinVoigt& law);
SeriesRebound series_rebound(const FractionalZener& law);

}  // namespace ricochet
