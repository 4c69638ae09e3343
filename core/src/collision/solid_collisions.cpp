// The laws of real solids.

#include <ricochet/collision/collision.hpp>
#include <ricochet/support/require.hpp>

#include "closed_forms.hpp"
#include "memory_collocation.hpp"
#include "require_impact.hpp"
#include "viscoelastic_collision.hpp"

#include <algorithm>
#include <cmath>

namespace ricochet {
namespace {

/// 1/T² and T of two forces side by side, from the rates of either alone, squared [1/s²].
double unit_of(double rate_squared) { return 1 / std::sqrt(rate_squared); }
double pot_rate_squared(double pot, double power) { return std::pow(pot, 2 / power); }

Collision by_transform(const ViscoelasticModulus& modulus, const Impact& impact, ContactEnd end, double unit) {
  const double pot = modulus.pot * std::pow(unit, 2 - modulus.alpha), square = unit * unit;
  const ViscoelasticModulus scaled{modulus.spring * square, pot, modulus.softness / square, modulus.alpha};
  if (!(std::isnormal(scaled.spring) && std::isnormal(scaled.pot) && std::isfinite(scaled.softness)))
    return {.status = CollisionStatus::out_of_range};
  return collision::in_units(collision::closed_form(ViscoelasticMotion(scaled), end), impact, unit);
}

/// Half steps of the arms, extrapolated: what the generic `collide` does with the law on a kernel. That of 1e-9 from a
/// 400th of the collision on leaves 1e-8, and is made in a tenth of the time of the best.
Collision by_arms(const FractionalZener& law, const Impact& impact, const CollideOptions& options) {
  const Collision known = collide(law, impact, {});
  if (!known.separated()) return known;
  const double step = known.tcol / 400;
  const auto kernel =
      affordable_kernel(law.alpha(), {step, 1.05 * known.tcol, 1e-9}, FractionalZenerArms::max_kernel_arms);
  return collide<FractionalZenerArms>(FractionalZenerArms(law, kernel, step), impact,
                                      {.end = options.end, .max_evaluations = options.max_evaluations});
}

/// Ended by force.
Collision by_collocation(const collision::MemoryEquation& equation, const Impact& impact, double unit) {
  if (!(std::isnormal(equation.pot) && std::isfinite(equation.spring)))
    return {.status = CollisionStatus::out_of_range};
  return collision::in_units(collision::follow_memory(equation), impact, unit);
}

}  // namespace

Collision collide(const FractionalKelvinVoigt& law, const Impact& impact, const CollideOptions& options) {
  collision::require_impact(impact, options);
  const double alpha = law.alpha(), m = impact.mass_eff;
  if (alpha == 1) return collide(Linear(law.k(), law.c()), impact, options);
  if (alpha == 0 || law.c() == 0) return collide(Linear(law.k() + (alpha == 0 ? law.c() : 0), 0), impact, options);
  const double spring = law.k() / m, pot = law.c() / m;
  const double unit = unit_of(spring + pot_rate_squared(pot, 2 - alpha));
  if (options.method == CollideMethod::numerical && options.end == ContactEnd::force)
    return by_collocation({spring * unit * unit, pot * std::pow(unit, 2 - alpha), alpha, false}, impact, unit);
  return by_transform({spring, pot, 0, alpha}, impact, options.end, unit);
}

Collision collide(const FractionalZener& law, const Impact& impact, const CollideOptions& options) {
  collision::require_impact(impact, options);
  const double alpha = law.alpha(), m = impact.mass_eff, k1 = law.k1() / m;
  const double pot = k1 * std::pow(law.tau(), alpha);
  const bool slow = !(pot < std::numeric_limits<double>::max()), fast = !(pot >= std::numeric_limits<double>::min());
  if (alpha == 0 || slow || fast) {
    const double share = alpha == 0 ? 0.5 : slow ? 1 : 0;
    return collide(Linear(law.k() + share * law.k1(), 0), impact, options);
  }
  if (options.method == CollideMethod::numerical) return by_arms(law, impact, options);
  const double unit = unit_of(law.k() / m + std::min(k1, pot_rate_squared(pot, 2 - alpha)));
  return by_transform({law.k() / m, pot, 1 / k1, alpha}, impact, options.end, unit);
}

Collision collide(const FractionalHertz& law, const Impact& impact, const CollideOptions& options) {
  collision::require_impact(impact, options);
  if (options.method == CollideMethod::closed_form)
    throw std::invalid_argument("method = closed_form: the fractional-hertz law has none");
  const double alpha = law.alpha(), root = std::sqrt(impact.velocity) / impact.mass_eff;
  if (law.force_fades()) return collision::come_to_rest(law, impact, options.breakage_energy);
  if (alpha == 1) return collide(KuwabaraKono(law.k(), 1.5 * law.c()), impact, options);
  const double spring = law.k() * root, pot = law.c() * root;
  const double by_spring = std::pow(spring, 0.8), by_pot = std::pow(pot, 2 / (2.5 - alpha));
  const double unit = unit_of(by_spring + by_pot);
  const double share = pot * std::pow(unit, 2.5 - alpha);
  if (alpha == 0 || share < 1e-16)
    return collide(KuwabaraKono(law.k() + (alpha == 0 ? law.c() : 0), 0), impact, options);
  if (options.end == ContactEnd::overlap)
    throw std::invalid_argument("end = overlap: must be force for the law fractional-hertz");
  return by_collocation({spring * std::pow(unit, 2.5), share, alpha, true}, impact, unit);
}

}  // namespace ricochet
