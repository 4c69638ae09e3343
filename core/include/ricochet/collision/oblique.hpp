#pragma once

#include <ricochet/collision/collision.hpp>
#include <ricochet/contact/tangential.hpp>

#include <concepts>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <variant>

namespace ricochet {

/// One of the two bodies of an oblique impact: a sphere, or a wall of infinite mass, which cannot turn.
struct ImpactBody {
  double mass = 0;    ///< [kg], > 0; ∞: a wall
  double radius = 0;  ///< [m], > 0; of no concern for a wall
  Vec3 velocity{};    ///< [m/s], of the centre
  Vec3 spin{};        ///< ω [1/s]; of no concern for a wall
  /// J/(m r²), in (0, 2/3]: 2/5 of a homogeneous sphere, 2/3 of a thin shell.
  double inertia_ratio = 0.4;

  static ImpactBody wall(Vec3 velocity = {}) {
    return {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), velocity, {}, 0.4};
  }
  bool is_wall() const noexcept { return std::isinf(mass); }
};

/// Two bodies at the first touch. They approach each other along the normal: (v_i − v_j)·e > 0.
struct ObliqueImpact {
  Vec3 normal{0, 0, 1};  ///< e, from i to j, of any length > 0
  ImpactBody i{};
  ImpactBody j = ImpactBody::wall();
};

/// Where the forces act.
enum class ContactArm {
  radius,        ///< at a radius from each centre, as the textbooks have it
  contact_point  ///< at the paper's contact point, Eqs. (7), (18), nearer by half the overlap or so (geometry.hpp)
};

struct ObliqueOptions {
  ContactEnd end = ContactEnd::force;  ///< of the normal motion; tangential forces end with the repulsion in any case
  ContactArm arm = ContactArm::radius;
  /// Evaluations of the tangential motion, and of the force along the normal (see CollideOptions). A few thousand do,
  /// but for 9 k_t t_col/c_t where a weak dashpot lets a sliding spring relax far faster than the collision lasts.
  std::size_t max_evaluations = 1'000'000;
};

/// Energies lost [J], each ≥ 0.
struct ObliqueLosses {
  double normal = 0;   ///< by the law along the normal; < 0 where that gains energy (fractional with α < 0)
  double dashpot = 0;  ///< by the tangential dashpots, of sliding, torsion and rolling
  double sliding = 0;  ///< by the sliding limit, and by a contact area that changes under strain
  double torsion = 0;  ///< by its limit
  double rolling = 0;  ///< by its limit
  double stored = 0;   ///< left in springs beside a dashpot when the repulsion ended: gone with the contact

  double sum() const noexcept { return normal + dashpot + sliding + torsion + rolling + stored; }
};

/// What an oblique impact did. Unless `separated()`, status and `normal` alone mean anything.
struct ObliqueCollision {
  CollisionStatus status = CollisionStatus::no_separation;  ///< budget_spent also of the tangential motion
  Collision normal{};                                       ///< along the normal: tcol, en, …
  Vec3 velocity_i{}, velocity_j{};                          ///< after [m/s]
  Vec3 spin_i{}, spin_j{};                                  ///< after [1/s]
  /// v_t'·v_t/v_t² of the centres' relative velocity in the tangent plane; none where v_t = 0.
  std::optional<double> et{};
  /// −u_t'·u_t/u_t² of the contact point's slip, at a radius from the centres; none where u_t = 0.
  std::optional<double> beta{};
  double impulse_ratio = 0;              ///< |tangential impulse| over the normal one; μ: gross sliding
  Vec3 impulse{};                        ///< on i [N s]
  double stick_time = 0, slip_time = 0;  ///< how long the contact stuck and slid [s]; their sum is the repulsion's time
  int switches = 0;                      ///< between sticking and sliding
  ObliqueLosses lost{};
  std::size_t evaluations = 0;  ///< of the tangential motion

  bool separated() const noexcept {
    return status == CollisionStatus::ended_by_force || status == CollisionStatus::ended_by_overlap;
  }
};

namespace collision {

/// ζ, ζ', R of a normal motion from touch to the end of its repulsion.
class NormalPath;

std::shared_ptr<const NormalPath> normal_path(const Linear& law, const Impact& impact, const Collision& by_force);
std::shared_ptr<const NormalPath> normal_path(const KuwabaraKono& law, const Impact& impact, const Collision& by_force);
std::shared_ptr<const NormalPath> normal_path(const Tsuji& law, const Impact& impact, const Collision& by_force);
std::shared_ptr<const NormalPath> normal_path(const Hysteretic& law, const Impact& impact, const Collision& by_force);
std::shared_ptr<const NormalPath> normal_path(const Fractional& law, const Impact& impact, const Collision& by_force);
std::shared_ptr<const NormalPath> normal_path(const FractionalKelvinVoigt& law, const Impact& impact,
                                              const Collision& by_force);
std::shared_ptr<const NormalPath> normal_path(const FractionalHertz& law, const Impact& impact,
                                              const Collision& by_force);
std::shared_ptr<const NormalPath> normal_path(const FractionalZener& law, const Impact& impact,
                                              const Collision& by_force);
std::shared_ptr<const NormalPath> normal_path(DrivenLaw& law, const Impact& impact, const Collision& by_force);

/// Speed of approach and effective mass; checks bodies, normal and law.
Impact normal_impact(const ObliqueImpact& impact, const TangentialContact& tangential);

/// The tangential motion along a given normal one, which has ended as asked and, of the same law, `by_force`.
ObliqueCollision along(const NormalPath& path, const Collision& normal, const Collision& by_force,
                       const TangentialContact& tangential, const ObliqueImpact& impact, const ObliqueOptions& options);

/// `collide` with a normal law whose path `make(impact, by_force)` gives.
template <class Law, class Make>
ObliqueCollision collide_obliquely(const Law& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                                   const ObliqueOptions& options, const Make& make) {
  const Impact head_on = normal_impact(impact, tangential);
  CollideOptions asked{.end = options.end, .max_evaluations = options.max_evaluations};
  const Collision normal = collide(law, head_on, asked);
  if (!normal.separated()) return {.status = normal.status, .normal = normal};
  asked.end = ContactEnd::force;
  const Collision by_force = options.end == ContactEnd::force ? normal : collide(law, head_on, asked);
  if (!by_force.separated()) return {.status = by_force.status, .normal = normal};
  return along(*make(head_on, by_force), normal, by_force, tangential, impact, options);
}

}  // namespace collision

/// The oblique binary collision: any normal law with any tangential law, any velocities and spins.
///
/// The frame of the contact at the first touch is kept: exact on a wall, and of two spheres it leaves out the angle
/// v_t t_col/(r_i + r_j) by which they turn about each other, as (47) does. Then the normal motion is that of `collide`
/// and the tangential one follows it, T the traction on i in the plane, a_i, a_j the arms (docs/theory/oblique.md):
///   u = V + (a_i ω_i + a_j ω_j)×e,  V' = T/m,  ω_i' = e×(a_i T + M)/J_i,  ω_j' = e×(a_j T − M)/J_j.
///
/// Method: ζ(t), R(t) by closed forms (hysteretic, fractional, fractional-kelvin-voigt, fractional-zener), by the
/// polynomials of a collocation (fractional-hertz), by a recorded integration in the variable that makes the motion
/// smooth (power laws), or by extrapolated steps of the law's own memory (any other law). The tangential
/// motion by Runge-Kutta-Fehlberg 7(8) with error control, one smooth phase after another: each event, stick to slip
/// and slip to stick, is located by redoing the step it lies in. A compliant contact whose torsion shares the disc's
/// limit goes by 2¹⁴ and 2¹⁵ steps of its own (`tangential_step`), extrapolated.
///
/// Error, relative to the greatest tangential speed of the contact before the impact (spins times their arms): 1e-9 of
/// et, beta and of velocities and spins after; of the change of either 1e-9 as well, however grazing the impact. Of
/// each loss, relative to the energy of the impact: 1e-9. e_n and t_col as in `collide`. For the generic path the
/// same, where its own bound holds. 1e-6 in place of 1e-9 where a compliant contact shares the disc's limit.
///
/// Throws std::invalid_argument for bodies or laws outside their domains, two walls, and bodies that do not approach.
template <ContactLaw Law>
ObliqueCollision collide(const Law& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options = {}) {
  return collision::collide_obliquely(law, tangential, impact, options, [&](const Impact& head_on, const Collision& c) {
    collision::Driven<Law> driven(law);
    return collision::normal_path(driven, head_on, c);
  });
}
ObliqueCollision collide(const Linear& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options = {});
ObliqueCollision collide(const KuwabaraKono& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options = {});
ObliqueCollision collide(const Tsuji& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options = {});
ObliqueCollision collide(const Hysteretic& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options = {});
ObliqueCollision collide(const Fractional& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options = {});
ObliqueCollision collide(const FractionalKelvinVoigt& law, const TangentialContact& tangential,
                         const ObliqueImpact& impact, const ObliqueOptions& options = {});
ObliqueCollision collide(const FractionalHertz& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options = {});
ObliqueCollision collide(const FractionalZener& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options = {});

template <std::same_as<AnyLaw> Any>
ObliqueCollision collide(const Any& law, const TangentialContact& tangential, const ObliqueImpact& impact,
                         const ObliqueOptions& options = {}) {
  return std::visit([&](const auto& one) { return collide(one, tangential, impact, options); }, law);
}

}  // namespace ricochet
