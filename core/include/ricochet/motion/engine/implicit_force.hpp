#pragma once

#include <ricochet/contact/fractional_hertz.hpp>
#include <ricochet/contact/hysteretic.hpp>
#include <ricochet/contact/maxwell_arms.hpp>
#include <ricochet/contact/power_law.hpp>

#include <cmath>
#include <concepts>

namespace ricochet::motion {

// The signed force at the end of `dt` [s], over which the rate goes linearly to a value that is not known yet:
//   R(ζ') = force + slope (ζ' − at.rate),
// with the overlap held at `at.overlap` and the memory brought from `before` to there. An implicit step solves this
// line for the rate. `mobility` is 1/m_i + 1/m_j [1/kg], by which the force changes the rate.
//
// Exact for the laws below, which are affine in the rate. For any other law the slope is the central difference over
// 1/1000 of the rate and of what the force makes of it over dt; the rest is of second order in dt, and so remains the
// step that solves the line.

struct AffineForce {
  double force;  ///< [N]
  double slope;  ///< [N s/m]
};

/// A law whose memory moves as those of MaxwellArms: none that stretches its arms in another way.
template <class Law>
concept MovesAsArms = requires {
  { &Law::advance } -> std::same_as<decltype(&MaxwellArms::advance)>;
  { &Law::force } -> std::same_as<decltype(&MaxwellArms::force)>;
  { &Law::stored_energy } -> std::same_as<decltype(&MaxwellArms::stored_energy)>;
  { &Law::dissipated_power } -> std::same_as<decltype(&MaxwellArms::dissipated_power)>;
};

/// The force of a law whose memory, then at `before`, has gone to `at` within dt.
template <ContactLaw Law>
double force_after(const Law& law, Approach before, Approach at, typename Law::Memory memory, double dt) noexcept {
  law.advance(memory, before, at, dt);
  return law.force(at, memory);
}

template <ContactLaw Law>
AffineForce implicit_force(const Law& law, Approach before, Approach at, const typename Law::Memory& memory, double dt,
                           double mobility) noexcept {
  const double force = force_after(law, before, at, memory, dt);
  const double nudge = 1e-3 * (std::abs(at.rate) + mobility * std::abs(force) * dt);
  if (!(nudge > 0)) return {force, 0};
  const double up = force_after(law, before, {at.overlap, at.rate + nudge}, memory, dt);
  const double down = force_after(law, before, {at.overlap, at.rate - nudge}, memory, dt);
  return {force, (up - down) / (2 * nudge)};
}

/// kζ^P + cζ^Q ζ': the slope is what a rate of 1 m/s adds.
template <class Form>
AffineForce implicit_force(const PowerLaw<Form>& law, Approach, Approach at, const NoMemory& memory, double,
                           double) noexcept {
  return {law.force(at, memory), law.force({at.overlap, 1}, memory) - law.force({at.overlap, 0}, memory)};
}

inline AffineForce implicit_force(const Hysteretic& law, Approach before, Approach at, const Hysteretic::Memory& memory,
                                  double dt, double) noexcept {
  return {force_after(law, before, at, memory, dt), 0};
}

template <ArmsLaw Law>
AffineForce implicit_force(const Law& law, Approach before, Approach at, const typename Law::Memory& memory, double dt,
                           double) noexcept {
  if constexpr (MovesAsArms<Law>)
    if (dt == law.step()) return {law.force_after(before, at, memory), law.rate_gain(dt)};
  return {force_after(law, before, at, memory, dt), law.rate_gain(dt)};
}

inline AffineForce implicit_force(const FractionalHertzArms& law, Approach before, Approach at,
                                  const FractionalHertzArms::Memory& memory, double dt, double) noexcept {
  return {force_after(law, before, at, memory, dt), law.rate_gain(dt, at.overlap)};
}

/// Whether the slope of a law is the same in every contact.
template <class Law>
inline constexpr bool constant_slope = false;
template <>
inline constexpr bool constant_slope<Linear> = true;
template <>
inline constexpr bool constant_slope<Hysteretic> = true;
template <ArmsLaw Law>
inline constexpr bool constant_slope<Law> = true;
template <>
inline constexpr bool constant_slope<FractionalHertzArms> = false;

}  // namespace ricochet::motion
