#pragma once

// What ColumnEngine does about contacts that start or end inside the step.

#include <ricochet/motion/engine/column_engine.hpp>

namespace ricochet {

template <ContactLaw Law>
void ColumnEngine<Law>::add_event(std::size_t j, double active, bool start) noexcept {
  events_.push_back({j, active, start});
  event_of_[j] = static_cast<std::uint32_t>(events_.size());
}

/// Contacts that start or end inside the step bend the overlaps of their neighbours: settle them together. Two rounds,
/// as an event among the neighbours of an event is itself a correction of the second order.
template <ContactLaw Law>
void ColumnEngine<Law>::resolve_events() noexcept {
  for (int round = 0; round < 2; ++round)
    for (std::size_t e = 0; e < events_.size(); ++e) {
      const std::size_t j = events_[e].contact;
      visit(j);
      if (j > 1) visit(j - 1);
      if (j < beads_) visit(j + 1);
    }
}

/// First moment of contact j's impulse beyond what `predicted_rise` took it for; not 0 for events alone.
template <ContactLaw Law>
double ColumnEngine<Law>::excess(std::size_t j) const noexcept {
  return event_of_[j] ? moment_[j] + 0.5 * step_ * step_ * (applied_[j] - guess_[j]) : 0.0;
}

template <ContactLaw Law>
void ColumnEngine<Law>::visit(std::size_t j) noexcept {
  const double rise = predicted_rise(j) + excess(j - 1) * inverse_mass_[j - 1] + excess(j + 1) * inverse_mass_[j];
  const bool ends_overlapping = overlap_[j] + rise > 0;
  if (!event_of_[j]) {
    if (state_[j] == touching && ends_overlapping) {
      mean_[j] = memory_.step_mean(j, overlap_[j], rise / step_);
      next_guess_[j] = predicted(2 * mean_[j] - old_mean_[j]);
      applied_[j] = clamp(j, mean_[j], old_mean_[j], step_);
      return;
    }
    if ((state_[j] == apart) != ends_overlapping) return;
    add_event(j, 0, state_[j] == apart);
  }
  events_[event_of_[j] - 1].start ? visit_start(j, rise) : visit_end(j, rise);
}

/// ζ(s) = ζ + ζ's + ½as² from the step's start; the contact acts from the zero of ζ on.
template <ContactLaw Law>
void ColumnEngine<Law>::visit_start(std::size_t j, double rise) noexcept {
  const double gap = -overlap_[j], r = rate(j), a = 2 * (rise / step_ - r) / step_;
  const double root = r + std::sqrt(std::max(0.0, r * r + 2 * a * gap));
  const double wait = gap > 0 ? std::min(root > 0 ? 2 * gap / root : step_, step_) : 0.0;
  const double span = step_ - wait, first = std::max(0.0, overlap_[j]);
  double mean_rate = r + 0.5 * a * (wait + step_);
  // The contact's own push slows its overlap: once is enough, as the push is of the order of the span.
  const double push = predicted(memory_.mean(j, first, mean_rate, span));
  mean_rate -= 0.5 * push * span * (inverse_mass_[j - 1] + inverse_mass_[j]);
  mean_[j] = memory_.mean(j, first, mean_rate, span);
  next_guess_[j] = predicted(mean_[j]);
  applied_[j] = next_guess_[j] * span / step_;
  moment_[j] = -0.5 * applied_[j] * step_ * wait;
  events_[event_of_[j] - 1].active = span;
}

/// The contact acts up to the zero of ζ; thereafter its force, which may have been attractive, is gone.
template <ContactLaw Law>
void ColumnEngine<Law>::visit_end(std::size_t j, double rise) noexcept {
  const double overlap = std::max(0.0, overlap_[j]), r = rate(j), a = 2 * (rise / step_ - r) / step_;
  const double root = -r + std::sqrt(std::max(0.0, r * r - 2 * a * overlap));
  const double span = overlap > 0 ? std::min(root > 0 ? 2 * overlap / root : step_, step_) : 0.0;
  mean_[j] = state_[j] == released ? 0.0 : memory_.mean(j, overlap, r + 0.5 * a * span, span);
  applied_[j] = clamp(j, mean_[j], old_mean_[j], span) * span / step_;
  moment_[j] = 0.5 * applied_[j] * step_ * (step_ - span);
  events_[event_of_[j] - 1].active = span;
}

template <ContactLaw Law>
void ColumnEngine<Law>::move_by_moments() noexcept {
  for (const Event& e : events_) {
    const std::size_t j = e.contact;
    const double down = moment_[j] * inverse_mass_[j - 1], up = moment_[j] * inverse_mass_[j];
    overlap_[j] -= down + up;
    overlap_[j - 1] += down;
    overlap_[j + 1] += up;
  }
  overlap_[0] = overlap_[beads_ + 1] = 0;
}

template <ContactLaw Law>
void ColumnEngine<Law>::close_events() noexcept {
  for (const Event& e : events_) {
    const std::size_t j = e.contact;
    memory_.reset(j);
    if (e.start) {
      state_[j] = touching;
      pressing_[j] = 1;
      begin_[j] = time_ + step_ - e.active;
      memory_.advance(j, {0, overlap_[j] / std::max(e.active, 1e-300)}, {overlap_[j], rate(j)}, e.active);
      ++active_, ++contacts_;
    } else {
      if (pressing_[j]) stop_pressing(j, time_ + e.active);
      state_[j] = apart;
      mean_[j] = 0;
      --active_;
    }
    moment_[j] = 0;
    event_of_[j] = 0;
  }
  events_.clear();
}

}  // namespace ricochet
