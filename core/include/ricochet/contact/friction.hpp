#pragma once

#include <ricochet/contact/vec3.hpp>

namespace ricochet {

/// What a disc that slides and spins at once feels: T = μR·force against the sliding, M = μR·(w/2)·torque against the
/// spin. Both are derivatives of one convex function, the mean speed Φ(u, aΩ) over the disc.
struct DiscFriction {
  double force = 1;   ///< F(λ), Eqs. (36), (37): 0 at λ = 0, 1 at λ = ∞
  double torque = 0;  ///< 𝒯(λ), Eq. (44): 2/3 at λ = 0, 0 at λ = ∞
};

/// F and 𝒯 at λ = |u_t|/((w/2)|Ω|) ≥ 0 (∞ allowed), after Farkas, Bartels, Unger and Wolf, Phys. Rev. Lett. 90, 248302
/// (2003). Complete elliptic integrals with modulus λ or 1/λ; for λ < 1/2 and λ > 2, where the closed form cancels,
/// polynomials in λ² or λ⁻² which their hypergeometric series become. Relative error below 1e-14.
DiscFriction disc_friction(double lambda) noexcept;

/// Parameters of Eqs. (35)–(46) for one pair of materials.
class Friction {
 public:
  /// No friction at all.
  Friction() = default;
  /// μ(u) = μ_d + (μ_s − μ_d) exp(−a u), Eq. (35): 0 ≤ μ_d ≤ μ_s, a ≥ 0 [s/m]; `rolling_arm` ρ ≥ 0 is the arm of the
  /// rolling resistance in units of the contact radius (46), 1 in the paper's own cases; 0: ordinary grains, which keep
  /// their spin (Chung & Ooi, Granular Matter 13, 643 (2011), test 4). Throws std::invalid_argument otherwise.
  Friction(double mu_static, double mu_dynamic, double decay, double rolling_arm = 0);

  double coefficient(double speed) const noexcept {
    return mu_dynamic_ + (mu_static_ - mu_dynamic_) * (depends_on_speed() ? std::exp(-decay_ * speed) : 1.0);
  }
  bool depends_on_speed() const noexcept { return decay_ > 0 && mu_static_ > mu_dynamic_; }
  double mu_static() const noexcept { return mu_static_; }
  double mu_dynamic() const noexcept { return mu_dynamic_; }
  double decay() const noexcept { return decay_; }
  double rolling_arm() const noexcept { return rolling_arm_; }

 private:
  double mu_static_ = 0, mu_dynamic_ = 0, decay_ = 0, rolling_arm_ = 0;
};

/// The relative motion in a contact that friction acts on.
struct SlipMotion {
  Vec3 slip;        ///< u_t [m/s], Eq. (9)
  double spin = 0;  ///< Ω = (ω_i − ω_j)·e [1/s]
  Vec3 roll;        ///< (ω_i − ω_j)×e [1/s]: the rolling, turned into the direction in which the contact rolls
};

/// Angular and linear impulses of friction on i; on j they are opposite.
struct FrictionImpulse {
  Vec3 sliding;        ///< [N s], in the tangent plane
  double torsion = 0;  ///< [N m s], along e
  Vec3 rolling;        ///< [N m s], turned like SlipMotion::roll: the torque's impulse is e×rolling
};

/// How impulses change the relative motion: Δslip = slip·sliding + cross·rolling, Δroll = cross·sliding +
/// roll·rolling, Δspin = roll·torsion. With slip = 1/m_i + 1/m_j + |s_i|²/J_i + |s_j|²/J_j as in Eq. (38).
struct SlipMobility {
  double slip = 0;   ///< [1/kg]
  double cross = 0;  ///< |s_i|/J_i − |s_j|/J_j [1/(kg m)]
  double roll = 0;   ///< 1/J_i + 1/J_j [1/(kg m²)]
};

/// One contact over one step, all else known.
struct FrictionProblem {
  double normal_impulse = 0;  ///< ∫R dt ≥ 0 [N s]
  double contact_radius = 0;  ///< w/2 [m]
  SlipMobility mobility;
  SlipMotion before;  ///< at the start of the step
  SlipMotion free;    ///< at its end, were there no friction in this contact
  Vec3 turning;       ///< what slip gains from the step's middle to its end because the contact turns [m/s]
};

struct FrictionSolution {
  FrictionImpulse impulse;
  bool sticks = false;       ///< slip and spin have ended by the step's end: rolling or static, Eqs. (38)–(40)
  bool holds_roll = false;   ///< rolling too has ended (static)
  double slip_fraction = 1;  ///< part of the step during which the contact slid: where sliding → rolling lies in time
};

/// The impulses of sliding, torsion and rolling resistance over a step, Eqs. (34)–(46).
///
/// The paper regularises sgn (61); here the set-valued law is solved as it stands. Sticking comes first: the impulse
/// that ends all slip and spin is taken whenever the limit curve (F, 𝒯) admits it, which is (38) without its chatter.
/// Else the implicit midpoint rule (order 2); where that would reverse the slip or the spin, the implicit Euler rule
/// (order 1, over the last step or two of a slide, so that the order of the whole stays 2). As friction is the
/// gradient of a convex function, both rules are contractions: friction alone never adds energy, whatever the step.
FrictionSolution friction_impulse(const Friction& friction, const FrictionProblem& problem,
                                  const FrictionImpulse& guess) noexcept;

}  // namespace ricochet
