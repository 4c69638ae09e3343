#pragma once

#include <ricochet/contact/mean_force.hpp>
#include <ricochet/motion/contact_state.hpp>
#include <ricochet/motion/engine/implicit_force.hpp>
#include <ricochet/motion/engine/memory_slots.hpp>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace ricochet::motion {

/// The normal part of one contact over one step: what its law is asked, what it answers, and what comes of it.
struct NormalRow {
  double overlap = 0;        ///< in the middle of the step [m]
  double rate = 0;           ///< ζ' at the step's start [m/s]
  double mobility = 0;       ///< 1/m_i + 1/m_j [1/kg]
  double duration = 0;       ///< Δt [s], or 0: the impulse is fixed
  double since_touch = 0;    ///< of a fresh contact, at the step's end [s]
  double fixed_impulse = 0;  ///< then [N s]
  double force = 0;          ///< R(ζ') = force + slope·(ζ' − rate) [N]
  double slope = 0;          ///< [N s/m]
  double impulse = 0;        ///< that the contact passes [N s]
  double rate_mid = 0;       ///< the mean of ζ' before and after [m/s]
  double loss = 0;           ///< what dashpots and the clamp have taken [J]
};

/// Contacts of a cluster, their rows, and which of them are meant.
struct NormalBatch {
  std::span<const std::uint32_t> members;
  std::span<ContactState* const> contacts;
  std::span<NormalRow> rows;
};

/// All contacts of one interaction: they share the law, and their memories lie side by side. The cluster asks for whole
/// batches at once, so that the law is a template in their loops; only a first touch and a separation are single calls.
class NormalContacts {
 public:
  NormalContacts() = default;
  NormalContacts(const NormalContacts&) = delete;
  NormalContacts& operator=(const NormalContacts&) = delete;
  virtual ~NormalContacts() = default;

  virtual std::string_view law() const noexcept = 0;
  virtual std::size_t memory_size() const noexcept = 0;  ///< of one contact, in doubles
  virtual double kernel_error() const noexcept = 0;      ///< of a fractional law's memory kernel; else 0

  /// Gives a contact the memory of a first touch, and the force at its approach.
  virtual void begin(ContactState& contact) = 0;
  /// The contact is over; its memory is forgotten.
  virtual void forget(const ContactState& contact) = 0;
  /// Fills in `force`, `slope` and the first guess of `impulse`; a fresh contact is integrated from t_b to the end of
  /// the step, its row is fixed.
  virtual void prepare(const NormalBatch& batch) = 0;
  /// Brings memories to the middle of the step, `middle` [s], given the rows' `impulse` and `rate_mid`; fills in `loss`
  /// and notes where a force has ended.
  virtual void conclude(const NormalBatch& batch, double middle) = 0;
  /// How fast the force grows with the rate over a step that begins with the contact as it is [N s/m].
  virtual double drag(const ContactState& contact, double mobility) const = 0;
  /// The same where it is that of every contact.
  virtual std::optional<double> constant_drag() const noexcept = 0;
  /// The signed force `span` [s] after the contact's approach, at another [N].
  virtual double force_at(const ContactState& contact, Approach then, double span) const = 0;

  /// A contact's memory as memory_size() doubles.
  virtual void save(const ContactState& contact, std::span<double> values) const = 0;
  /// Takes a contact up whose memory was saved.
  virtual void restore(ContactState& contact, std::span<const double> values) = 0;
};

template <ContactLaw Law>
class NormalContactsOf final : public NormalContacts {
 public:
  using Memory = typename Law::Memory;
  static_assert(MemoryOfDoubles<Memory>, "Law::Memory must be an aggregate of doubles and nothing else");

  /// `step` is Δt [s].
  NormalContactsOf(const Law& law, double step, ContactEnd end, double kernel_error = 0)
      : law_(law),
        step_(step),
        clamped_(end == ContactEnd::force),
        fades_(force_fades(law)),
        kernel_error_(kernel_error) {}

  std::string_view law() const noexcept override { return Law::name; }
  std::size_t memory_size() const noexcept override { return motion::memory_size<Memory>; }
  double kernel_error() const noexcept override { return kernel_error_; }

  void begin(ContactState& c) override {
    c.slot = memories_.take();
    c.force = law_.force(c.approach, Memory{});
    c.stored = law_.stored_energy(c.approach, Memory{});
    c.impact_rate = c.approach.rate;
  }
  void forget(const ContactState& c) override { memories_.give_back(c.slot); }

  void prepare(const NormalBatch& batch) override {
    for (std::size_t n = 0; n < batch.members.size(); ++n) {
      if (n + look_ahead < batch.members.size()) memories_.fetch(batch.contacts[batch.members[n + look_ahead]]->slot);
      const std::uint32_t k = batch.members[n];
      ContactState& c = *batch.contacts[k];
      NormalRow& row = batch.rows[k];
      if (c.fresh) {
        touch(c, row);
        row.impulse = row.fixed_impulse;
      } else {
        const auto [force, slope] = implicit_force(law_, c.approach, Approach{row.overlap, row.rate},
                                                   std::as_const(memories_)[c.slot], c.lag, row.mobility);
        row.force = force, row.slope = slope;
        row.impulse = row.duration > 0 ? c.normal_impulse : row.fixed_impulse;
      }
    }
  }

  void conclude(const NormalBatch& batch, double middle) override {
    for (const std::uint32_t k : batch.members) {
      ContactState& c = *batch.contacts[k];
      NormalRow& row = batch.rows[k];
      c.normal_impulse = row.impulse;
      if (!std::exchange(c.fresh, false)) {
        const Approach before = c.approach;
        const double span = c.lag;
        advance(c, row, middle);
        if (fades_) note_rest(c, before.rate, middle, span);
      } else if (c.record.end != Encounter::never) {
        c.record.how = EncounterEnd::deformed_rebound;
      }
    }
  }

  double drag(const ContactState& c, double mobility) const override {
    return implicit_force(law_, c.approach, c.approach, memories_[c.slot], step_, mobility).slope;
  }
  std::optional<double> constant_drag() const noexcept override {
    if constexpr (constant_slope<Law>) return implicit_force(law_, {}, {}, Memory{}, step_, 0).slope;
    return std::nullopt;
  }

  double force_at(const ContactState& c, Approach then, double span) const override {
    return force_after(law_, c.approach, then, memories_[c.slot], span);
  }

  void save(const ContactState& c, std::span<double> values) const override { motion::save(memories_[c.slot], values); }
  void restore(ContactState& c, std::span<const double> values) override {
    c.slot = memories_.take();
    motion::restore(memories_[c.slot], values);
  }

 private:
  // From t_b to the end of the step the pair moves by itself, m ζ'' = −R, on a mesh graded towards t_b. Means of the
  // force over each part keep forces that start with a jump or like a power of time from spoiling the order.
  void touch(ContactState& c, NormalRow& row) {
    constexpr int parts = 6;
    const double length = row.since_touch;
    Memory& memory = memories_[c.slot];
    Approach a = c.approach;
    double force = law_.force(a, memory), impulse = 0, loss = 0, t = 0;
    for (int k = 1; k <= parts && (a.overlap > 0 || k == 1); ++k) {
      const double to = length * k * k / double(parts * parts), dt = to - t;
      const double applied = repulsive(force), guess = a.rate - 0.5 * applied * row.mobility * dt;
      const double push = repulsive(mean_force(law_, a.overlap, guess, memory, dt));
      const double rate = a.rate - push * row.mobility * dt, mid = 0.5 * (a.rate + rate);
      const Approach next{a.overlap + mid * dt, rate};
      const double before = law_.stored_energy(a, memory);
      law_.advance(memory, a, next, dt);
      const double after = law_.stored_energy(next, memory), last = force;
      force = law_.force(next, memory);
      impulse += push * dt;
      loss += push * mid * dt - (after - before);
      if (clamped_ && last > 0 && force <= 0) c.record.end = c.record.begin + t + dt * last / (last - force);
      a = next, t = to;
    }
    c.approach = a, c.force = force;
    c.stored = law_.stored_energy(a, memory);
    c.lag = 0.5 * step_;
    row.duration = 0, row.fixed_impulse = impulse, row.loss = loss;
  }

  // Advances a memory and reads what the law then says.
  MaxwellArms::Reading moved(Memory& memory, Approach before, Approach after, double dt) const {
    if constexpr (MovesAsArms<Law>)
      if (dt == law_.step()) return law_.advance_and_read(memory, before, after);
    law_.advance(memory, before, after, dt);
    return {law_.force(after, memory), law_.stored_energy(after, memory), law_.dissipated_power(after, memory)};
  }

  // Advances the memory to the middle of the step and books the normal energies. The work of the impulse is what the
  // law stores, what its dashpots burn, and what the clamp at zero withholds; each is of second order.
  void advance(ContactState& c, NormalRow& row, double middle) {
    const double h = step_, rate = row.rate_mid;
    const Approach at{row.overlap, rate};
    const auto [force, held, burnt] = moved(memories_[c.slot], c.approach, at, c.lag);
    // Past the clamp the law's own balance no longer describes the motion: the arms go on being stretched, but by
    // nobody, so no more counts as stored than was and than the impulse has put in.
    const bool clamped = force <= 0 && clamped_;
    const double stored =
        clamped ? std::clamp(c.stored + row.impulse * rate, 0.0, held) : held + 0.5 * h * (force * rate - burnt);
    const bool closes = !clamped && c.force > 0 && row.duration > 0;
    row.loss = closes ? h * burnt + (row.impulse - h * force) * rate : row.impulse * rate - (stored - c.stored);
    c.stored = stored;
    if (clamped_ && c.record.end == Encounter::never && c.force > 0 && force <= 0)
      c.record.end = middle - c.lag * force / (force - c.force);
    c.force = force;
    c.approach = at;
    c.lag = h;
  }

  // (26): still repelling, the pair has all but come to rest. The rate is taken as linear over the step.
  void note_rest(ContactState& c, double rate_before, double middle, double span) const noexcept {
    const double limit = at_rest * c.impact_rate, rate = c.approach.rate;
    if (c.record.end != Encounter::never || !(c.force > 0 && rate <= limit && limit > 0)) return;
    const double past = rate_before > limit ? (limit - rate) / (rate_before - rate) : 1.0;
    c.record.end = std::max(c.record.begin, middle - span * past);
    c.record.how = EncounterEnd::permanent_contact;
  }

  double repulsive(double force) const noexcept { return clamped_ ? std::max(0.0, force) : force; }

  Law law_;
  double step_;
  bool clamped_;
  bool fades_;  // a pair's force only tends to zero
  double kernel_error_;
  MemorySlots<Memory> memories_;
};

}  // namespace ricochet::motion
