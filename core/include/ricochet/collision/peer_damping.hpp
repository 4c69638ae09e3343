#pragma once

#include <ricochet/collision/damping_ratio.hpp>

#include <span>
#include <string_view>

namespace ricochet {

/// Which of the two laws with a velocity-independent restitution an engine's formula feeds.
enum class PeerLaw { linear, tsuji };

/// How one engine turns the restitution that its user asks for into damping: β (see damping_ratio.hpp) as a function of
/// e_n, for the law and the end of contact that the engine then runs with it.
struct PeerDamping {
  std::string_view id;      ///< short, unique: what tables and plots print
  std::string_view engine;  ///< name and the versions that the formula was read in
  PeerLaw law;
  ContactEnd end;                      ///< force: the engine clips the attractive part; overlap: it does not
  bool exact;                          ///< derived for this law and this end, so en obtained = en asked up to rounding
  double (*damping_ratio)(double en);  ///< β(e_n), 0 < e_n ≤ 1
  std::string_view source;             ///< repository and file, or paper
};

/// Every formula that could be read in the engine's own source, by engine.
std::span<const PeerDamping> peer_dampings();

/// α(e) of J. S. Marshall, J. Comput. Phys. 228, 1541 (2009), Eq. (53): c = α√(mk) for Tsuji's law with the particle's
/// mass m, a fit of degree 6 to the curve drawn by Tsuji, Tanaka and Ishida (1992). Falls from 1.2728 at e = 0 to
/// 0.0003 at e = 1.
double marshall_polynomial(double en);

/// e(u) of P. Müller and T. Pöschel, Phys. Rev. E 84, 021302 (2011): the Padé form [1/4] of Kuwabara and Kono's
/// restitution, u² = c k^{−3/5} m^{−2/5} v^{1/5}, u ≥ 0, which molecular dynamics and kinetic theory take for e(v):
/// e = (1 + c₁u)/(1 + c₁u + d₂u² + d₃u³ + d₄u⁴), c₁ = 0.501086, d₂ = 1.15345, d₃ = 0.577977, d₄ = 0.532178.
double mueller_poeschel_restitution(double u);

/// γ(e) of C. Thornton, S. J. Cummins and P. W. Cleary, Powder Technol. 233, 30 (2013), Eqs. (B6), (B7), Table 2:
/// c = 2γ√(m K_t) with the tangent stiffness K_t = (3/2)kζ^{1/2}, a fit of degree 10 for Tsuji's law ended by force.
/// 0 < e < 1.
double thornton_polynomial(double en);

}  // namespace ricochet
