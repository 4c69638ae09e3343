#include <ricochet/motion/resolved_time.hpp>

#include "steepest.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/scale_and_loss.hpp>

#include <algorithm>

namespace ricochet::motion {
namespace {

using std::numbers::pi;

// How long a binary collision of the law lasts without its damping.
double duration(const Linear& law, double mass, double) { return pi * std::sqrt(mass / law.k()); }
double duration(const Hysteretic& law, double mass, double) { return pi * std::sqrt(mass / law.k2()); }
double hertz(double k, double mass, double speed) {
  return speed > 0 ? hertz_time(k, {.velocity = speed, .mass_eff = mass}) : std::numeric_limits<double>::infinity();
}
double duration(const KuwabaraKono& law, double mass, double speed) { return hertz(law.k(), mass, speed); }
double duration(const Tsuji& law, double mass, double speed) { return hertz(law.k(), mass, speed); }

// A dashpot eats the velocity within m/c. Past a damping ratio of 5/π that is so fast that ten of it are shorter than
// the undamped collision; the true one then lasts 4 ln(2β) m/c in the linear law, 5 to 20 of them for β up to 100.
template <class Law>
double damped(const Law& law, double mass, double speed) {
  const double undamped = duration(law, mass, speed), damping = steepest(law, mass, speed).damping;
  return damping > 0 ? std::min(undamped, 10 * mass / damping) : undamped;
}

}  // namespace

double resolved_time(const Linear& law, double mass, double speed) { return damped(law, mass, speed); }
double resolved_time(const KuwabaraKono& law, double mass, double speed) { return damped(law, mass, speed); }
double resolved_time(const Tsuji& law, double mass, double speed) { return damped(law, mass, speed); }
double resolved_time(const Hysteretic& law, double mass, double speed) { return damped(law, mass, speed); }
// (57) knows the damping: it tends to 2m/c as α → 1.
double resolved_time(const Fractional& law, double mass, double) {
  const double coefficient = law.coefficient() / mass;
  return law.alpha() < 1 ? tcol_estimate(coefficient, law.alpha()) : 2 / coefficient;
}

}  // namespace ricochet::motion
