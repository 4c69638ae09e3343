#pragma once

#include <ricochet/contact/power_law.hpp>

namespace ricochet {

/// Restitution and damping of the two laws whose restitution does not depend on the impact velocity.
///
/// The linear law mζ'' + cζ' + kζ = 0 has the damping ratio β = c/(2√(mk)). Tsuji's law mζ'' + cζ^{1/4}ζ' + kζ^{3/2} =
/// 0 is the same oscillator by another clock: with q ∝ ζ^{5/4} and ds ∝ ζ^{1/4} dt it becomes q'' + 2βq' + q = 0 with
/// β = c/√(5mk), and its force vanishes where q + 2βq' does. So both laws share, for both ends of a contact,
///
/// - end by overlap (24), q = 0:        e_n = exp(−πβ/√(1−β²)),  β < 1 only (an overdamped overlap never returns);
/// - end by force (25), q + 2βq' = 0:   e_n = exp(−2ψ cot ψ),  β = cos ψ ≤ 1;  e_n = exp(−2u coth u),  β = cosh u ≥ 1.
///
/// Sources: Antypov & Elliott, EPL 94, 50004 (2011) for Tsuji's law ended by overlap; Schwager & Pöschel, Granular
/// Matter 9, 465 (2007) for the linear law ended by force. Relative accuracy of both functions: a few units in the last
/// place times 1 + |ln e_n|, and for the inverse the same of β (at e_n → 1, of 1 − e_n).

/// e_n of a contact with damping ratio β ≥ 0, β < 1 for ContactEnd::overlap; throws std::invalid_argument otherwise.
double restitution_of_damping(double damping_ratio, ContactEnd end);

/// Its inverse, β of 0 < e_n ≤ 1; throws std::invalid_argument otherwise.
double damping_of_restitution(double en, ContactEnd end);

/// β = c/(2√(mk)) [–]; mass_eff > 0 [kg], throws std::invalid_argument otherwise.
double damping_ratio(const Linear& law, double mass_eff);

/// β = c/√(5mk) [–]; mass_eff > 0 [kg], throws std::invalid_argument otherwise.
double damping_ratio(const Tsuji& law, double mass_eff);

}  // namespace ricochet
