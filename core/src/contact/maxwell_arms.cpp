#include "lanes.hpp"

#include <ricochet/contact/fractional.hpp>
#include <ricochet/contact/maxwell_arms.hpp>
#include <ricochet/fractional/decay_moments.hpp>
#include <ricochet/support/require.hpp>

#include <cstring>

namespace ricochet {

static_assert(ContactLaw<FractionalArms>);

namespace {

using contact::Pair, contact::pair_at;

/// How an arm's elongation q, q' = ζ' − s q, moves over a step dt along which ζ' is linear:
///   q(dt) = decay·q(0) + gain_before·ζ'(0) + gain_after·ζ'(dt).
struct Step {
  double decay, gain_before, gain_after;
};

Step step_of(double rate, double dt) noexcept {
  const auto m = fractional::decay_moments(rate * dt);
  return {m.decay, dt * m.rising, dt * m.falling};
}

}  // namespace

MaxwellArms::Parts fractional_parts(double coefficient, double alpha, const MemoryKernel& kernel) {
  support::require(kernel.alpha() == alpha, "kernel alpha", kernel.alpha(), "the law's alpha");
  support::require(kernel.arms().size() <= MaxwellArms::max_arms, "kernel arms",
                   static_cast<double>(kernel.arms().size()),
                   "at most 24; a larger tolerance or a smaller longest/shortest needs fewer");
  MaxwellArms::Parts parts{coefficient * kernel.spring(), coefficient * kernel.dashpot(), {}};
  parts.arms.reserve(kernel.arms().size());
  for (const Arm& arm : kernel.arms()) parts.arms.push_back({coefficient * arm.strength, arm.rate});
  return parts;
}

MaxwellArms::MaxwellArms(const Parts& parts, double step)
    : arms_(parts.arms.size()), step_(step), spring_(parts.spring), dashpot_(parts.dashpot) {
  support::require(arms_ <= max_arms, "arms", static_cast<double>(arms_), "at most 24");
  support::require_positive("step", step);
  for (std::size_t j = 0; j < arms_; ++j) {
    stiffness_[j] = parts.arms[j].strength;
    rate_[j] = parts.arms[j].rate;
    const Step s = step_of(rate_[j], step);
    decay_[j] = s.decay;
    gain_before_[j] = s.gain_before;
    gain_after_[j] = s.gain_after;
    held_[j] = stiffness_[j] * s.decay;
    step_gain_before_ += stiffness_[j] * s.gain_before;
  }
  step_gain_ = gain_over(step);
}

double MaxwellArms::gain_over(double dt) const noexcept {
  Memory memory;
  advance(memory, {0, 0}, {0, 1}, dt);
  return force({0, 1}, memory);
}

double MaxwellArms::force(Approach a, const Memory& m) const noexcept {
  double sum = spring_ * a.overlap + dashpot_ * a.rate;
  for (std::size_t j = 0; j < arms_; ++j) sum += stiffness_[j] * m.elongation[j];
  return sum;
}

// Two pairs at a time, or it is bound by the latency of one sum; arms past the last are 0.
double MaxwellArms::force_after(Approach before, Approach after, const Memory& m) const noexcept {
  static_assert(max_arms % 4 == 0);
  Pair one{}, other{};
  for (std::size_t j = 0; j < arms_; j += 4) {
    one += pair_at(&held_[j]) * pair_at(&m.elongation[j]);
    other += pair_at(&held_[j + 2]) * pair_at(&m.elongation[j + 2]);
  }
  const Pair sum = one + other;
  return spring_ * after.overlap + step_gain_ * after.rate + step_gain_before_ * before.rate + (sum[0] + sum[1]);
}

void MaxwellArms::advance(Memory& m, Approach before, Approach after, double dt) const noexcept {
  if (dt == step_) {
    for (std::size_t j = 0; j < arms_; ++j)
      m.elongation[j] = decay_[j] * m.elongation[j] + gain_before_[j] * before.rate + gain_after_[j] * after.rate;
    return;
  }
  for (std::size_t j = 0; j < arms_; ++j) {
    const Step s = step_of(rate_[j], dt);
    m.elongation[j] = s.decay * m.elongation[j] + s.gain_before * before.rate + s.gain_after * after.rate;
  }
}

double MaxwellArms::stored_energy(Approach a, const Memory& m) const noexcept {
  double twice = spring_ * a.overlap * a.overlap;
  for (std::size_t j = 0; j < arms_; ++j) twice += stiffness_[j] * m.elongation[j] * m.elongation[j];
  return 0.5 * twice;
}

double MaxwellArms::dissipated_power(Approach a, const Memory& m) const noexcept {
  double power = dashpot_ * a.rate * a.rate;
  for (std::size_t j = 0; j < arms_; ++j) power += stiffness_[j] * rate_[j] * m.elongation[j] * m.elongation[j];
  return power;
}

// Even and odd arms apart, so that two go at a time (left to itself g++ parts them); those past the last stay 0. What
// stands beside the arms comes last: a pair made of two numbers goes through memory in halves, which is slow.
MaxwellArms::Reading MaxwellArms::advance_and_read(Memory& m, Approach before, Approach after) const noexcept {
  Pair force{}, twice{}, power{};
  for (std::size_t j = 0; j < arms_; j += 2) {
    double* const place = &m.elongation[j];
    const Pair q = pair_at(&decay_[j]) * pair_at(place) + pair_at(&gain_before_[j]) * before.rate +
                   pair_at(&gain_after_[j]) * after.rate;
    std::memcpy(place, &q, sizeof q);
    const Pair pull = pair_at(&stiffness_[j]) * q, energy = pull * q;
    force += pull, twice += energy, power += pair_at(&rate_[j]) * energy;
  }
  const double elastic = spring_ * after.overlap, viscous = dashpot_ * after.rate;
  return {elastic + viscous + (force[0] + force[1]), 0.5 * (elastic * after.overlap + (twice[0] + twice[1])),
          viscous * after.rate + (power[0] + power[1])};
}

}  // namespace ricochet
