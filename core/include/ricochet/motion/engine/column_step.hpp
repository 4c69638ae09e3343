#pragma once

// One step of ColumnEngine where no contact starts or ends, free flight, and when a run is over.

#include <ricochet/motion/engine/column_engine.hpp>

namespace ricochet {

template <ContactLaw Law>
ColumnEngine<Law>::ColumnEngine(const Column& column, const Law& plate, const Law& pair, const ColumnOptions& options)
    : beads_(column.mass.size()),
      step_(options.step),
      gravity_(column.gravity),
      repulsive_(options.end == ContactEnd::force),
      silent_(repulsive_ && options.reclosing == Reclosing::silent),
      energy_(options.energy),
      laws_{plate, pair},
      kind_(beads_ + 2, 1),
      memory_(laws_, kind_, options.step) {
  motion::check(column);
  support::require_positive("step", step_);
  support::require_positive("negligible_approach", options.negligible_approach);
  kind_[0] = kind_[1] = 0;
  for (auto* array : {&mass_, &inverse_mass_, &velocity_, &old_velocity_, &overlap_, &old_overlap_, &mean_, &old_mean_,
                      &guess_, &next_guess_, &applied_, &moment_, &begin_, &stored_})
    array->assign(beads_ + 2, 0.0);
  for (auto* array : {&state_, &pressing_, &by_difference_}) array->assign(beads_ + 2, 0);
  event_of_.assign(beads_ + 2, 0);
  events_.reserve(beads_ + 2);
  for (std::size_t i = 0; i < beads_; ++i) {
    mass_[i + 1] = column.mass[i];
    inverse_mass_[i + 1] = 1 / column.mass[i];
    velocity_[i + 1] = column.velocity[i];
    overlap_[i + 1] = -column.gap[i];
    negligible_rate_ = std::max(negligible_rate_, options.negligible_approach * std::abs(column.velocity[i]));
  }
}

template <ContactLaw Law>
void ColumnEngine<Law>::step() noexcept {
  std::swap(mean_, old_mean_);
  std::swap(guess_, next_guess_);
  predict();
  if (!events_.empty()) resolve_events();
  move();
  if (!events_.empty()) move_by_moments();
  if (energy_) account_before();
  remember();
  if (!events_.empty()) close_events();
  if (energy_) account_after();
  time_ += step_;
}

/// The change of overlap j over the step when every contact gives the force expected of it.
template <ContactLaw Law>
double ColumnEngine<Law>::predicted_rise(std::size_t j) const noexcept {
  const double below = guess_[j - 1], own = guess_[j], above = guess_[j + 1];
  const double acceleration = (below - own) * inverse_mass_[j - 1] - (own - above) * inverse_mass_[j] + fall(j);
  return step_ * (rate(j) + 0.5 * step_ * acceleration);
}

template <ContactLaw Law>
void ColumnEngine<Law>::predict() noexcept {
  const double per_step = 1 / step_;
  double below = 0, own = guess_[1], lower_velocity = 0, lower_inverse_mass = 0, free_fall = gravity_;
  for (std::size_t j = 1; j <= beads_; ++j) {
    const double above = guess_[j + 1], velocity = velocity_[j], inverse_mass = inverse_mass_[j];
    const double acceleration = (below - own) * lower_inverse_mass - (own - above) * inverse_mass + free_fall;
    const double rise = step_ * (lower_velocity - velocity + 0.5 * step_ * acceleration);
    below = own, own = above, lower_velocity = velocity, lower_inverse_mass = inverse_mass, free_fall = 0;
    const bool ends_overlapping = overlap_[j] + rise > 0;
    if (state_[j] == touching && ends_overlapping) [[likely]] {
      const double mean = memory_.step_mean(j, overlap_[j], rise * per_step);
      mean_[j] = mean;
      next_guess_[j] = predicted(2 * mean - old_mean_[j]);
      applied_[j] = clamp(j, mean, old_mean_[j], step_);
    } else {
      mean_[j] = next_guess_[j] = applied_[j] = 0;
      if ((state_[j] == apart) == ends_overlapping) add_event(j, 0, state_[j] == apart);
    }
  }
}

/// The mean of max(0, F) over a span in which F is linear, with the mean `mean` there and `before` over an equally long
/// span before: F = (mean + before)/2 at the start, (3 mean − before)/2 at the end.
template <ContactLaw Law>
double ColumnEngine<Law>::clamp(std::size_t j, double mean, double before, double span) noexcept {
  if (!repulsive_) return mean;
  const double first = 0.5 * (mean + before), last = mean + 0.5 * (mean - before);
  if (first >= 0 && last >= 0) [[likely]] {
    pressing_[j] = 1;
    return mean;
  }
  if (first <= 0 && last <= 0) {
    if (pressing_[j]) stop_pressing(j, time_);
    return 0;
  }
  if (first > 0) {
    const double share = first / (first - last);
    stop_pressing(j, time_ + share * span);
    return 0.5 * first * share;
  }
  pressing_[j] = 1;
  return 0.5 * last * last / (last - first);
}

template <ContactLaw Law>
void ColumnEngine<Law>::stop_pressing(std::size_t j, double when) noexcept {
  pressing_[j] = 0;
  if (silent_) state_[j] = released;
  last_contact_time_ = when - begin_[j];
}

template <ContactLaw Law>
void ColumnEngine<Law>::move() noexcept {
  std::swap(velocity_, old_velocity_);
  std::swap(overlap_, old_overlap_);
  const double half = 0.5 * step_;
  double lower = 0;
  for (std::size_t i = 1; i <= beads_; ++i) {
    const double old = old_velocity_[i];
    const double now = old + step_ * ((applied_[i] - applied_[i + 1]) * inverse_mass_[i] - gravity_);
    const double sum = old + now;
    velocity_[i] = now;
    overlap_[i] = old_overlap_[i] + half * (lower - sum);
    lower = sum;
  }
}

template <ContactLaw Law>
void ColumnEngine<Law>::remember() noexcept {
  using Bank = motion::ColumnMemory<Law>;
  const auto goes_on = [this](std::size_t j) { return state_[j] == touching && !event_of_[j]; };
  if constexpr (motion::StepsInBlocks<Bank>) {
    for (std::size_t first = 1; first <= beads_; ++first) {
      if (!goes_on(first)) continue;
      std::size_t last = first + 1;
      while (last <= beads_ && kind_[last] == kind_[first] && goes_on(last)) ++last;
      memory_.advance_steps(first, last, old_overlap_.data(), overlap_.data());
      first = last - 1;
    }
  } else if constexpr (Bank::remembers) {
    for (std::size_t j = 1; j <= beads_; ++j)
      if (goes_on(j))
        memory_.advance(j, {old_overlap_[j], old_velocity_[j - 1] - old_velocity_[j]}, {overlap_[j], rate(j)}, step_);
  }
}

template <ContactLaw Law>
void ColumnEngine<Law>::skip_free_flight() noexcept {
  if (active_ > 0 || gravity_ > 0) return;
  double flight = -1;
  for (std::size_t j = 1; j <= beads_; ++j)
    if (rate(j) > 0) {  // however slow: a jump must not carry a bead into its neighbour
      const double until = -overlap_[j] / rate(j);
      flight = flight < 0 ? until : std::min(flight, until);
    }
  flight -= 0.5 * step_;  // not a whole step: rounding would decide in which step the contact starts
  if (flight <= 0) return;
  for (std::size_t j = 1; j <= beads_; ++j) overlap_[j] += flight * rate(j);
  time_ += flight;
}

template <ContactLaw Law>
bool ColumnEngine<Law>::finished() const noexcept {
  if (gravity_ > 0) return false;
  for (std::size_t j = 1; j <= beads_; ++j) {
    if (!(rate(j) <= negligible_rate_)) return false;
    if (state_[j] == apart) continue;
    if (!repulsive_ || mean_[j] > 0 || memory_.may_wake(j, {overlap_[j], rate(j)})) return false;
  }
  return true;
}

template <ContactLaw Law>
bool ColumnEngine<Law>::finite() const noexcept {
  for (std::size_t j = 1; j <= beads_; ++j)
    if (!std::isfinite(velocity_[j]) || !std::isfinite(overlap_[j])) return false;
  return std::isfinite(time_);
}

template <ContactLaw Law>
bool ColumnEngine<Law>::resting() const noexcept {
  for (std::size_t j = 1; j <= beads_; ++j)
    if (state_[j] != apart && rate(j) >= -negligible_rate_) return true;
  return false;
}

}  // namespace ricochet
