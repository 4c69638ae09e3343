#pragma once

#include "half_step_contact.hpp"

#include <cmath>
#include <functional>

namespace ricochet::liggghts {

/// Stiffness [kg/s²] and damping [kg/s] of the linear contact with the same collision time and restitution. The
/// engine's tangential and rolling models scale theirs by these.
struct LinearEquivalent {
  double stiffness;
  double damping;
};

/// Finds the contact for a conversion degree; an engine keeps those it has made, as their kernels take a fit each.
using ContactFor = std::function<const HalfStepContact&(double alpha)>;

/// The fractional law between grains of two materials: the contact that all their pairs share and what turns it into
/// one pair's force. Immutable.
class PairLaw {
 public:
  /// Every pair has the collision time tcol [s] and the restitution en, 0 < en ≤ 1: α = conversion_degree(en) and
  /// A = z*(α)/tcol^{2−α}, so the coefficient m A is proportional to the pair's effective mass.
  /// Throws std::invalid_argument.
  static PairLaw from_target(double tcol, double en, const ContactFor& contact_for);

  /// Every pair has the coefficient c^α k^{1−α} of Eq. (30), k [kg/s²], c [kg/s], 0 ≤ α < 1, whatever its mass.
  static PairLaw from_parameters(double k, double c, double alpha, const ContactFor& contact_for);

  const HalfStepContact& contact() const noexcept { return contact_; }
  /// c^α k^{1−α} [kg s^{α−2}] of a pair of effective mass `mass_eff` [kg].
  double coefficient(double mass_eff) const noexcept { return tcol_ > 0 ? per_mass_ * mass_eff : coefficient_; }
  double tcol(double mass_eff) const noexcept {
    return tcol_ > 0 ? tcol_ : std::pow(z_star_ * mass_eff / coefficient_, 1 / (2 - contact_.alpha()));
  }
  double en() const noexcept { return en_; }
  LinearEquivalent linear_equivalent(double mass_eff) const noexcept {
    const double per_time = 1 / tcol(mass_eff);
    return {linear_stiffness_ * mass_eff * per_time * per_time, linear_damping_ * mass_eff * per_time};
  }

 private:
  explicit PairLaw(const HalfStepContact& contact);

  HalfStepContact contact_;
  double z_star_, en_;
  double linear_stiffness_, linear_damping_;  // π² + ln² e_n and −2 ln e_n, those of m = t_col = 1
  double tcol_ = 0, per_mass_ = 0;            // from a target
  double coefficient_ = 0;                    // from parameters
};

}  // namespace ricochet::liggghts
