#pragma once

#include <ricochet/contact/fractional.hpp>

#include <array>
#include <cstddef>

namespace ricochet::liggghts {

/// One contact under the fractional law (30) with unit coefficient (c^α k^{1−α} = 1), driven as a velocity-Verlet
/// engine drives it: once a step, with the overlap ζ_n at the step's end and the rate of half a step before,
///   ζ'_{n−1/2} = (ζ_n − ζ_{n−1})/dt.
/// Memory is kinematic: a pair of grains multiplies the result by its own coefficient, so that one object serves all
/// pairs of two materials whatever their masses.
///
/// Scheme (derivation in docs/liggghts.md), second order in dt for the velocity, the overlap and the force:
/// - the rate at the step's end is extrapolated from the last three half-step rates; the arms are stepped exactly for
///   the rate that is linear over the step, has this end and the exact mean (ζ_n − ζ_{n−1})/dt;
/// - a contact starts at t_b = t_n − θ dt, θ = ζ_n/(ζ'_{n−1/2} dt). The force rises as (t − t_b)^{1−α}, which the sum
///   of the engine's kicks integrates to order 2 − α only; the first kick carries the missing part (see start_weight);
/// - a force that is about to fall through zero within the next step ends in the same way, as a straight line.
///
/// What a contact remembers is `size` doubles, all zero before the first touch, in the engine's own history: they
/// migrate and are written to restart files by the engine.
class HalfStepContact {
 public:
  static constexpr std::size_t arm_slots = 12;
  static constexpr std::size_t size = 5 + arm_slots;
  /// History as an engine sees it: step of the last touch plus one (0: never), ζ there, the half-step rates before it
  /// (the older one 0: not known yet), D^α ζ there, arms.
  enum Slot : std::size_t { stamp, overlap, rate, older_rate, force, arms };

  /// 0 ≤ alpha < 1; dt [s] > 0; memory [s] ≥ dt: a contact that lasts longer is carried on by the kernel's spring.
  /// Throws std::invalid_argument otherwise.
  HalfStepContact(double alpha, double dt, double memory);

  double alpha() const noexcept { return law_.law().alpha(); }
  std::size_t arm_count() const noexcept { return law_.arms(); }
  double kernel_error() const noexcept { return kernel_.error(); }

  /// Whether `history` holds a touch at the step before `step` (continuing) or at `step` itself.
  static bool continues(const double* history, double step) noexcept { return history[stamp] == step; }
  static bool is_at(const double* history, double step) noexcept { return history[stamp] == step + 1; }

  /// Steps the contact to the end of step number `step` ≥ 1, ζ = `now` [m] > 0, ζ' = `half_step_rate` half a step
  /// before. A history that was not touched in the step before is stale (the grains have been apart) and starts anew.
  void advance(double* history, double step, double now, double half_step_rate, double dt) const noexcept;

  /// max(0, D^α ζ) [m s^{−α}] at the last touch.
  static double repulsion(const double* history) noexcept { return history[force] > 0 ? history[force] : 0; }

  /// Energy that the springs hold [m² s^{−α}], per unit coefficient, while the contact repels; else 0.
  double stored_energy(const double* history) const noexcept;
  /// Energy lost [m² s^{−α}] over the step of length dt between two states of one contact, per unit coefficient: what
  /// the dashpots burn, by the trapezoid; what the springs still hold when repulsion ends is lost there. The work of
  /// the repulsion is this plus the change of stored_energy, to order 2 − α over a contact (the power starts as
  /// (t − t_b)^{1−α}).
  double dissipated_energy(const double* before, const double* after, double dt) const noexcept;

 private:
  void start(double* history, double now, double half_step_rate, double dt) const noexcept;
  void go_on(double* history, double now, double dt) const noexcept;
  double step_otherwise(double* history, Approach before, Approach after, double dt) const noexcept;
  FractionalArms::Memory memory_of(const double* history) const noexcept;

  MemoryKernel kernel_;
  FractionalArms law_;
};

/// Weight w(θ) of the first kick after a touch that lies θ of a step back, 0 < θ ≤ 1: a force (t − t_b)^p, summed as
/// dt Σ_{k≥0} F((k + θ) dt) with w(θ) dt^p in place of the first F, has no start error of order 1 + p.
/// w(θ) = −ζ(−p, 1+θ), the Hurwitz zeta function, by Euler–Maclaurin; |error| < 1e-7 for 0 ≤ p ≤ 1.
/// Source: I. Navot, J. Math. and Phys. 40, 271 (1961).
double start_weight(double p, double theta) noexcept;

// The hot path, called for every contact and step.

namespace half_step {

/// The rate half a step after the last of equally spaced ones.
inline double rate_at_end(double last, double before, double oldest) noexcept {
  return oldest == 0 ? 1.5 * last - 0.5 * before : 1.875 * last - 1.25 * before + 0.375 * oldest;
}

/// A force that its last change would carry through zero within the next step is the first of a ramp, seen backwards
/// from its end: start_weight(1, θ), with θ of a step to go, in place of θ.
inline double last_weighted(double force, double previous) noexcept {
  const double fall = previous - force;
  if (force <= 0 || force >= fall) return force;
  const double theta = force / fall;
  return fall * (theta * theta + theta + 1. / 6) / 2;
}

}  // namespace half_step

inline void HalfStepContact::advance(double* history, double step, double now, double half_step_rate,
                                     double dt) const noexcept {
  if (continues(history, step))
    go_on(history, now, dt);
  else
    start(history, now, half_step_rate, dt);
  history[stamp] = step + 1;
  history[overlap] = now;
}

inline void HalfStepContact::go_on(double* history, double now, double dt) const noexcept {
  const double mean = (now - history[overlap]) / dt;
  const double end = half_step::rate_at_end(mean, history[rate], history[older_rate]);
  const Approach before{history[overlap], 2 * mean - end}, after{now, end};
  const double force_now = dt == law_.step() ? law_.advance_step<arm_slots>(history + arms, before, after)
                                             : step_otherwise(history, before, after, dt);
  history[older_rate] = history[rate];
  history[rate] = mean;
  history[force] = half_step::last_weighted(force_now, history[force]);
}

}  // namespace ricochet::liggghts
