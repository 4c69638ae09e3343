// The laws of real solids under a constant load.

#include <ricochet/collision/loaded.hpp>
#include <ricochet/support/require.hpp>

#include "closed_forms.hpp"
#include "loaded_motion.hpp"
#include "solid_motion.hpp"
#include "viscoelastic_collision.hpp"

#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <numbers>

namespace ricochet {
namespace {

/// y + p ∫y, y the motion without the load p, and R = p − x''.
class LoadedMotion {
 public:
  LoadedMotion(const ViscoelasticMotion& motion, double load) : motion_(motion), load_(load) {}

  double overlap(double t) const {
    return motion_.overlap(t) + load_ * boost::math::quadrature::gauss<double, 30>::integrate(
                                            [&](double s) { return motion_.overlap(s); }, 0.0, t);
  }
  double rate(double t) const { return motion_.rate(t) + load_ * motion_.overlap(t); }
  double force(double t) const { return motion_.force(t) + load_ * (1 - motion_.rate(t)); }

 private:
  const ViscoelasticMotion& motion_;
  double load_;
};

double in_units_of(const Impact& impact, double load, double unit) {
  return load * unit / (impact.mass_eff * impact.velocity);
}

void require_arguments(const Impact& impact, double load) {
  support::require_positive("velocity", impact.velocity);
  support::require_positive("mass_eff", impact.mass_eff);
  collision::require_load(load);
}

Collision superposed(const std::optional<collision::SolidMotion>& solid, const Impact& impact, double load) {
  if (!solid) return {.status = CollisionStatus::out_of_range};
  const Collision free = collision::closed_form(solid->motion, ContactEnd::force);
  if (!free.separated()) return free;
  const LoadedMotion motion(solid->motion, in_units_of(impact, load, solid->unit));
  // A springpot brings the zero forward, so that a dip may be longer than what comes before it.
  const double half_period = std::numbers::pi / solid->motion.pole().imag();
  const double dip = 1.2 * std::max(free.tcol, half_period);
  return collision::in_units(collision::follow_loaded(motion, free.tcol, dip), impact, solid->unit);
}

}  // namespace

Collision collide_under_load(const FractionalKelvinVoigt& law, const Impact& impact, double load,
                             const CollideOptions& options) {
  require_arguments(impact, load);
  if (const auto limit = collision::limit_of(law)) return collide_under_load(*limit, impact, load, options);
  return superposed(collision::motion_of(law, impact.mass_eff), impact, load);
}

Collision collide_under_load(const FractionalZener& law, const Impact& impact, double load,
                             const CollideOptions& options) {
  require_arguments(impact, load);
  if (const auto limit = collision::limit_of(law, impact.mass_eff))
    return collide_under_load(*limit, impact, load, options);
  return superposed(collision::motion_of(law, impact.mass_eff), impact, load);
}

Collision collide_under_load(const FractionalHertz& law, const Impact& impact, double load,
                             const CollideOptions& options) {
  require_arguments(impact, load);
  if (law.force_fades()) return {};
  if (const auto limit = collision::limit_of(law, impact)) return collide_under_load(*limit, impact, load, options);
  const auto scaled = collision::equation_of(law, impact);
  if (!scaled) return {.status = CollisionStatus::out_of_range};
  collision::MemoryEquation equation = scaled->equation;
  equation.load = in_units_of(impact, load, scaled->unit);
  return collision::in_units(collision::follow_memory(equation), impact, scaled->unit);
}

}  // namespace ricochet
