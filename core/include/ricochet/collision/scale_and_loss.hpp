#pragma once

#include <ricochet/collision/reduction.hpp>

#include <functional>
#include <limits>
#include <optional>
#include <variant>

namespace ricochet {

/// One *scale* and one *loss* fix a law at a given impact. (t_col, e_n) is one pair of many: people know moduli, an
/// overlap that they can bear, a time step that they can pay for, a loss factor. Here each is brought to t_col and e_n,
/// law by law, from which `unit_law` and `at_impact` go on.

/// An isotropic elastic solid.
struct ElasticSolid {
  double young = 0;    ///< E [Pa], > 0
  double poisson = 0;  ///< ν, in (−1, 0.5]
};

/// 1/E* = (1 − ν₁²)/E₁ + (1 − ν₂²)/E₂ [Pa] (Johnson, Contact Mechanics, 1985, Eq. (4.22)).
/// Throws std::invalid_argument for a modulus or ratio outside its domain.
double contact_modulus(const ElasticSolid& first, const ElasticSolid& second);

/// Hertz's k = (4/3) E* √R of kζ^{3/2} [kg/(s² m^{1/2})], R = r₁r₂/(r₁+r₂) [m], r₁ against a wall.
/// Throws std::invalid_argument unless both are > 0.
double hertz_stiffness(double contact_modulus, double radius_eff);

/// The greatest overlap of the undamped collision under kζ^{3/2}, ζ_Hertz = (5 m v₀²/(4 k))^{2/5} [m].
/// Throws std::invalid_argument unless all are > 0.
double hertz_overlap(double stiffness, const Impact& impact);

/// How long it takes [s]: t_Hertz = 2 ∫₀¹ dx/√(1−x^{5/2}) ζ_Hertz/v₀ = (4/5) √π Γ(2/5)/Γ(9/10) ζ_Hertz/v₀, which is
/// 2.943275… ζ_Hertz/v₀ = 3.218065… (m²/(k² v₀))^{1/5} (Landau & Lifshitz, Theory of Elasticity, §9).
/// Throws as hertz_overlap.
double hertz_time(double stiffness, const Impact& impact);

/// What a linear spring shares with the Hertzian one that it stands for; no k serves for all.
enum class LinearMatch {
  time,    ///< the undamped collision takes as long
  overlap  ///< the undamped collision goes as deep
};

/// The k of the linear spring that stands for kζ^{3/2} at this impact [kg/s²]: m (π/t_Hertz)², or m (v₀/ζ_Hertz)².
/// Throws as hertz_overlap.
double linear_stiffness(double hertz_stiffness, const Impact& impact, LinearMatch match = LinearMatch::time);

namespace scale {

struct CollisionTime {
  double tcol = 0;  ///< [s], > 0
};
/// The law's own first parameter, in its unit; of the fractional law the k that is held, which is then also the k of
/// the linear law that ends by force with the same t_col and e_n: the paper's relation between the two.
struct Stiffness {
  double k = 0;  ///< > 0
};
/// What the bodies are made of: Hertz's k for the laws in ζ^{3/2}, `linear_stiffness` of it for those in ζ.
struct Moduli {
  ElasticSolid first, second;
  double radius_eff = 0;  ///< r₁r₂/(r₁+r₂) [m], r₁ against a wall; > 0
  double soften = 1;      ///< E* is divided by it; ≥ 1
  LinearMatch linear = LinearMatch::time;
};
/// The greatest overlap of the (damped) collision.
struct MaxOverlap {
  double length = 0;  ///< [m], > 0
};

}  // namespace scale

using Scale = std::variant<scale::CollisionTime, scale::Stiffness, scale::Moduli, scale::MaxOverlap>;

namespace loss {

struct Restitution {
  double en = 0;  ///< in (0, 1]
};
/// tan δ of the material. A springpot has the same phase πα/2 at every frequency, so α = (2/π) atan(tan δ).
struct LossFactor {
  double tan_delta = 0;  ///< ≥ 0
};
/// See damping_ratio.hpp.
struct DampingRatio {
  double ratio = 0;  ///< ≥ 0
};
struct ConversionDegree {
  double alpha = 0;  ///< in [0, 1)
};

}  // namespace loss

using Loss = std::variant<loss::Restitution, loss::LossFactor, loss::DampingRatio, loss::ConversionDegree>;

/// Has a law of that kind such a loss? A restitution has each, a loss factor and α the fractional, a damping ratio
/// linear and Tsuji's.
bool has_loss(LawKind law, const Loss& loss) noexcept;

/// Below which value of the measure a contact of that law ends so: from there on the overlap never returns to zero.
/// Infinity where every value does; the law has the loss.
double loss_limit(LawKind law, ContactEnd end, const Loss& loss) noexcept;

/// The e_n that the loss comes to; exact up to the rounding of damping_ratio.hpp and fractional_contact.hpp. nullopt
/// from `loss_limit` on, and where e_n falls below the least double, or 1 − α below 1e-15.
/// Throws std::invalid_argument for a value outside its domain, or a law that has no such loss.
std::optional<double> restitution(LawKind law, ContactEnd end, const Loss& loss);

/// The stiffness that the scale names, in the law's own unit; nothing of the two scales that name none.
/// Throws std::invalid_argument for a value outside its domain, and for moduli of a law whose first parameter is no
/// stiffness of ζ or ζ^{3/2}.
std::optional<double> stiffness(LawKind law, const Scale& scale, const Impact& impact);

/// The t_col that the scale comes to under the law that keeps `en` [s]; relative error that of `collide` and, of
/// Kuwabara and Kono's law, 1e-10. nullopt where no double carries that law or the time, or what is held keeps it from
/// that en.
/// Throws std::invalid_argument for a value outside its domain.
std::optional<double> collision_time(LawKind law, ContactEnd end, const Scale& scale, double en, const Impact& impact,
                                     const Held& held = {});

/// Where unit laws come from: `unit_law`, or something quicker. nullopt where there is none.
using UnitLaws = std::function<std::optional<AnyLaw>(LawKind law, double en, ContactEnd end)>;

/// The same with unit laws of the caller's.
std::optional<double> collision_time(LawKind law, ContactEnd end, const Scale& scale, double en, const Impact& impact,
                                     const UnitLaws& unit_laws);

}  // namespace ricochet
