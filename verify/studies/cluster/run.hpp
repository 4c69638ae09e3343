#pragma once

#include <ricochet/motion/cluster.hpp>

#include <array>
#include <string>
#include <vector>

namespace ricochet::verify::cluster {

/// The five spheres of Figs. 7–9, mass and geometry as printed; α and k to choose.
ClusterSetup five_spheres(double alpha, double k);

struct Sample {
  double time = 0;
  std::array<Vec3, 5> position, velocity, spin;
};

/// One run and what it is judged by.
struct Run {
  double alpha, k, step;
  std::vector<Sample> samples;
  std::vector<Encounter> collisions;  ///< ordered by t_b
  double momentum_drift = 0;          ///< greatest |p − p₀|/Σ m|v|
  double angular_drift = 0;           ///< the same of L, in units of Σ m|x||v| at the start
  double energy_drift = 0;            ///< greatest |total − total₀|/total₀
  double energy_growth = 0;           ///< greatest rise of kinetic + stored above its least so far, /total₀
  double kinetic_left = 0;            ///< at the end, of what there was
};

Run run(double alpha, double k, double duration, double step, double sample_interval);

/// "1-2", counted from one as the paper does.
std::string pair_name(const Encounter& e);

/// How collisions share the time: from t_b to t_e of every pair.
struct Overlap {
  double mean_duration = 0;  ///< of a collision [s]
  double busy = 0;           ///< time during which any pair collides [s]
  double shared = 0;         ///< part of it during which more than one does
  double mean_pairs = 0;     ///< pairs colliding at once, averaged over the busy time
  int most_pairs = 0;        ///< at once
};
Overlap overlap(const std::vector<Encounter>& collisions, double until);

}  // namespace ricochet::verify::cluster
