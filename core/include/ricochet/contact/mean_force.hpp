#pragma once

#include <ricochet/contact/fractional_hertz.hpp>
#include <ricochet/contact/hysteretic.hpp>
#include <ricochet/contact/maxwell_arms.hpp>
#include <ricochet/contact/power_law.hpp>

namespace ricochet {

// The mean [N] of a law's signed force over dt [s] while the overlap goes linearly from `overlap` to overlap + rate·dt.
//
// Why a mean and not a value: an integrator needs the contact's impulse. A force that starts with a jump (dashpot) or
// like t^{1−α} (fractional) has an impulse that is smooth in the overlap although the force is not smooth in time, so
// means keep a scheme of second order where end-point values cannot. `memory` is that at the interval's beginning.
// Exact for the laws below; a law without an overload of its own gets the midpoint's force, of second order.

template <ContactLaw Law>
double mean_force(const Law& law, double overlap, double rate, const typename Law::Memory& memory, double dt) noexcept {
  auto halfway = memory;
  const Approach middle{overlap + 0.5 * rate * dt, rate};
  law.advance(halfway, {overlap, rate}, middle, 0.5 * dt);
  return law.force(middle, halfway);
}

template <class Form>
double mean_force(const PowerLaw<Form>& law, double overlap, double rate, const NoMemory&, double dt) noexcept {
  return law.mean_force(overlap, rate, dt);
}

/// Piecewise linear in the overlap: the trapezoid on either side of the greatest overlap so far.
inline double mean_force(const Hysteretic& law, double overlap, double rate, const Hysteretic::Memory& memory,
                         double dt) noexcept {
  const double end = overlap + rate * dt, bend = memory.max_overlap;
  const double low = std::min(overlap, end), high = std::max(overlap, end);
  const double at_low = law.force({low, rate}, memory), at_high = law.force({high, rate}, memory);
  if (bend <= low || bend >= high) return 0.5 * (at_low + at_high);
  const double below = (bend - low) / (high - low), at_bend = law.k1() * bend;
  return 0.5 * (below * (at_low + at_bend) + (1 - below) * (at_bend + at_high));
}

/// How a Maxwell arm q' = ζ' − s q goes through dt at a constant ζ', with x = s dt:
///   q(dt) = decay·q(0) + gain·ζ',   mean of q = mean_before·q(0) + mean_gain·ζ',
/// decay = e^{−x}, mean_before = φ₁ = (1 − e^{−x})/x, gain = dt φ₁, mean_gain = dt φ₂ = dt (1 − φ₁)/x; to rounding
/// (fractional/decay_moments.hpp).
struct SteadyArm {
  double decay, gain, mean_before, mean_gain;
};
SteadyArm steady_arm(double relaxation_rate, double dt) noexcept;

namespace contact {
double mean_force(const MaxwellArms& arms, double overlap, double rate, const MaxwellArms::Memory& memory,
                  double dt) noexcept;
}  // namespace contact

template <ArmsLaw Law>
double mean_force(const Law& law, double overlap, double rate, const typename Law::Memory& memory, double dt) noexcept {
  return contact::mean_force(static_cast<const MaxwellArms&>(law), overlap, rate, memory, dt);
}

inline double mean_force(const FractionalHertzArms& law, double overlap, double rate,
                         const FractionalHertzArms::Memory& memory, double dt) noexcept {
  return law.mean_force(overlap, rate, memory, dt);
}

}  // namespace ricochet
