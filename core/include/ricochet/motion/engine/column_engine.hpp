#pragma once

#include <ricochet/support/require.hpp>
#include <ricochet/motion/column.hpp>
#include <ricochet/motion/engine/column_arms.hpp>
#include <ricochet/motion/engine/column_memory.hpp>

#include <array>
#include <cmath>

namespace ricochet {

/// Steps a column whose contacts follow one kind of law. Derivation and proof of order: docs/theory/column.md.
///
/// Unknowns are the beads' velocities and the contacts' overlaps (negative: a gap). One step of length h:
/// 1. the overlap at the step's end is predicted from the mean forces of the two steps before;
/// 2. each contact gives its impulse over the step along that overlap (`mean_force`), clamped where the law is only
///    repulsive; a contact that starts or ends inside the step gives it over its active part alone, with the first
///    moment that this part has;
/// 3. impulses change the velocities, velocities (trapezoid) and the moments change the overlaps;
/// 4. memories advance along the new overlap at its mean rate.
/// Second order in h for every law of the model, starts and ends of contact included. No allocation in `step`.
///
/// Indices: the plate is body 0, bead i of the Column is body i+1; contact j lies between bodies j−1 and j. Arrays have
/// a spare entry at either end, which stays 0, in place of special cases.
template <ContactLaw Law>
class ColumnEngine {
 public:
  /// Throws std::invalid_argument for a Column or options out of range (see column.hpp).
  ColumnEngine(const Column& column, const Law& plate, const Law& pair, const ColumnOptions& options);
  ColumnEngine(const ColumnEngine&) = delete;
  ColumnEngine& operator=(const ColumnEngine&) = delete;

  void step() noexcept;
  /// Jumps a free flight to shortly before its end, if nothing touches and there is no gravity.
  void skip_free_flight() noexcept;
  /// Whether no further force can act; see ColumnEnd. Linear in the beads.
  bool finished() const noexcept;
  /// Whether all velocities and overlaps are; else the step was too large. Linear in the beads.
  bool finite() const noexcept;
  bool any_contact() const noexcept { return active_ > 0; }
  /// Whether bodies overlap that do not move apart.
  bool resting() const noexcept;

  std::size_t beads() const noexcept { return beads_; }
  double time() const noexcept { return time_; }
  double velocity(std::size_t bead) const noexcept { return velocity_[bead + 1]; }
  double overlap(std::size_t bead) const noexcept { return overlap_[bead + 1]; }  ///< under that bead [m]
  std::size_t contacts() const noexcept { return contacts_; }
  double last_contact_time() const noexcept { return last_contact_time_; }
  ColumnEnergy energy() const noexcept;

 private:
  enum State : std::uint8_t { apart, touching, released };  // released: Reclosing::silent, without force until apart
  struct Event {
    std::size_t contact;
    double active;  // part of the step in which the contact acts [s]
    bool start;
  };

  double rate(std::size_t j) const noexcept { return velocity_[j - 1] - velocity_[j]; }
  double fall(std::size_t j) const noexcept { return j == 1 ? gravity_ : 0.0; }
  double predicted(double mean) const noexcept { return repulsive_ ? std::max(0.0, mean) : mean; }
  double predicted_rise(std::size_t j) const noexcept;
  double clamp(std::size_t j, double mean, double before, double span) noexcept;
  void predict() noexcept;
  void resolve_events() noexcept;
  void visit(std::size_t j) noexcept;
  void visit_start(std::size_t j, double rise) noexcept;
  void visit_end(std::size_t j, double rise) noexcept;
  void add_event(std::size_t j, double active, bool start) noexcept;
  double excess(std::size_t j) const noexcept;
  void move() noexcept;
  void move_by_moments() noexcept;
  void remember() noexcept;
  void close_events() noexcept;
  void stop_pressing(std::size_t j, double when) noexcept;
  void account_before() noexcept;
  void account_after() noexcept;
  double stored(std::size_t j) const noexcept;

  std::size_t beads_;
  double step_, gravity_, time_ = 0, negligible_rate_ = 0;
  bool repulsive_, silent_, energy_;
  std::array<Law, 2> laws_;
  std::vector<std::uint32_t> kind_;
  motion::ColumnMemory<Law> memory_;
  std::vector<double> mass_, inverse_mass_, velocity_, old_velocity_;  // of bodies
  std::vector<double> overlap_, old_overlap_;                          // of contacts
  std::vector<double> mean_, old_mean_;  // the law's signed mean force over its active part of this step, of the last
  std::vector<double> guess_, next_guess_;  // the mean force to expect in this step, in the next: extrapolated linearly
  std::vector<double> applied_;             // impulse over the step divided by its length [N]
  std::vector<double> moment_;  // of an event: first moment of the impulse beyond that of one spread evenly [N s²]
  std::vector<double> begin_;   // t_b [s]
  std::vector<double> stored_;  // with the energy balance
  std::vector<std::uint8_t> state_, pressing_, by_difference_;
  std::vector<Event> events_;
  std::vector<std::uint32_t> event_of_;  // 1 + its index in events_, 0 for none
  std::size_t active_ = 0, contacts_ = 0;
  double last_contact_time_ = 0, dissipated_ = 0;
};

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
void ColumnEngine<Law>::remember() noexcept {
  using Memory = motion::ColumnMemory<Law>;
  const auto goes_on = [this](std::size_t j) { return state_[j] == touching && !event_of_[j]; };
  if constexpr (std::same_as<Law, FractionalArms>) {
    for (std::size_t first = 1; first <= beads_; ++first) {
      if (!goes_on(first)) continue;
      std::size_t last = first + 1;
      while (last <= beads_ && kind_[last] == kind_[first] && goes_on(last)) ++last;
      memory_.advance_steps(first, last, old_overlap_.data(), overlap_.data());
      first = last - 1;
    }
  } else if constexpr (Memory::remembers) {
    for (std::size_t j = 1; j <= beads_; ++j)
      if (goes_on(j))
        memory_.advance(j, {old_overlap_[j], old_velocity_[j - 1] - old_velocity_[j]}, {overlap_[j], rate(j)}, step_);
  }
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
  // A memory of arms may turn repulsive again while the pair still overlaps; the other laws cannot at a falling
  // overlap.
  constexpr bool may_wake = motion::ColumnMemory<Law>::may_wake;
  for (std::size_t j = 1; j <= beads_; ++j) {
    if (!(rate(j) <= negligible_rate_)) return false;
    if (state_[j] != apart && (may_wake || !repulsive_ || mean_[j] > 0)) return false;
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
