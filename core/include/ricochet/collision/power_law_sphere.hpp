#pragma once

namespace ricochet {

/// The impact of a rigid sphere on a viscoelastic half-space whose moduli are those of a springpot, G(t) ∝ t^{−α}:
/// frictionless, without adhesion, quasi-static, small overlaps. By the method of dimensionality reduction (Popov,
/// Willert, Heß, Facta Univ. Mech. Eng. 16, 99 (2018)) the half-space is a row of independent springpots under the
/// parabola y = x²/R: the one that is reached when the overlap ζ is y carries
///
///   f(y, t) = c*/Γ(1−α) ∫_{t_y}^t (t−s)^{−α} ζ'(s) ds,   ζ(t_y) = y,
///
/// until f falls to 0, where it leaves for good; the force is 2∫f dx, and the impact ends when the last one, y = 0,
/// leaves. While the contact grows that is R = K D^α ζ^{3/2}, c* = 3K/(4√R). Scales leave nothing but α: m ζ'' = −R
/// with m = v₀ = K = 1, times in T = (m/(K √v₀))^{1/(5/2−α)}, lengths in v₀T.
struct SphereImpact {
  double en;                ///< −ζ'(t_e)/v₀
  double tcol;              ///< [T]
  double max_overlap;       ///< [v₀T]
  double time_max_overlap;  ///< [T]
  double overlap_end;       ///< [v₀T]: what the surface has not yet recovered
};

/// That impact by Ting's formulation (J. Appl. Mech. 33, 845 (1966)). Of the elements that carry force at a time t
/// after the turning point the outermost one was reached at t₁(t), where ∫_{t₁}^t (t−s)^{−α} ζ'(s) ds = 0; with that
/// R = K/Γ(1−α) ∫_0^{t₁} (t−s)^{−α} d(ζ^{3/2}), which asks for the approach alone. The approach is a power series in
/// t^{5/2−α}; the return is a polynomial of degree `nodes` in t for ζ', found by fixed point of the two equations.
///
/// Error. The force ends as (t_e−t)^{3/2}; integrated on Chebyshev points that leaves an error of order nodes^{−5} in
/// en, 1e-7 relative at 16 nodes, 1e-8 at 24 (`verify sphere`).
/// Domain: 0 ≤ α ≤ 0.8, 8 ≤ nodes ≤ 64; throws std::invalid_argument otherwise. α = 0 is Hertz.
SphereImpact power_law_sphere(double alpha, int nodes = 24);

}  // namespace ricochet
