#pragma once

#include "first_touch.hpp"

#include <array>
#include <cstddef>

namespace ricochet::half_step {

/// A contact that lasts longer than this many steps is carried on by the kernel's spring, unless its user says more.
inline constexpr double default_memory_steps = 1e3;

/// What a contact remembers: `size` doubles, all zero before the first touch, in the engine's own history. They migrate
/// and are written to restart files by the engine.
struct ContactHistory {
  static constexpr std::size_t arm_slots = 12;
  static constexpr std::size_t size = 5 + arm_slots;
  /// History as an engine sees it: step of the last touch plus one (0: never), ζ there, the half-step rates before it
  /// (the older one 0: not known yet), the law's force there, arms.
  enum Slot : std::size_t { stamp, overlap, rate, older_rate, force, arms };

  /// Whether `history` holds a touch at the step before `step` (continuing) or at `step` itself.
  static bool continues(const double* history, double step) noexcept { return history[stamp] == step; }
  static bool is_at(const double* history, double step) noexcept { return history[stamp] == step + 1; }

  /// The force at the last touch where it repels, else 0.
  static double repulsion(const double* history) noexcept { return history[force] > 0 ? history[force] : 0; }
};

/// One contact under a law with a fractional memory, driven as a velocity-Verlet engine drives it: once a step, with
/// the overlap ζ_n at the step's end and the rate of half a step before,
///   ζ'_{n−1/2} = (ζ_n − ζ_{n−1})/dt.
/// Law: Fractional, FractionalKelvinVoigt, FractionalHertz, FractionalZener. What it remembers is kinematic: a pair of
/// grains may multiply the result by its own coefficient, so that one object serves all pairs whose laws differ by a
/// factor.
///
/// Scheme (derivation in docs/liggghts.md), second order in dt for the velocity, the overlap and the force:
/// - the rate at the step's end is extrapolated from the last three half-step rates; the arms are stepped exactly for
///   what stretches them (ζ, or ζ^{3/2}) having a rate that is linear over the step, has this end and the exact mean;
/// - a contact starts at t_b = t_n − θ dt, θ = ζ_n/(ζ'_{n−1/2} dt). There the force rises as a broken power of the
///   time, which the sum of the engine's kicks integrates to a low order only; the first kick carries the missing part
///   (see first_touch.hpp);
/// - a force that is about to fall through zero within the next step ends in the same way, as a straight line.
template <class Law>
class LocatedContact : public ContactHistory {
 public:
  using Arms = typename Law::Arms;

  /// dt [s] > 0; memory [s] ≥ dt: a contact that lasts longer is carried on by the kernel's spring. Throws
  /// std::invalid_argument otherwise, and for a law whose force only fades or that gains energy.
  LocatedContact(const Law& law, double dt, double memory);

  /// With a kernel that was made before, of at most `arm_slots` arms (fractional-zener: one less). Throws
  /// std::invalid_argument for one of another α.
  LocatedContact(const Law& law, const MemoryKernel& kernel, double dt)
      : kernel_error_(kernel.error()), arms_law_(law, kernel, dt) {}

  const Law& law() const noexcept { return arms_law_.law(); }
  std::size_t arm_count() const noexcept { return arms_law_.arms(); }
  double kernel_error() const noexcept { return kernel_error_; }

  /// Steps the contact to the end of step number `step` ≥ 1, ζ = `now` [m] > 0, ζ' = `half_step_rate` half a step
  /// before. A history that was not touched in the step before is stale (the grains have been apart) and starts anew.
  void advance(double* history, double step, double now, double half_step_rate, double dt) const noexcept;

  /// Energy that the springs hold [J] while the contact repels; else 0.
  double stored_energy(const double* history) const noexcept;
  /// Energy lost [J] over the step of length dt between two states of one contact: what the dashpots burn, by the
  /// trapezoid; what the springs still hold when repulsion ends is lost there. The work of the repulsion is this plus
  /// the change of stored_energy, to order 2 − α over a contact (the power starts as (t − t_b)^{1−α}).
  double dissipated_energy(const double* before, const double* after, double dt) const noexcept;

 private:
  static Approach stretched(Approach a) noexcept {
    if constexpr (requires { Arms::stretched(a); }) return Arms::stretched(a);
    return a;
  }
  void start(double* history, double now, double half_step_rate, double dt) const noexcept;
  void go_on(double* history, double now, double dt) const noexcept;
  double step_otherwise(double* history, Approach before, Approach after, double dt) const noexcept;
  typename Arms::Memory memory_of(const double* history) const noexcept;

  double kernel_error_ = 0;
  Arms arms_law_;
};

/// The fractional law (30) with unit coefficient, c^α k^{1−α} = 1: `repulsion` is max(0, D^α ζ) [m s^{−α}].
class HalfStepContact : public LocatedContact<Fractional> {
 public:
  /// 0 ≤ alpha < 1.
  HalfStepContact(double alpha, double dt, double memory) : LocatedContact(Fractional(1, 1, alpha), dt, memory) {}

  double alpha() const noexcept { return law().alpha(); }
};

extern template class LocatedContact<Fractional>;
extern template class LocatedContact<FractionalKelvinVoigt>;
extern template class LocatedContact<FractionalHertz>;
extern template class LocatedContact<FractionalZener>;

// The hot path, called for every contact and step.

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

template <class Law>
inline void LocatedContact<Law>::advance(double* history, double step, double now, double half_step_rate,
                                         double dt) const noexcept {
  if (continues(history, step))
    go_on(history, now, dt);
  else
    start(history, now, half_step_rate, dt);
  history[stamp] = step + 1;
  history[overlap] = now;
}

template <class Law>
inline void LocatedContact<Law>::go_on(double* history, double now, double dt) const noexcept {
  const double mean = (now - history[overlap]) / dt;
  const double end = rate_at_end(mean, history[rate], history[older_rate]);
  const double from = stretched({history[overlap], 0}).overlap;
  const Approach after = stretched({now, end});
  const Approach before{from, 2 * ((after.overlap - from) / dt) - after.rate};
  const double force_now = dt == arms_law_.step()
                               ? arms_law_.template advance_step<arm_slots>(history + arms, before, after)
                               : step_otherwise(history, before, after, dt);
  history[older_rate] = history[rate];
  history[rate] = mean;
  history[force] = last_weighted(force_now, history[force]);
}

}  // namespace ricochet::half_step
