#pragma once

// The books of ColumnEngine on what contacts store and burn.

#include <ricochet/motion/engine/column_engine.hpp>

namespace ricochet {

template <ContactLaw Law>
double ColumnEngine<Law>::stored(std::size_t j) const noexcept {
  if (state_[j] != touching) return 0;
  const Approach at{overlap_[j], rate(j)};
  const Law& law = memory_.law(j);
  const auto memory = memory_.memory(j);
  const double held = law.stored_energy(at, memory);
  if (!repulsive_ || (pressing_[j] && law.force(at, memory) > 0)) return held;
  // Bodies that part under a force held at zero would stretch the springs of a law without doing work on them: no more
  // is stored than was and than the impulse has put in.
  return std::clamp(stored_[j] + applied_[j] * (overlap_[j] - old_overlap_[j]), 0.0, held);
}

/// What each contact burns in this step: one that acts all through it burns its power (midpoint); one that starts, ends
/// or is held at zero force burns its work less the change of its store.
template <ContactLaw Law>
void ColumnEngine<Law>::account_before() noexcept {
  for (std::size_t j = 1; j <= beads_; ++j) {
    const double rise = overlap_[j] - old_overlap_[j], mean_rate = rise / step_;
    by_difference_[j] = event_of_[j] || state_[j] == released || (state_[j] == touching && applied_[j] != mean_[j]);
    if (by_difference_[j]) {
      const Event* e = event_of_[j] ? &events_[event_of_[j] - 1] : nullptr;
      const double part = e ? step_ / std::max(e->active, 1e-300) : 1.0;
      const double path = e ? (e->start ? overlap_[j] : -std::max(0.0, old_overlap_[j])) : rise;
      dissipated_ += applied_[j] * part * path + stored_[j];
    } else if (state_[j] == touching) {
      // Gauss's three points: right after a start the power of some laws grows like a root.
      constexpr std::array<double, 3> point{0.1127016653792583, 0.5, 0.8872983346207417},
          weight{5. / 18, 8. / 18, 5. / 18};
      const Law& law = memory_.law(j);
      for (int p = 0; p < 3; ++p) {
        auto then = memory_.memory(j);
        const Approach before{old_overlap_[j], mean_rate}, at{old_overlap_[j] + point[p] * rise, mean_rate};
        law.advance(then, before, at, point[p] * step_);
        dissipated_ += weight[p] * step_ * law.dissipated_power(at, then);
      }
    }
  }
}

template <ContactLaw Law>
void ColumnEngine<Law>::account_after() noexcept {
  for (std::size_t j = 1; j <= beads_; ++j) {
    stored_[j] = stored(j);
    if (by_difference_[j]) dissipated_ -= stored_[j];
  }
}

template <ContactLaw Law>
ColumnEnergy ColumnEngine<Law>::energy() const noexcept {
  ColumnEnergy sum;
  double height = 0;
  for (std::size_t j = 1; j <= beads_; ++j) {
    height -= overlap_[j];
    sum.kinetic += 0.5 * mass_[j] * velocity_[j] * velocity_[j];
    sum.potential += mass_[j] * gravity_ * height;
    sum.stored += stored_[j];
  }
  sum.dissipated = dissipated_;
  return sum;
}

}  // namespace ricochet
