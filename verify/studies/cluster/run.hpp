#pragma once

#include "../paper.hpp"

#include <ricochet/motion/cluster.hpp>

#include <array>
#include <string>
#include <vector>

namespace ricochet::verify::cluster {

/// What a run of Figs. 7–9 chooses: α, and k [kg/s²] and c [kg/s] where they are not the printed ones.
struct Choice {
  double alpha, k = paper::five_spheres.k, c = paper::five_spheres.c;
};

/// The five spheres, mass and geometry as printed.
ClusterSetup five_spheres(Choice choice);

struct Sample {
  double time = 0;
  std::array<Vec3, 5> position, velocity, spin;
};

/// One run and what it is judged by.
struct Run {
  Choice law;
  double step = 0;
  std::vector<Sample> samples;
  std::vector<Encounter> collisions;  ///< ordered by t_b
  double momentum_drift = 0;          ///< greatest |p − p₀|/Σ m|v|
  double angular_drift = 0;           ///< the same of L, in units of Σ m|x||v| at the start
  double energy_drift = 0;            ///< greatest |total − total₀|/total₀
  double energy_growth = 0;           ///< greatest rise of kinetic + stored above its least so far, /total₀
  double kinetic_left = 0;            ///< at the end, of what there was
  double kernel_error = 0;            ///< greatest relative error of the memory kernel
};

Run run(Choice choice, double duration, double step, double sample_interval);

/// "1-2", counted from one as the paper does.
std::string pair_name(const Encounter& e);

/// The collision of spheres i and j, counted from zero; nothing where they do not collide. (Of several the first.)
const Encounter* collision_of(const Run& run, std::uint32_t i, std::uint32_t j);

/// Spin of sphere i in the local frame (1)–(3) of its contact with j: `x` along e_ξ = (−e_y, e_x, 0)/√(e_x²+e_y²), `y`
/// along e_η = e_ζ × e_ξ, `z` along the normal e_ζ (the signs of e_ξ are not legible). What does not hang on the frame
/// is √(ω_ξ²+ω_η²), `tangential`.
Vec3 local_spin(const Sample& sample, std::size_t i, std::size_t j);
double tangential(Vec3 local);

struct LocalSpin {
  double time = 0;
  Vec3 spin;
};
/// At the samples during the collision of i and j; none where they do not collide.
std::vector<LocalSpin> spins_against(const Run& run, std::uint32_t i, std::uint32_t j);
/// Greatest √(ω_ξ²+ω_η²) of these [1/s].
double greatest_tangential(const Run& run, std::uint32_t i, std::uint32_t j);

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
