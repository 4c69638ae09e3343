#pragma once

#include <cmath>
#include <concepts>
#include <limits>

namespace ricochet::fractional {

/// What an exponential decay e^{−xτ}, x ≥ 0, makes of a unit step 0 ≤ τ ≤ 1: how a Maxwell arm q' = ζ' − s q goes
/// through a step dt with x = s dt (times dt or dt²), and the moments of a memory kernel.
template <std::floating_point Real>
struct DecayMoments {
  Real decay;         ///< e^{−x}
  Real rising;        ///< ∫ τ e^{−xτ} dτ = (1 − (1+x)e^{−x})/x²
  Real falling;       ///< ∫ (1−τ) e^{−xτ} dτ = (x − 1 + e^{−x})/x² = φ₂(−x)
  Real rising_twice;  ///< ∫ τ² e^{−xτ} dτ = (2 − (2 + 2x + x²)e^{−x})/x³
  Real falling_once;  ///< ∫ ½(1−τ)² e^{−xτ} dτ = (½ − falling)/x = φ₃(−x)
};

/// ∫ e^{−xτ} dτ = (1 − e^{−x})/x = φ₁(−x), x ≥ 0; 1.5 ε.
template <std::floating_point Real>
Real decay_mean(Real x) noexcept {
  return x > 0 ? -std::expm1(-x) / x : 1;
}

/// All of them to rounding. Below x = ½, where the closed forms would cancel, by their series in p_k = (−x)^k/(k+2)!:
/// Σ (k+1)p_k, Σ p_k, Σ (k+1)(k+2)/(k+3) p_k and Σ p_k/(k+3). They alternate and their terms fall at least sixfold, so
/// that the first term left out bounds the rest: 2^{−14}/15! < 5e-17 of the sum in double, 2^{−18}/19! < 1e-21 in long
/// double; rounding adds 2 ε. From ½ on the closed forms lose most at ½ itself: by numerator over its largest term
/// 11 ε of `rising`, 4 ε of `falling`, 70 ε of `rising_twice` and 25 ε of `falling_once`, and less than 3 ε past x = 5.
/// Inline, because the callers need some of the sums only and in every partial step.
template <std::floating_point Real>
inline DecayMoments<Real> decay_moments(Real x) noexcept {
  const Real decay = std::exp(-x);
  if (x >= Real(0.5)) {
    const Real square = x * x, falling = (x + std::expm1(-x)) / square;
    return {decay, (1 - (1 + x) * decay) / square, falling, (2 - decay * (2 + x * (2 + x))) / (square * x),
            (Real(0.5) - falling) / x};
  }
  constexpr int terms = std::numeric_limits<Real>::digits > 53 ? 18 : 14;
  Real rising = 0, falling = 0, rising_twice = 0, falling_once = 0, term = Real(0.5);
  for (int k = 0; k < terms; ++k) {
    const Real next = term / static_cast<Real>(k + 3);
    rising += static_cast<Real>(k + 1) * term;
    falling += term;
    rising_twice += static_cast<Real>((k + 1) * (k + 2)) * next;
    falling_once += next;
    term = -x * next;
  }
  return {decay, rising, falling, rising_twice, falling_once};
}

}  // namespace ricochet::fractional
