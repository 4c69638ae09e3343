#include <ricochet/contact/fractional.hpp>
#include <ricochet/support/require.hpp>

#include <cmath>

namespace ricochet {

static_assert(ContactLaw<FractionalArms>);

namespace {

/// How an arm's elongation q, q' = ζ' − s q, moves over a step dt along which ζ' is linear:
///   q(dt) = decay·q(0) + gain_before·ζ'(0) + gain_after·ζ'(dt),
/// with x = s dt, gain_before = dt (1 − (1+x)e^{−x})/x², gain_after = dt (x − 1 + e^{−x})/x².
struct Step {
  double decay, gain_before, gain_after;
};

Step step_of(double rate, double dt) noexcept {
  const double x = rate * dt, decay = std::exp(-x);
  if (x >= 0.5) {
    const double scale = dt / (x * x);
    return {decay, scale * (1 - (1 + x) * decay), scale * (x + std::expm1(-x))};
  }
  // gain_after/dt = Σ (−x)^k/(k+2)!, gain_before/dt = Σ (k+1)(−x)^k/(k+2)!: the closed forms would cancel.
  double before = 0, after = 0, term = 0.5;
  for (int k = 0; k < 14; ++k) {
    after += term;
    before += (k + 1) * term;
    term *= -x / (k + 3);
  }
  return {decay, dt * before, dt * after};
}

}  // namespace

FractionalArms::FractionalArms(const Fractional& law, const MemoryKernel& kernel, double step)
    : law_(law), arms_(kernel.arms().size()), step_(step) {
  support::require(kernel.alpha() == law.alpha(), "kernel alpha", kernel.alpha(), "the law's alpha");
  support::require(arms_ <= max_arms, "kernel arms", static_cast<double>(arms_),
                   "at most 24; a larger tolerance or a smaller longest/shortest needs fewer");
  support::require_positive("step", step);
  spring_ = law.coefficient() * kernel.spring();
  dashpot_ = law.coefficient() * kernel.dashpot();
  for (std::size_t j = 0; j < arms_; ++j) {
    stiffness_[j] = law.coefficient() * kernel.arms()[j].strength;
    rate_[j] = kernel.arms()[j].rate;
    const Step s = step_of(rate_[j], step);
    decay_[j] = s.decay;
    gain_before_[j] = s.gain_before;
    gain_after_[j] = s.gain_after;
  }
  step_gain_ = gain_over(step);
}

double FractionalArms::gain_over(double dt) const noexcept {
  Memory memory;
  advance(memory, {0, 0}, {0, 1}, dt);
  return force({0, 1}, memory);
}

double FractionalArms::force(Approach a, const Memory& m) const noexcept {
  double sum = spring_ * a.overlap + dashpot_ * a.rate;
  for (std::size_t j = 0; j < arms_; ++j) sum += stiffness_[j] * m.elongation[j];
  return sum;
}

void FractionalArms::advance(Memory& m, Approach before, Approach after, double dt) const noexcept {
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

double FractionalArms::stored_energy(Approach a, const Memory& m) const noexcept {
  double twice = spring_ * a.overlap * a.overlap;
  for (std::size_t j = 0; j < arms_; ++j) twice += stiffness_[j] * m.elongation[j] * m.elongation[j];
  return 0.5 * twice;
}

double FractionalArms::dissipated_power(Approach a, const Memory& m) const noexcept {
  double power = dashpot_ * a.rate * a.rate;
  for (std::size_t j = 0; j < arms_; ++j) power += stiffness_[j] * rate_[j] * m.elongation[j] * m.elongation[j];
  return power;
}

}  // namespace ricochet
