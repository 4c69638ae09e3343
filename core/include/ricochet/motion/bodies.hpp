#pragma once

#include <ricochet/contact/tangential.hpp>
#include <ricochet/motion/normal_law.hpp>
#include <ricochet/motion/periodic.hpp>
#include <ricochet/motion/wall.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <utility>
#include <vector>

namespace ricochet {

/// A homogeneous sphere: mass (4/3)πr³ρ, moment of inertia (2/5)mr².
struct Sphere {
  double radius = 0;   ///< [m]
  double density = 0;  ///< [kg/m³]
  Vec3 position{};     ///< [m]
  Vec3 velocity{};     ///< [m/s]
  Vec3 spin{};         ///< ω [1/s]
  std::size_t material = 0;

  double mass() const noexcept;     ///< [kg]
  double inertia() const noexcept;  ///< [kg m²]
};

/// How two materials meet.
struct Interaction {
  NormalLaw law;  ///< any ContactLaw, one of your own too
  Friction friction{};
  ContactEnd end = ContactEnd::force;
  /// What a contact can take up [J], ≥ 0: one that ends by (26) and has taken up as much is noted as broken; the bodies
  /// themselves stay whole.
  double breakage_energy = std::numeric_limits<double>::infinity();
  TangentialLaw tangential = RigidTangential{};
  Torsion torsion{};  ///< of a compliant tangential law; the rigid one has the disc's (36), (44)
  Rolling rolling{};  ///< its springs are those of a compliant tangential law; `friction` has the arm ρ
};

/// Interactions by pair of materials, (a, b) with a ≤ b.
using Interactions = std::map<std::pair<std::size_t, std::size_t>, Interaction>;

/// Other forces: adds to `forces` [N] at `time` [s] what acts on each sphere at `positions`.
using LongRangeForce = std::function<void(double time, std::span<const Vec3> positions, std::span<Vec3> forces)>;

/// Everything that a cluster of particles is made of, at time 0.
struct ClusterSetup {
  std::vector<Sphere> spheres;
  std::vector<Wall> walls;
  Interactions interactions;
  Vec3 gravity{};  ///< [m/s²]
  LongRangeForce long_range;
  /// Periods are more than four of the greatest radius, skins included, and walls the same along a periodic axis.
  Periodic periodic{};
  std::vector<Sphere> later{};  ///< that Cluster::add may bring; only their materials count
};

/// Whether a wall is the same all along each periodic axis: a plane or a cylinder along it. A finite one would have to
/// be there in every cell.
bool same_along(const Wall& wall, const Periodic& periodic) noexcept;

/// Masses and speed of the stiffest meeting of a setup.
struct StiffestContact {
  std::size_t i = 0, j = 0;  ///< bodies; walls count from spheres.size()
  double tcol = 0;          ///< about how long it lasts, the time that a step has to resolve [s]; 0 if nothing can meet
  bool tangential = false;  ///< that time is half a period of the tangential spring
};

/// The pair whose binary collision lasts shortest, over all pairs of spheres and walls (grouped by size and material,
/// so linear in their number while these are few). Impact velocity: the fastest that two bodies of the setup approach
/// each other, gravity having acted over the greatest radius. Durations: (57) for the fractional law, for the others
/// that without damping, or ten damping times m/c where these are shorter (in the Hertzian laws cζ^p for c, at a ζ that
/// neither spring nor dashpot would let pass): an overdamped contact is over long before its spring has swung. For a
/// law of your own π m v over its greatest force. A compliant tangential law counts where it swings faster: π
/// √(m_t/k_t), m_t = (2/7) m, Mindlin's k_t at the overlap v t_col/π.
StiffestContact stiffest_contact(const ClusterSetup& setup);

/// Throws std::invalid_argument naming the sphere by its number and what is wrong: a radius or density that is not
/// finite and positive, a number that is not finite.
void check(const Sphere& sphere, std::size_t number);

/// Throws std::invalid_argument naming what is wrong: a radius, density or number that is not finite or not positive, a
/// wall as check(Wall) has it, or not the same along a periodic axis, a limit without a spring, or a pair of materials
/// that can meet and has no interaction.
void check(const ClusterSetup& setup);

}  // namespace ricochet
