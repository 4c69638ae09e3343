#pragma once

#include <ricochet/contact/laws.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet::motion {

/// How steeply a law's force rises with the overlap [N/m] and its rate [N s/m] in a binary collision, at most.
struct Steepest {
  double stiffness, damping;
};

inline Steepest steepest(const Linear& law, double, double) { return {law.k(), law.c()}; }
inline Steepest steepest(const Hysteretic& law, double, double) { return {law.k2(), 0}; }

/// kζ^{3/2} + cζ^p ζ' at a greatest overlap that neither its spring alone, ½mv² = (2/5)kζ^{5/2}, nor its dashpot alone,
/// mv = cζ^{p+1}/(p+1), lets pass.
inline Steepest steepest_hertzian(double k, double c, double p, double mass, double speed) {
  const double by_spring = std::pow(1.25 * mass * speed * speed / k, 0.4);
  const double by_dashpot = c > 0 ? std::pow((p + 1) * mass * speed / c, 1 / (p + 1)) : by_spring;
  const double overlap = std::min(by_spring, by_dashpot);
  return {1.5 * k * std::sqrt(overlap), c * std::pow(overlap, p)};
}
inline Steepest steepest(const KuwabaraKono& law, double mass, double speed) {
  return steepest_hertzian(law.k(), law.c(), 0.5, mass, speed);
}
inline Steepest steepest(const Tsuji& law, double mass, double speed) {
  return steepest_hertzian(law.k(), law.c(), 0.25, mass, speed);
}

/// The time in which a power-law Hertzian contact c D^α ζ^{3/2} alone unfolds, (m/(c√v))^{1/(5/2−α)} [s].
inline double pot_time(const FractionalHertz& law, double mass, double speed) {
  return std::pow(mass / (law.c() * std::sqrt(speed)), 1 / (2.5 - law.alpha()));
}

/// An overlap that neither the spring alone lets pass nor the springpot alone: in v₀ times its time that goes as deep
/// as 1.093 = (5/4)^{2/5} at α = 0, 1 at α = 1, and no deeper than 1.1 in between (tests/motion).
inline double greatest_overlap(const FractionalHertz& law, double mass, double speed) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double by_spring = law.k() > 0 ? std::pow(1.25 * mass * speed * speed / law.k(), 0.4) : infinity;
  const double by_pot = law.c() > 0 ? 1.1 * speed * pot_time(law, mass, speed) : infinity;
  return std::min(by_spring, by_pot);
}

}  // namespace ricochet::motion
