// The path of a motion that is known in time: hysteretic and fractional in closed form.

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/oblique.hpp>

#include "clock_path.hpp"

#include <cmath>

namespace ricochet::collision {
namespace {

/// Two springs: ζ = (v₀/w₁) sin w₁t up to the turn, and ζ₀ + (R_max/k₂) sin w₂(t_col − t) from there.
struct HystereticMotion {
  double velocity, mass, k1, k2;

  NormalInstant operator()(const GradedClock::Reading& clock, bool loading) const {
    const double k = loading ? k1 : k2, w = std::sqrt(k / mass);
    const double reach = velocity * std::sqrt(mass * k1) / k;  // of the spring, R_max/k
    const double angle = w * (loading ? clock.time : clock.rest), way = loading ? 1 : -1;
    const double spring = reach * std::sin(angle), rate = way * reach * w * std::cos(angle);
    const double rest = loading ? 0 : velocity * std::sqrt(mass / k1) * (1 - k1 / k2);
    return {.overlap = rest + spring, .rate = rate, .force = k * spring, .slope = k * rate};
  }
};

/// Eqs. (47)–(56), and dR/dt = m A v₀ t^{−α} E_{a,1−α}(−A t^a), the series of R term by term.
struct FractionalInstant {
  FractionalTrajectory motion;
  MittagLeffler slope;
  double alpha, rate, amplitude;  // A [s^{−a}], m A v₀

  NormalInstant operator()(const GradedClock::Reading& clock, bool) const {
    const double t = clock.time;
    const double growth = amplitude * std::pow(t, -alpha) * slope(-rate * std::pow(t, 2 - alpha));
    return {.overlap = motion.overlap(t), .rate = motion.rate(t), .force = motion.force(t), .slope = growth};
  }
};

}  // namespace

std::shared_ptr<const NormalPath> normal_path(const Hysteretic& law, const Impact& impact, const Collision& by_force) {
  const HystereticMotion motion{impact.velocity, impact.mass_eff, law.k1(), law.k2()};
  return std::make_shared<ClockPath<HystereticMotion>>(motion, by_force, impact.velocity);
}

std::shared_ptr<const NormalPath> normal_path(const Fractional& law, const Impact& impact, const Collision& by_force) {
  const double m = impact.mass_eff, v = impact.velocity, a = 2 - law.alpha();
  const FractionalInstant motion{FractionalTrajectory(law.coefficient(), law.alpha(), m, v), MittagLeffler(a, a - 1),
                                 law.alpha(), law.coefficient() / m, law.coefficient() * v};
  return std::make_shared<ClockPath<FractionalInstant>>(motion, by_force, impact.velocity);
}

}  // namespace ricochet::collision
