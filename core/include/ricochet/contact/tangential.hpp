#pragma once

#include <ricochet/contact/description.hpp>
#include <ricochet/contact/friction.hpp>

#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace ricochet {

/// A spring and a dashpot side by side: −k ξ − c ξ' [N, or N m]. k = 0: none.
struct Spring {
  double stiffness = 0;  ///< k [N/m, or N m]
  double damping = 0;    ///< c [N s/m, or N m s]
};

/// A tangential law: an immutable value that says how stiff a contact is against sliding. Described as a normal law is
/// (`name`, `parameters`, `values()`, `from`, see description.hpp); `spring(ζ)` at the overlap ζ [m] ≥ 0, and whether
/// it is `compliant`: one that is not has no spring, but friction as a set-valued law.
template <class Law>
concept TangentialLawType = std::copyable<Law> && requires(const Law& law) {
  { Law::name } -> std::convertible_to<std::string_view>;
  {std::span<const Parameter>(Law::parameters)};
  { Law::compliant } -> std::convertible_to<bool>;
  { law.values() } -> std::same_as<std::array<double, Law::parameters.size()>>;
  { Law::from(law.values()) } -> std::same_as<Law>;
  { law.spring(0.0) } -> std::same_as<Spring>;
};

/// The paper's friction (34)–(46): a contact sticks, or it slides at the limit. No spring, no memory.
class RigidTangential {
 public:
  static constexpr std::string_view name = "rigid";
  static constexpr std::array<Parameter, 0> parameters{};
  static constexpr bool compliant = false;

  std::array<double, 0> values() const noexcept { return {}; }
  static RigidTangential from(const std::array<double, 0>&) { return {}; }
  Spring spring(double) const noexcept { return {}; }
};

/// Spring and dashpot of constant k_t, c_t.
class LinearTangential {
 public:
  static constexpr std::string_view name = "linear";
  static constexpr std::array<Parameter, 2> parameters{
      {{"k_t", {4, 0, -8}, domains::positive}, {"c_t", {4, 0, -4}, domains::not_negative}}};
  static constexpr bool compliant = true;

  /// k_t > 0 [kg/s²], c_t ≥ 0 [kg/s]; throws std::invalid_argument otherwise.
  explicit LinearTangential(double k_t, double c_t = 0) : k_t_(k_t), c_t_(c_t) {
    require_parameters<LinearTangential>(values());
  }

  double k_t() const noexcept { return k_t_; }
  double c_t() const noexcept { return c_t_; }
  std::array<double, 2> values() const noexcept { return {k_t_, c_t_}; }
  static LinearTangential from(const std::array<double, 2>& v) { return LinearTangential(v[0], v[1]); }
  Spring spring(double) const noexcept { return {k_t_, c_t_}; }

 private:
  double k_t_, c_t_;
};

/// Mindlin's no-slip stiffness 8 G* a of a contact of radius a = √(R*ζ), written k_t √ζ with k_t = 8 G* √R*, and a
/// constant dashpot. What a growing contact adds is not yet strained, what a shrinking one loses takes its strain along
/// (see `Elongation`): LAMMPS calls it mindlin_rescale/force; C. Thornton, S. Cummins, P. Cleary, Powder Technol. 233,
/// 30 (2013).
class MindlinTangential {
 public:
  static constexpr std::string_view name = "mindlin";
  static constexpr std::array<Parameter, 2> parameters{
      {{"k_t", {4, -2, -8}, domains::positive}, {"c_t", {4, 0, -4}, domains::not_negative}}};
  static constexpr bool compliant = true;

  /// k_t > 0 [kg/(s² m^{1/2})], c_t ≥ 0 [kg/s]; throws std::invalid_argument otherwise.
  explicit MindlinTangential(double k_t, double c_t = 0) : k_t_(k_t), c_t_(c_t) {
    require_parameters<MindlinTangential>(values());
  }
  /// Of 1/G* = (2−ν₁)/G₁ + (2−ν₂)/G₂ [Pa] and 1/R* = 1/r₁ + 1/r₂ [m].
  static MindlinTangential of(double shear_modulus_eff, double radius_eff) {
    return MindlinTangential(8 * shear_modulus_eff * std::sqrt(radius_eff));
  }

  double k_t() const noexcept { return k_t_; }
  double c_t() const noexcept { return c_t_; }
  std::array<double, 2> values() const noexcept { return {k_t_, c_t_}; }
  static MindlinTangential from(const std::array<double, 2>& v) { return MindlinTangential(v[0], v[1]); }
  Spring spring(double overlap) const noexcept { return {k_t_ * std::sqrt(std::max(0.0, overlap)), c_t_}; }

 private:
  double k_t_, c_t_;
};

/// The one list of tangential laws.
using TangentialLaw = std::variant<RigidTangential, LinearTangential, MindlinTangential>;

std::string_view name(const TangentialLaw& law) noexcept;
std::span<const Parameter> parameters_of(const TangentialLaw& law) noexcept;
std::vector<double> values(const TangentialLaw& law);
bool compliant(const TangentialLaw& law) noexcept;
inline Spring spring(const TangentialLaw& law, double overlap) noexcept {
  return std::visit([=](const auto& l) { return l.spring(overlap); }, law);
}
/// All names, in the order of the list.
std::vector<std::string_view> tangential_names();
/// The parameters of the law of that name; nullopt for a name that no law has.
std::optional<std::span<const Parameter>> tangential_parameters(std::string_view name);
/// The law of that name with these values of its parameters; nullopt for a name that no law has. Throws
/// std::invalid_argument for another number of values and, naming it, for one outside its domain.
std::optional<TangentialLaw> tangential_law(std::string_view name, std::span<const double> values);

/// Resistance to the spin about the normal, beside that to sliding.
struct Torsion {
  enum class Limit {
    none,      ///< spin is free
    separate,  ///< |M| ≤ arm·a·μR, whatever the sliding
    disc       ///< (|T|/μR, |M|/(μR a)) inside the disc's curve {(F(λ), 𝒯(λ))} of (36), (37), (44)
  };
  Limit limit = Limit::none;
  Spring spring{};       ///< [N m], [N m s]; of a compliant law
  double arm = 2.0 / 3;  ///< of the separate limit, in contact radii; the disc's own at λ = 0
};

/// Resistance to rolling: |M| ≤ (ρ a + μ_r R*) R, ρ from Friction::rolling_arm (46), a the contact radius, R* the
/// effective radius. By default none.
struct Rolling {
  double mu = 0;    ///< μ_r ≥ 0
  Spring spring{};  ///< [N m], [N m s]; of a compliant law
};

/// All that acts in the tangent plane of a contact of two materials.
struct TangentialContact {
  TangentialLaw law = RigidTangential{};
  Friction friction{};
  Torsion torsion{};
  Rolling rolling{};
};

/// Throws std::invalid_argument naming a stiffness, damping, arm or coefficient that is not finite and ≥ 0, or a
/// compliant law whose torsion or rolling has a limit and no spring.
void check(const TangentialContact& contact);

/// What a contact remembers of its motion in the tangent plane, 7 doubles: how far each spring is strained. Zero at the
/// first touch.
struct Elongation {
  Vec3 slide;        ///< ξ [m], in the tangent plane
  double twist = 0;  ///< [rad]
  Vec3 roll;         ///< [rad], turned like SlipMotion::roll

  bool operator==(const Elongation&) const = default;
};

/// A vector that is normal to the unit vector `from` after the shortest turn of `from` into `to`.
inline Vec3 turned(Vec3 a, Vec3 from, Vec3 to) noexcept {
  const double nearness = 1 + dot(from, to);
  return nearness > 1e-12 ? a - dot(to, a) / nearness * (from + to) : a;
}

/// The elongation after the normal has turned from one unit vector to another by the shortest way; lengths are kept.
/// Opposite normals (a step that passes through a body) leave it as it is.
inline Elongation turned(const Elongation& e, Vec3 from, Vec3 to) noexcept {
  return {turned(e.slide, from, to), e.twist, turned(e.roll, from, to)};
}

/// How a contact is pressed together.
struct Pressing {
  double force = 0;           ///< R ≥ 0 [N]; over a step its mean
  double overlap = 0;         ///< ζ [m]
  double contact_radius = 0;  ///< a = w/2 [m]
  double radius_eff = 0;      ///< R* [m]
};

/// Friction's forces on i; on j they are opposite. As FrictionImpulse, a time being divided out.
struct Traction {
  Vec3 sliding;        ///< T [N]
  double torsion = 0;  ///< [N m], along e
  Vec3 rolling;        ///< [N m], turned like SlipMotion::roll: the torque is e×rolling
};

/// Energies of one contact by mechanism, all ≥ 0 [J].
struct TangentialEnergy {
  double sliding = 0, torsion = 0, rolling = 0;
  double sum() const noexcept { return sliding + torsion + rolling; }
};

/// A contact's springs, dashpots and limits as they are at one time.
struct TangentialState {
  Spring sliding, torsion, rolling;
  double sliding_limit = 0;  ///< μ(|u_t|) R [N]
  double torsion_limit = 0;  ///< of a separate limit, or the disc's at λ = 0 [N m]
  double rolling_limit = 0;  ///< [N m]
  double disc_radius = 0;    ///< a [m] where sliding and torsion share the disc's limit curve, else 0
};
/// `speed` |u_t| [m/s]; `sliding` the spring at the overlap.
inline TangentialState tangential_state(const TangentialContact& c, const Pressing& p, double speed,
                                        Spring sliding) noexcept {
  const double limit = c.friction.coefficient(speed) * p.force;
  TangentialState s{
      .sliding = sliding,
      .torsion = c.torsion.spring,
      .rolling = c.rolling.spring,
      .sliding_limit = limit,
      .rolling_limit = (c.friction.rolling_arm() * p.contact_radius + c.rolling.mu * p.radius_eff) * p.force};
  if (c.torsion.limit == Torsion::Limit::separate) s.torsion_limit = c.torsion.arm * p.contact_radius * limit;
  if (c.torsion.limit == Torsion::Limit::disc) {
    s.torsion_limit = 2.0 / 3 * p.contact_radius * limit;
    s.disc_radius = p.contact_radius;
  }
  return s;
}
inline TangentialState tangential_state(const TangentialContact& c, const Pressing& p, double speed) noexcept {
  return tangential_state(c, p, speed, spring(c.law, p.overlap));
}

/// ½k_tξ² and the like.
inline TangentialEnergy stored_energy(const TangentialState& s, const Elongation& e) noexcept {
  return {0.5 * s.sliding.stiffness * dot(e.slide, e.slide), 0.5 * s.torsion.stiffness * e.twist * e.twist,
          0.5 * s.rolling.stiffness * dot(e.roll, e.roll)};
}

/// A traction cut to the limits.
struct LimitedTraction {
  Traction traction;
  bool slides = false, twists = false, rolls = false;  ///< which limits were reached
};
/// The admissible traction nearest to `wanted`, where nearness is energy in springs of the given stiffnesses (k + c/dt
/// over a step): sliding and rolling shrink along themselves, as does torsion, unless it shares the disc's curve.
/// This is the law of greatest dissipation, whence no history makes energy.
inline LimitedTraction limited(const TangentialState& state, const Traction& wanted, double dt) noexcept;

namespace contact {
/// `limited` where sliding and torsion share the disc's curve.
LimitedTraction limited_by_disc(const TangentialState& state, const Traction& wanted, double dt) noexcept;

struct Cut {
  Vec3 traction;
  bool limit = false;
};
inline Cut cut(Vec3 wanted, double limit) noexcept {
  const double square = dot(wanted, wanted);
  return square > limit * limit ? Cut{limit / std::sqrt(square) * wanted, true} : Cut{wanted, false};
}
}  // namespace contact

inline LimitedTraction limited(const TangentialState& s, const Traction& wanted, double dt) noexcept {
  if (s.disc_radius > 0) return contact::limited_by_disc(s, wanted, dt);
  const contact::Cut sliding = contact::cut(wanted.sliding, s.sliding_limit);
  const contact::Cut rolling = contact::cut(wanted.rolling, s.rolling_limit);
  const bool twists = std::abs(wanted.torsion) > s.torsion_limit;
  const double torsion = twists ? std::copysign(s.torsion_limit, wanted.torsion) : wanted.torsion;
  return {{sliding.traction, torsion, rolling.traction}, sliding.limit, twists, rolling.limit};
}

/// Elongation after a step dt [s] in which `traction` acted: (c ξ/dt − T)/(k + c/dt), which is ξ plus the motion while
/// the contact sticks, and what the slider left where it slid. dt = ∞: −T/k, at once.
Elongation set_back(const TangentialState& state, const Elongation& before, const Traction& traction,
                    double dt) noexcept;

/// What a step did.
struct TangentialStep {
  LimitedTraction answer;
  Elongation elongation;      ///< at the end
  TangentialEnergy stored;    ///< at the end
  TangentialEnergy dashpots;  ///< burnt over the step
  TangentialEnergy sliders;   ///< burnt over the step, by the limit and by the contact's growing or shrinking
};

/// The law of a compliant contact over a step dt [s] > 0 with its mean motion: spring and dashpot side by side, a
/// slider behind both,
///   T = −k ξ − c ξ',  |T| ≤ μ(|u_t|) R,  ξ' = u_t while it sticks, u_t − ξ' ∥ −T while it slides,
/// by the implicit Euler rule: T* = −k (ξ + u dt) − c u is cut to the limits, and ξ is what leaves that traction in
/// spring and dashpot. A law whose stiffness grew from k₀ to k₁ over the step keeps its force, ξ → ξ k₀/k₁; one whose
/// stiffness falls keeps ξ.
///
/// Balance, exact for any dt: −T·u dt = Δstored + dashpots + sliders + ½k(Δξ)² per mechanism, all but the first ≥ 0, so
/// no history gains energy. Order 1 in dt. `before` is the pressing at the step's start, `after` at its end.
TangentialStep tangential_step(const TangentialContact& contact, const Elongation& elongation, const SlipMotion& motion,
                               const Pressing& before, const Pressing& after, double dt) noexcept;

}  // namespace ricochet
