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

namespace {

// (57) knows the damping: it tends to 2m/c as α → 1.
double pot_alone(double coefficient, double alpha) {
  if (coefficient == 0) return std::numeric_limits<double>::infinity();
  return alpha < 1 ? tcol_estimate(coefficient, alpha) : 2 / coefficient;
}

// Of two forces side by side, from the times with either alone: exact for two springs.
double together(double one, double other) {
  const double a = 1 / one, b = 1 / other;
  return 1 / std::sqrt(a * a + b * b);
}

}  // namespace

double resolved_time(const Fractional& law, double mass, double) {
  return pot_alone(law.coefficient() / mass, law.alpha());
}
double resolved_time(const FractionalKelvinVoigt& law, double mass, double) {
  return together(pi * std::sqrt(mass / law.k()), pot_alone(law.c() / mass, law.alpha()));
}
// The arm is no stiffer than its spring alone or its springpot alone.
double resolved_time(const FractionalZener& law, double mass, double) {
  const double pot = law.k1() * std::pow(law.tau(), law.alpha());
  return std::max(pi * std::sqrt(mass / (law.k() + law.k1())),
                  together(pi * std::sqrt(mass / law.k()), pot_alone(pot / mass, law.alpha())));
}
// The springpot alone takes 3.2 of its time at α = 0, 2.7 at 1/2; at α = 1 the velocity is gone within some of it.
double resolved_time(const FractionalHertz& law, double mass, double speed) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (!(speed > 0)) return infinity;
  const double by_spring = law.k() > 0 ? hertz(law.k(), mass, speed) : infinity;
  return together(by_spring, law.c() > 0 ? 2.7 * pot_time(law, mass, speed) : infinity);
}

}  // namespace ricochet::motion
