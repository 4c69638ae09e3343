#pragma once

#include <ricochet/collision/driven_law.hpp>
#include <ricochet/collision/instant.hpp>
#include <ricochet/contact/laws.hpp>

#include <concepts>
#include <cstddef>
#include <functional>
#include <limits>

namespace ricochet {

/// The binary collision m ζ'' + R = 0, ζ(0) = 0, ζ'(0) = v₀ (47): two spheres of effective mass m = m₁m₂/(m₁+m₂), or
/// one sphere of mass m on a wall.
struct Impact {
  double velocity = 0;  ///< v₀ [m/s], > 0
  double mass_eff = 0;  ///< m [kg], > 0
};

enum class CollideMethod {
  automatic,    ///< the closed form where there is one, else numerical
  closed_form,  ///< throws where there is none (Kuwabara-Kono, Tsuji, a law of your own)
  numerical     ///< integrates the law's own equation of motion; knows no closed form
};

struct CollideOptions {
  ContactEnd end = ContactEnd::force;
  CollideMethod method = CollideMethod::automatic;
  /// Force evaluations that the numerical or the generic path may spend; the generic one looks between two runs through
  /// its mesh, of at most some 2e5. Not of the fractional law, whose collocation takes no more than five linear systems
  /// of 32 to 120 nodes.
  std::size_t max_evaluations = 1'000'000;
  /// What a contact can take up [J], ≥ 0: where a collision ends by (26) and has taken up as much, the bodies break
  /// (Definition 7); infinite: they never do.
  double breakage_energy = std::numeric_limits<double>::infinity();
};

enum class CollisionStatus {
  ended_by_force,     ///< the repulsive force fell to zero (25); where c = 0 the overlap does so at the same time
  ended_by_overlap,   ///< the overlap returned to zero (24); also where an end by force was asked for and the force of
                      ///< (30) falls to zero no sooner than that, still repelling: fractional with α < 0
  permanent_contact,  ///< the force only tends to zero (26), and the approach has fallen to `at_rest` of v₀ (Def. 7)
  breakage,           ///< the same, and the contact has taken up `breakage_energy`
  no_separation,  ///< the asked end does not exist: an overdamped overlap, one that swings about a positive rest, …
  budget_spent,   ///< max_evaluations reached before the end
  out_of_range    ///< a scale of the collision (time, length, force, e_n) is no normal double, or, on the numerical
                  ///< path, lost in rounding: a damping group past 1e100, an overlap's end with e_n < 1e-150
                  ///< (fractional: 1e-7), a fractional force's end with e_n < 1e-12
};

/// What a collision did. Times count from the first touch t_b. After permanent_contact and breakage tcol is where the
/// bodies count as come to rest, overlap_end what they overlap by then, and en = 0, as they do not part. After any
/// other status than these and the two ends tcol, en and overlap_end are 0; the extremes are those met while the motion
/// was followed (for the fractional law, none: 0).
struct Collision {
  CollisionStatus status = CollisionStatus::no_separation;
  double tcol = 0;              ///< t_e − t_b [s]
  double en = 0;                ///< −ζ'(t_e)/v₀; > 1 where the law gains energy (fractional with α < 0)
  double max_overlap = 0;       ///< [m]
  double time_max_overlap = 0;  ///< [s]
  double max_force = 0;         ///< greatest repulsion [N]; 0 where that is infinite, at t_b (fractional with α > 1)
  double time_max_force = 0;    ///< [s]
  double overlap_end = 0;       ///< ζ(t_e) [m]
  std::size_t evaluations = 0;  ///< of the force, by the numerical path; 0 for a closed form

  bool separated() const noexcept {
    return status == CollisionStatus::ended_by_force || status == CollisionStatus::ended_by_overlap;
  }
};

/// One binary collision under one law.
///
/// Closed forms. Linear, with D = c/(2√(mk)) = cos ψ (cosh ψ when overdamped) and time in √(m/k): the force vanishes at
/// 2ψ/sin ψ with e_n = exp(−2ψ cot ψ), the overlap at π/sin ψ with e_n = exp(−π cot ψ), and only for D < 1; both keep
/// full accuracy across D = 1. Hysteretic: two quarters of a sine. Fractional: Eqs. (47)–(56), −1 ≤ α < 2
/// (collision/fractional_contact.hpp). For α < 0 the force still repels as the overlap returns to 0, where (30) ends
/// it: the collision ends there (24) whichever end was asked for.
///
/// α ≥ 1 of the fractional law is (26): the overlap stays, the force only tends to 0, and whichever end was asked for,
/// on both paths by the closed form, the collision ends at rest: where ζ' = v₀ E_{2−α,1}(−A t^{2−α}) has fallen to
/// `at_rest` of v₀. All but 1e-4 of the impact's energy, ½ m v₀², is taken up then; it is `breakage` where that is
/// `breakage_energy` or more. The paper leaves both the time and the choice (the hardness of the surfaces) open.
///
/// An overdamped overlap (damping ratio ≥ 1 of the linear law, and of Tsuji's in ζ^{5/4}) never returns to zero, which
/// the ratio decides on every path.
///
/// Numerical path. Time is replaced by the variable in which the damped power laws are polynomial (see
/// core/src/collision/damped_power.hpp), so the start and the end, where ζ^{1/2} and ζ^{1/4} are not smooth, cost no
/// order; Runge-Kutta-Fehlberg 7(8) with error control, every event located by redoing the step it lies in. The
/// fractional law is solved by collocation instead (contact/fractional_collocation.hpp; evaluations counts its nodes).
/// Strong damping is followed in the force instead of the velocity, the unloading of the hysteretic law in ζ − ζ₀:
/// neither loses digits. Kuwabara and Kono's overlap always returns, but slowly under strong damping: past γ = 300 the
/// budget may be spent first, or, with e_n < 1e-12, the end count as no_separation.
///
/// Relative error of tcol and en, L = |ln e_n|: 1e-11, and more only where the problem itself or its rounding asks for
/// it:
///   linear by overlap             1e-16 L³    both paths: the rounding of a damping ratio close to 1
///   Tsuji by overlap              1e-15 L³    the same
///   fractional, by overlap        1e-15/e_n²  both paths
///   fractional, by force          1e-16/(1 − α), both paths; the numerical one 1e-14/e_n more
/// Throws std::invalid_argument for velocity or mass_eff not finite and > 0, a breakage_energy that is negative or no
/// number, closed_form without one, and a fractional law with α < −1.
Collision collide(const Linear& law, const Impact& impact, const CollideOptions& options = {});
Collision collide(const KuwabaraKono& law, const Impact& impact, const CollideOptions& options = {});
Collision collide(const Tsuji& law, const Impact& impact, const CollideOptions& options = {});
Collision collide(const Hysteretic& law, const Impact& impact, const CollideOptions& options = {});
Collision collide(const Fractional& law, const Impact& impact, const CollideOptions& options = {});

/// The same of the laws of real solids, at 0 ≤ α ≤ 1, from an elastic contact to one that keeps nothing.
///
/// fractional-kelvin-voigt and fractional-zener. Closed form: the inverse Laplace transform of the motion
/// (fractional/viscoelastic_motion.hpp), whose first zeros are located. Their limits are the linear law's own closed
/// form: α = 1 (Kelvin–Voigt), α = 0, c = 0, k1 = 0, and a τ whose k₁τ^α no double carries; Zener's α = 1, the standard
/// linear solid, is exact as it stands. Numerical: Kelvin–Voigt, ended by force, by collocation of the Volterra
/// equation, panel by panel; Zener by the generic path on Maxwell arms; Kelvin–Voigt ended by overlap by the transform
/// too.
///
/// fractional-hertz has no closed form: by the same collocation, on both paths. α = 1 is Kuwabara and Kono's law of
/// c·3/2; α = 0, c = 0, and a springpot of less than 1e-16 of the force are Hertz's spring; k = 0 with α = 1, a dashpot
/// alone, is a permanent_contact. It ends by force alone: throws std::invalid_argument for an end by overlap, and for
/// closed_form.
///
/// Relative error of tcol and en:
///   by transform, ended by force     1e-12, and 1e-16/(1 − α) more where en depends on 1 − α (large c, α → 1)
///   by transform, ended by overlap   1e-12 + 1e-15/e_n²
///   by collocation                   1e-11 + 1e-14/e_n
///   Zener on arms                    1e-7
/// Where scales lie farther apart than doubles carry, out_of_range.
Collision collide(const FractionalKelvinVoigt& law, const Impact& impact, const CollideOptions& options = {});
Collision collide(const FractionalHertz& law, const Impact& impact, const CollideOptions& options = {});
Collision collide(const FractionalZener& law, const Impact& impact, const CollideOptions& options = {});

namespace collision {
/// Every duty of the generic `collide`; with a load [N] that of `collide_under_load`.
Collision follow(DrivenLaw& law, const Impact& impact, const CollideOptions& options, double load = 0);
/// Whether the force falls to 0 under a load [N]: by steps good to a per mille, so near the speed where it just does
/// the answer is as rough.
bool parts_under(DrivenLaw& law, const Impact& impact, double load);
/// Shows `visit` a collision that ends by force at some hundred instants, to a per mille or so; the memory of `law` is
/// then that of the instant. Some 1e5 evaluations at most.
void walk(DrivenLaw& law, const Impact& impact, const std::function<void(const Instant&)>& visit);
}  // namespace collision

/// The same of any contact law, by its `force` and `advance` alone; the laws above have better ways of their own, which
/// overload resolution prefers (`collide<Linear>(…)` asks for this one nevertheless).
///
/// Method. The implicit trapezoid with the memory advanced along a linear rate, which is symmetric and of second order,
/// over N steps from the touch to the turning point and N more to the end, each at the last point of a mesh whose
/// length is solved for; the mesh is graded by a fourth power towards touch and end, where forces begin like ζ^{1/2},
/// ζ^{1/4} or t^{1−α}. N is doubled from 16 on and every result extrapolated, by Romberg's scheme and Wynn's epsilon,
/// until one of the two has stood still to 1e-10. Memories are only copied, never combined.
///
/// The end is looked for after the turning point: by force where that falls to 0, or where it still repels as the
/// overlap returns to 0. Overlaps below 0 are never shown to the law. no_separation: the motion has grown slower than
/// 1e-13 v₀, or turned inwards again before the asked end, or nothing repels; out_of_range: also where the force is no
/// number.
///
/// Error: relative to each of tcol, en, max_overlap and max_force, and of overlap_end to max_overlap, 1e-9, where the
/// law is smooth apart from the touch, the turning point and the end, and e_n ≥ 1e-5; time_max_overlap the same,
/// time_max_force 1e-5 tcol. Smaller e_n, a law that bends in between, or a memory that is more than 1e3 times faster
/// than the collision may leave the budget spent. After no_separation the extremes up to the turning point are as
/// accurate, a greater force past it or an overlap without a turning point is good to 1e-3.
/// A motion that slows down like that without ever turning, its force not zero, is a permanent_contact (or a breakage);
/// tcol and overlap_end are then good to 1e-3.
/// Throws std::invalid_argument as above, and for closed_form.
template <ContactLaw Law>
Collision collide(const Law& law, const Impact& impact, const CollideOptions& options = {}) {
  collision::Driven<Law> driven(law);
  return collision::follow(driven, impact, options);
}

/// For AnyLaw itself and nothing that merely converts to it: a law in the variant without a `collide` of its own would
/// otherwise call this one, and that itself, without end.
template <std::same_as<AnyLaw> Any>
Collision collide(const Any& law, const Impact& impact, const CollideOptions& options = {}) {
  return std::visit([&](const auto& one) { return collide(one, impact, options); }, law);
}

}  // namespace ricochet
