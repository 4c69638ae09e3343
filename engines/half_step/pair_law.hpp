#pragma once

#include "half_step_contact.hpp"

#include <ricochet/collision/reduction.hpp>

#include <functional>
#include <map>
#include <optional>
#include <string_view>

namespace ricochet::half_step {

/// Stiffness [kg/s²] and damping [kg/s] of the linear contact with the same collision time and restitution. The
/// engine's tangential and rolling models scale theirs by these.
struct LinearEquivalent {
  double stiffness;
  double damping;
};

/// What an engine's users call that which a contact is asked for; messages name it so.
struct TargetNames {
  std::string_view tcol, en, alpha;
};

/// Finds the contact of a law; an engine keeps those it has made, as their kernels take a fit each.
template <class Law>
using ContactFor = std::function<const LocatedContact<Law>&(const Law&)>;

/// A law between grains of two materials: the contact that all their pairs share, what turns it into one pair's force,
/// and how that pair collides. Of fractional-hertz alone the collision depends on the `velocity` [m/s]: it is the one
/// at which all of this holds.
template <class Law>
class PairLaw {
 public:
  /// Every pair has the collision time tcol [s] and the restitution en, 0 < en ≤ 1, with what `held` leaves open: all
  /// coefficients are proportional to the pair's effective mass. Throws std::invalid_argument, also for a restitution
  /// that is not reached.
  static PairLaw from_target(double tcol, double en, const Held& held, double velocity,
                             const ContactFor<Law>& contact_for, const TargetNames& names);

  /// Every pair has this law, whatever its mass. Throws std::invalid_argument for one whose contact does not end.
  static PairLaw from_parameters(const Law& law, double velocity, const ContactFor<Law>& contact_for);

  const LocatedContact<Law>& contact() const noexcept { return contact_; }
  /// What the contact's force is multiplied by, for a pair of effective mass `mass_eff` [kg].
  double coefficient(double mass_eff) const noexcept { return target_ ? mass_eff : 1; }
  /// [s]; from parameters between collisions of masses a twelfth of an octave apart, to 1e-4.
  double tcol(double mass_eff) const { return std::exp(outcome(mass_eff).log_tcol); }
  double en(double mass_eff) const { return std::exp(-outcome(mass_eff).loss); }
  LinearEquivalent linear_equivalent(double mass_eff) const;

 private:
  struct Outcome {
    double log_tcol, loss;  // ln t_col [s], −ln e_n
  };

  PairLaw(const LocatedContact<Law>& contact, double velocity) : contact_(contact), velocity_(velocity) {}
  Outcome outcome(double mass_eff) const;
  const Outcome& node(int place) const;

  LocatedContact<Law> contact_;
  double velocity_;
  std::optional<Outcome> target_;
  mutable std::map<int, Outcome> nodes_;  // those that were asked for: a run's grains are of few sizes
};

extern template class PairLaw<Fractional>;
extern template class PairLaw<FractionalKelvinVoigt>;
extern template class PairLaw<FractionalHertz>;
extern template class PairLaw<FractionalZener>;

}  // namespace ricochet::half_step
