#pragma once

#include <ricochet/contact/tangential.hpp>

namespace ricochet {

/// A contact that sticks from first touch to end is a tangential oscillator of its own, m_t u' + c_t u + k_t ξ = 0,
/// ξ' = u, which the normal force does not enter: where the contact point is at a radius from the centre, homogeneous
/// spheres have 1/m_t = Σ (1/m + r²/J) = 7/(2m), m the effective mass, against a wall and against each other. After
/// t_col its contact point has the tangential restitution
///   β₀ = −u_t(t_e)/u_t(t_b),
/// −1: nothing (no spring), 0: sticks to the end, as rigid friction has it, 1: full reversal.
///
/// m_t/m of homogeneous spheres.
inline constexpr double tangential_mass_ratio = 2.0 / 7;

/// How a spring is found for a β₀ that alone does not fix both k_t and c_t.
enum class StickingForm {
  damped,  ///< half a period in t_col: k_t = m_t (π² + ln²β₀)/t_col², c_t = −2 m_t ln β₀/t_col; 0 < β₀ ≤ 1. N. G. Deen
           ///< et al., Chem. Eng. Sci. 62, 28 (2007)
  undamped  ///< c_t = 0: k_t = m_t (arccos(−β₀)/t_col)²; −1 < β₀ ≤ 1. V. Becker, T. Schwager, T. Pöschel, Phys. Rev. E
            ///< 77, 011304 (2008)
};

/// k_t and c_t whose sticking contact has the tangential restitution β₀ after tcol [s], m = mass_eff [kg]. Relative
/// error 1e-15, and more by what arccos loses near −1 and 1. Throws std::invalid_argument for a β₀ outside the form's
/// domain, or tcol or mass_eff not finite and > 0.
LinearTangential tangential_for(double beta0, double tcol, double mass_eff, StickingForm form = StickingForm::damped);

/// The β₀ of a sticking contact of this law after tcol [s], whatever its damping. With D = c_t/(2 m_t) and
/// w² = k_t/m_t − D²: β₀ = −e^{−Dt}(cos wt − (D/w) sin wt), by cosh and sinh where w² < 0. Absolute error 1e-15 (1 +
/// wt). Throws as above.
double sticking_restitution(const LinearTangential& law, double tcol, double mass_eff);

}  // namespace ricochet
