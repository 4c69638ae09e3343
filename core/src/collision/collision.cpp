#include <ricochet/support/require.hpp>
#include <ricochet/collision/collision.hpp>

#include "closed_forms.hpp"
#include "numerical_collision.hpp"
#include "require_impact.hpp"

#include <stdexcept>

namespace ricochet {
namespace {

using collision::require_impact;

template <class Motion, class Law>
Collision integrate(const Law& law, const Impact& impact, const CollideOptions& options) {
  const double unit = collision::time_unit<Motion>(law.k(), impact.velocity, impact.mass_eff);
  const Motion scaled{collision::damping_group<Motion>(law.c(), impact.velocity, impact.mass_eff, unit)};
  // Past this the ratio of the greatest force to those near its end, γ⁴, leaves the range of a double.
  if (!(scaled.gamma <= 1e100)) return {.status = CollisionStatus::out_of_range};
  return collision::in_units(collision::follow(scaled, options), impact, unit);
}

Collision integrate(const Hysteretic& law, const Impact& impact, const CollideOptions& options) {
  const double unit = std::sqrt(impact.mass_eff / law.k1());
  const double stiffening = law.k2() / law.k1();
  if (!std::isfinite(stiffening)) return {.status = CollisionStatus::out_of_range};
  return collision::in_units(collision::follow_hysteretic(stiffening, options), impact, unit);
}

void require_numerical(const CollideOptions& options, const char* law) {
  if (options.method == CollideMethod::closed_form)
    throw std::invalid_argument(std::string("method = closed_form: the ") + law + " law has none");
}

}  // namespace

Collision collide(const Linear& law, const Impact& impact, const CollideOptions& options) {
  require_impact(impact, options);
  if (options.method != CollideMethod::numerical) return collision::closed_form(law, impact, options.end);
  return integrate<collision::LinearMotion>(law, impact, options);
}

Collision collide(const KuwabaraKono& law, const Impact& impact, const CollideOptions& options) {
  require_impact(impact, options);
  require_numerical(options, "Kuwabara-Kono");
  return integrate<collision::KuwabaraKonoMotion>(law, impact, options);
}

Collision collide(const Tsuji& law, const Impact& impact, const CollideOptions& options) {
  require_impact(impact, options);
  require_numerical(options, "Tsuji");
  return integrate<collision::TsujiMotion>(law, impact, options);
}

Collision collide(const Hysteretic& law, const Impact& impact, const CollideOptions& options) {
  require_impact(impact, options);
  if (options.method != CollideMethod::numerical) return collision::closed_form(law, impact, options.end);
  return integrate(law, impact, options);
}

Collision collide(const Fractional& law, const Impact& impact, const CollideOptions& options) {
  require_impact(impact, options);
  support::require(law.alpha() >= -1, "alpha", law.alpha(), "in [-1, 2) for a collision");
  if (law.force_fades()) return collision::come_to_rest(law, impact, options.breakage_energy);
  if (options.method == CollideMethod::numerical) return collision::follow_fractional(law, impact, options.end);
  return collision::closed_form(law, impact, options.end);
}

}  // namespace ricochet
