// The laws of real solids.

#include <ricochet/collision/collision.hpp>
#include <ricochet/support/require.hpp>

#include "closed_forms.hpp"
#include "require_impact.hpp"
#include "solid_motion.hpp"
#include "viscoelastic_collision.hpp"

#include <algorithm>
#include <cmath>

namespace ricochet {
namespace {

/// 1/T² and T of two forces side by side, from the rates of either alone, squared [1/s²].
double unit_of(double rate_squared) { return 1 / std::sqrt(rate_squared); }
double pot_rate_squared(double pot, double power) { return std::pow(pot, 2 / power); }

/// k₁τ^α per unit of mass.
double pot_of(const FractionalZener& law, double mass) { return law.k1() / mass * std::pow(law.tau(), law.alpha()); }

std::optional<collision::SolidMotion> motion_in(const ViscoelasticModulus& modulus, double unit) {
  const double pot = modulus.pot * std::pow(unit, 2 - modulus.alpha), square = unit * unit;
  const ViscoelasticModulus scaled{modulus.spring * square, pot, modulus.softness / square, modulus.alpha};
  if (!(std::isnormal(scaled.spring) && std::isnormal(scaled.pot) && std::isfinite(scaled.softness)))
    return std::nullopt;
  return collision::SolidMotion{unit, ViscoelasticMotion(scaled)};
}

Collision by_transform(const std::optional<collision::SolidMotion>& motion, const Impact& impact, ContactEnd end) {
  if (!motion) return {.status = CollisionStatus::out_of_range};
  return collision::in_units(collision::closed_form(motion->motion, end), impact, motion->unit);
}

/// Half steps of the arms, extrapolated: what the generic `collide` does with the law on a kernel.
Collision by_arms(const FractionalZener& law, const Impact& impact, const CollideOptions& options) {
  const Collision known = collide(law, impact, {});
  if (!known.separated()) return known;
  return collide<FractionalZenerArms>(arms_of_collision(law, known.tcol), impact,
                                      {.end = options.end, .max_evaluations = options.max_evaluations});
}

/// Ended by force.
Collision by_collocation(const std::optional<collision::ScaledEquation>& scaled, const Impact& impact) {
  if (!scaled) return {.status = CollisionStatus::out_of_range};
  return collision::in_units(collision::follow_memory(scaled->equation), impact, scaled->unit);
}

std::optional<collision::ScaledEquation> equation_in(const collision::MemoryEquation& equation, double unit) {
  if (!(std::isnormal(equation.pot) && std::isfinite(equation.spring))) return std::nullopt;
  return collision::ScaledEquation{unit, equation};
}

double unit_of(const FractionalKelvinVoigt& law, double mass) {
  return unit_of(law.k() / mass + pot_rate_squared(law.c() / mass, 2 - law.alpha()));
}

double unit_of(const FractionalHertz& law, const Impact& impact) {
  const double root = std::sqrt(impact.velocity) / impact.mass_eff;
  return unit_of(std::pow(law.k() * root, 0.8) + std::pow(law.c() * root, 2 / (2.5 - law.alpha())));
}

}  // namespace

namespace collision {

std::optional<Linear> limit_of(const FractionalKelvinVoigt& law) {
  if (law.alpha() == 1) return Linear(law.k(), law.c());
  if (law.alpha() == 0 || law.c() == 0) return Linear(law.k() + (law.alpha() == 0 ? law.c() : 0), 0);
  return std::nullopt;
}

std::optional<Linear> limit_of(const FractionalZener& law, double mass) {
  const double pot = pot_of(law, mass);
  const bool slow = !(pot < std::numeric_limits<double>::max()), fast = !(pot >= std::numeric_limits<double>::min());
  if (law.alpha() != 0 && !slow && !fast) return std::nullopt;
  const double share = law.alpha() == 0 ? 0.5 : slow ? 1 : 0;
  return Linear(law.k() + share * law.k1(), 0);
}

std::optional<KuwabaraKono> limit_of(const FractionalHertz& law, const Impact& impact) {
  if (law.alpha() == 1) return KuwabaraKono(law.k(), 1.5 * law.c());
  const double pot = law.c() * (std::sqrt(impact.velocity) / impact.mass_eff);
  if (law.alpha() == 0 || pot * std::pow(unit_of(law, impact), 2.5 - law.alpha()) < 1e-16)
    return KuwabaraKono(law.k() + (law.alpha() == 0 ? law.c() : 0), 0);
  return std::nullopt;
}

std::optional<SolidMotion> motion_of(const FractionalKelvinVoigt& law, double mass) {
  return motion_in({law.k() / mass, law.c() / mass, 0, law.alpha()}, unit_of(law, mass));
}

std::optional<SolidMotion> motion_of(const FractionalZener& law, double mass) {
  const double k1 = law.k1() / mass, pot = pot_of(law, mass);
  const double unit = unit_of(law.k() / mass + std::min(k1, pot_rate_squared(pot, 2 - law.alpha())));
  return motion_in({law.k() / mass, pot, 1 / k1, law.alpha()}, unit);
}

std::optional<ScaledEquation> equation_of(const FractionalHertz& law, const Impact& impact) {
  const double root = std::sqrt(impact.velocity) / impact.mass_eff, unit = unit_of(law, impact);
  return equation_in(
      {law.k() * root * std::pow(unit, 2.5), law.c() * root * std::pow(unit, 2.5 - law.alpha()), law.alpha(), true},
      unit);
}

}  // namespace collision

Collision collide(const FractionalKelvinVoigt& law, const Impact& impact, const CollideOptions& options) {
  collision::require_impact(impact, options);
  if (const auto limit = collision::limit_of(law)) return collide(*limit, impact, options);
  const double alpha = law.alpha(), m = impact.mass_eff;
  if (options.method == CollideMethod::numerical && options.end == ContactEnd::force) {
    const double unit = unit_of(law, m);
    return by_collocation(
        equation_in({law.k() / m * unit * unit, law.c() / m * std::pow(unit, 2 - alpha), alpha, false}, unit), impact);
  }
  return by_transform(collision::motion_of(law, m), impact, options.end);
}

Collision collide(const FractionalZener& law, const Impact& impact, const CollideOptions& options) {
  collision::require_impact(impact, options);
  if (const auto limit = collision::limit_of(law, impact.mass_eff)) return collide(*limit, impact, options);
  if (options.method == CollideMethod::numerical) return by_arms(law, impact, options);
  return by_transform(collision::motion_of(law, impact.mass_eff), impact, options.end);
}

Collision collide(const FractionalHertz& law, const Impact& impact, const CollideOptions& options) {
  collision::require_impact(impact, options);
  if (options.method == CollideMethod::closed_form)
    throw std::invalid_argument("method = closed_form: the fractional-hertz law has none");
  if (law.force_fades()) return collision::come_to_rest(law, impact, options.breakage_energy);
  if (const auto limit = collision::limit_of(law, impact)) return collide(*limit, impact, options);
  if (options.end == ContactEnd::overlap)
    throw std::invalid_argument("end = overlap: must be force for the law fractional-hertz");
  return by_collocation(collision::equation_of(law, impact), impact);
}

}  // namespace ricochet
