#pragma once

#include <ricochet/collision/collision.hpp>
#include <ricochet/motion/column.hpp>

#include <cmath>
#include <numbers>

// The beads of the paper's Fig. 6 and laws that are near its target (t_col = 1e-4 s): tests of the engine need laws of
// known exact behaviour, not the calibrated ones.
namespace column_cases {

inline constexpr double mass = 1.41e-5, tcol = 1e-4, velocity = -0.5;

/// Linear law of exactly t_col and `en` under ContactEnd::overlap.
inline ricochet::Linear linear(double mass_eff, double en) {
  const double l = std::log(en), pi = std::numbers::pi;
  return {mass_eff * (pi * pi + l * l) / (tcol * tcol), -2 * mass_eff * l / tcol};
}

/// Hysteretic law of exactly t_col and `en`.
inline ricochet::Hysteretic hysteretic(double mass_eff, double en) {
  const double root = std::numbers::pi / 2 * (1 + en) / tcol, k1 = mass_eff * root * root;
  return {k1, k1 / (en * en)};
}

inline ricochet::Tsuji tsuji(double mass_eff) { return {1.2e11 * mass_eff, 1.2e5 * mass_eff}; }
inline ricochet::KuwabaraKono kuwabara_kono(double mass_eff) { return {1.2e11 * mass_eff, 6e5 * mass_eff}; }

/// Fractional law of the given conversion degree with a contact of 100 to 160 µs.
inline ricochet::Fractional fractional(double mass_eff, double alpha) {
  return {1e9 * mass_eff, 1e4 * mass_eff, alpha};
}

inline ricochet::ColumnOptions options(int steps_per_contact, ricochet::ContactEnd end) {
  return {.step = tcol / steps_per_contact, .duration = 10, .end = end};
}

/// E/E0 of equal beads with one kind of law, made for the plate's and the pairs' effective masses.
template <class MakeLaw>
double energy_ratio(int beads, double gap, MakeLaw law, const ricochet::ColumnOptions& o) {
  return ricochet::run_column(ricochet::equal_column(beads, mass, gap, velocity), law(mass), law(mass / 2), o)
      .energy_ratio;
}

}  // namespace column_cases
