// The paths of the laws of real solids.

#include <ricochet/collision/oblique.hpp>

#include "../solid_motion.hpp"
#include "clock_path.hpp"

#include <memory>
#include <stdexcept>

namespace ricochet::collision {
namespace {

/// By the transforms of a linear motion, in the units of an impact.
struct LinearInstant {
  SolidMotion solid;
  double velocity, mass;

  NormalInstant operator()(const GradedClock::Reading& clock, bool) const {
    const double t = clock.time / solid.unit, force = mass * velocity / solid.unit;
    return {.overlap = velocity * solid.unit * solid.motion.overlap(t),
            .rate = velocity * solid.motion.rate(t),
            .force = force * solid.motion.force(t),
            .slope = force / solid.unit * solid.motion.force_slope(t)};
  }
};

/// By the panels of a collocation.
struct HertzianInstant {
  MemoryMotion motion;
  double unit, velocity, mass;

  NormalInstant operator()(const GradedClock::Reading& clock, bool) const {
    const MemoryMotion::Instant now = motion.at(clock.time / unit);
    const double force = mass * velocity / unit;
    return {.overlap = velocity * unit * now.overlap,
            .rate = velocity * now.rate,
            .force = force * now.force,
            .slope = force / unit * now.slope};
  }
};

template <class Law>
std::shared_ptr<const NormalPath> linear_path(const Law& law, const Impact& impact, const Collision& by_force) {
  const LinearInstant motion{motion_of(law, impact.mass_eff).value(), impact.velocity, impact.mass_eff};
  return std::make_shared<ClockPath<LinearInstant>>(motion, by_force, impact.velocity);
}

}  // namespace

std::shared_ptr<const NormalPath> normal_path(const FractionalKelvinVoigt& law, const Impact& impact,
                                              const Collision& by_force) {
  if (const auto limit = limit_of(law)) return normal_path(*limit, impact, by_force);
  return linear_path(law, impact, by_force);
}

std::shared_ptr<const NormalPath> normal_path(const FractionalZener& law, const Impact& impact,
                                              const Collision& by_force) {
  if (const auto limit = limit_of(law, impact.mass_eff)) return normal_path(*limit, impact, by_force);
  return linear_path(law, impact, by_force);
}

std::shared_ptr<const NormalPath> normal_path(const FractionalHertz& law, const Impact& impact,
                                              const Collision& by_force) {
  if (const auto limit = limit_of(law, impact)) return normal_path(*limit, impact, by_force);
  const ScaledEquation scaled = equation_of(law, impact).value();
  const HertzianInstant motion{MemoryMotion(scaled.equation), scaled.unit, impact.velocity, impact.mass_eff};
  return std::make_shared<ClockPath<HertzianInstant>>(motion, by_force, impact.velocity);
}

}  // namespace ricochet::collision
