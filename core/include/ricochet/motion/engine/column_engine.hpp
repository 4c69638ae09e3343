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

}  // namespace ricochet

#include <ricochet/motion/engine/column_energy.hpp>
#include <ricochet/motion/engine/column_events.hpp>
#include <ricochet/motion/engine/column_step.hpp>
