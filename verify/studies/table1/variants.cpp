#include "variants.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace ricochet::verify::table1 {

namespace {

struct State {
  double overlap, rate;
};

State operator+(State a, State b) { return {a.overlap + b.overlap, a.rate + b.rate}; }
State operator*(double factor, State s) { return {factor * s.overlap, factor * s.rate}; }

class Motion {
 public:
  Motion(Held held, const Fractional& law, const Impact& impact, double step)
      : held_(held),
        law_(law),
        step_(step),
        scale_(law.coefficient() / std::tgamma(2 - law.alpha())),
        mass_(impact.mass_eff),
        state_{0, impact.velocity} {}

  void advance(Stepper stepper) {
    const double h = step_;
    const State first = slope(0, state_);
    State rise{};
    if (stepper == Stepper::heun) {
      rise = 0.5 * (first + slope(h, state_ + h * first));
    } else {
      const State second = slope(h / 2, state_ + h / 2 * first), third = slope(h / 2, state_ + h / 2 * second);
      rise = 1.0 / 6 * (first + 2 * (second + third) + slope(h, state_ + h * third));
    }
    const State next = state_ + h * rise;
    rates_.push_back(held(h, next));
    state_ = next;
  }
  Instant now() const {
    return {step_ * static_cast<double>(rates_.size()), state_.overlap, state_.rate, force(0, state_)};
  }

 private:
  /// The rate that stands for the part of a step up to `then`, `since` its start.
  double held(double since, State then) const {
    switch (held_) {
      case Held::left: return state_.rate;
      case Held::mean: return 0.5 * (state_.rate + then.rate);
      case Held::chord: return (then.overlap - state_.overlap) / since;
    }
    return 0;
  }
  /// (59) at `since` the end of the last whole step.
  double force(double since, State then) const {
    const double power = 1 - law_.alpha();
    const auto n = rates_.size();
    double sum = since > 0 ? held(since, then) * std::pow(since, power) : 0;
    for (std::size_t l = 0; l < n; ++l)
      sum += rates_[l] * (std::pow(since + step_ * static_cast<double>(n - l), power) -
                          std::pow(since + step_ * static_cast<double>(n - l - 1), power));
    return scale_ * sum;
  }
  State slope(double since, State then) const { return {then.rate, -force(since, then) / mass_}; }

  Held held_;
  Fractional law_;
  double step_, scale_, mass_;
  State state_;
  std::vector<double> rates_;
};

}  // namespace

std::string name(Variant variant) {
  constexpr std::array held{"left values", "step means", "chords"};
  return std::string(held[static_cast<std::size_t>(variant.held)]) +
         (variant.stepper == Stepper::heun ? ", Heun" : ", RK4");
}

Instant end_of(Variant variant, const Fractional& law, const Impact& impact, double time, int steps) {
  Motion motion(variant.held, law, impact, time / steps);
  for (int n = 0; n < steps; ++n) motion.advance(variant.stepper);
  return motion.now();
}

}  // namespace ricochet::verify::table1
