#pragma once

#include <ricochet/collision/collision.hpp>

#include <array>
#include <cmath>
#include <numbers>

/// The cases that J. S. Leszczynski, Phys. Rev. E 70, 051315 (2004) prints, SI units. Where data/ holds the same
/// numbers (paper.csv, which says where each stands, table1.csv, table2.csv, the scenes), a test compares the two.
namespace ricochet::verify::paper {

/// Fig. 2 and Table I: a steel sphere that meets a plate. Its density reads 7850 or 7680 kg/m³.
struct SteelSphere {
  double radius = 3e-3;
  double density = 7850, other_density = 7680;
  double velocity = 1;
  double k = 4615380, c = 128.1, alpha = 0.2;
  double tcol = 38.6e-6;                                       ///< rounded; Table I ends at the unrounded one
  double tcol_estimate = 37.8e-6;                              ///< by (57)
  double last_digit = 0.1e-6;                                  ///< of the two times
  double last_digit_velocity = 1e-5, last_digit_force = 1e-5;  ///< of Table I
  double last_digit_dt = 0.01e-7;                              ///< of its steps' length, 77.20e-7 s for the longest

  /// With the plate, which does not move: the sphere's mass.
  static constexpr double mass_eff(double density, double radius) {
    return density * 4 / 3 * std::numbers::pi * radius * radius * radius;
  }
  constexpr Impact impact(double of_density) const {
    return {.velocity = velocity, .mass_eff = mass_eff(of_density, radius)};
  }
};
inline constexpr SteelSphere steel;

/// The number of steps a contact that the paper settles for, by a scheme whose errors fall like those of order 2.
inline constexpr int steps = 30;

/// Table II and Figs. 3–5: two equal spheres.
struct Pair {
  double radius = 1.5e-3, density = 1000;
  Impact impact{.velocity = 0.5, .mass_eff = 7.06858e-6};
  double tcol = 1e-4, en = 0.5;  ///< that every law of Table II is made for
};
inline constexpr Pair pair;

/// The coefficients of Table II; those of the laws without one are zero.
struct Table2 {
  struct LinearLaw {
    double k, c;
  } linear1{7316, 0.0979}, linear2{5225, 0.0981}, nonlinear{1392000, 33.885};
  struct {
    double k1, k2;
  } hysteretic{3924, 15697};
  struct {
    double k, c, alpha;
  } fractional{5225, 0.297, 0.3197};
};
inline constexpr Table2 table2;

/// Figs. 3 and 4: the fractional law of one k and c for the pair above.
inline constexpr double alpha_study_k = 5000, alpha_study_c = 0.1;
/// The conversion degrees of their right group, and for how long Fig. 3 shows it [s]; the other ones are not legible.
inline constexpr std::array no_rebound_degrees{1.0, 1.3, 1.6};
inline constexpr double no_rebound_shown = 0.5e-3;

/// The number of (57) whose exponent is not legible.
inline constexpr double estimate_factor = 1.641;

/// Fig. 6: beads stacked over a plate, all falling at one velocity; every contact has the same t_col and e_n.
struct FallingColumn {
  double bead_mass = 1.41e-5, velocity = 0.5;
  double gap = 1e-6;  ///< under each bead; not legible, about this
  double en = 0.945, tcol = 1e-4;
  double alpha = 0.0258;  ///< of the curve with constant α
  std::size_t most = 20;  ///< beads
};
inline constexpr FallingColumn column;

/// Figs. 7–9 (Sec. IV, text before Fig. 7): sphere 1 falls onto four at rest.
struct FiveSpheres {
  struct Ball {
    double radius, density;
    std::array<double, 3> position;
    double velocity_z = 0;
  };
  std::array<Ball, 5> balls{{{0.02, 2000, {0, 0.1, 0.23}, -5},
                             {0.01, 2000, {0.001, 0.125, 0.205}},
                             {0.007, 1000, {-0.002, 0.090, 0.198}},
                             {0.005, 1000, {-0.004, 0.120, 0.186}},
                             {0.009, 1000, {-0.001, 0.1, 0.18}}}};
  double k = 1000, c = 1;
  double strong_alpha = 0.01, weak_alpha = 0.97;
  double mu_static = 0.5, mu_dynamic = 0.5, decay = 0, rolling_arm = 1;
  /// Fig. 9 prints durations beside its bars; those that can be read (the first ends in 8 or so), and its axis [s].
  std::array<double, 4> durations{1.108e-3, 1.125e-3, 0.48e-3, 0.20e-3};
  double sequence_axis = 7e-3;
};
inline constexpr FiveSpheres five_spheres;

}  // namespace ricochet::verify::paper
