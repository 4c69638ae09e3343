#include "pair_law.hpp"

#include <ricochet/support/require.hpp>

#include <cmath>
#include <string>

namespace ricochet::half_step {

namespace {

constexpr double nodes_per_octave = 12;

template <class Law>
std::optional<UnitLaw<Law>> unit_of(double en, const Held& held) {
  if constexpr (HoldsDegree<Law>)
    return Reduction<Law>::unit(en, ContactEnd::force, held);
  else
    return Reduction<Law>::unit(en, ContactEnd::force);
}

}  // namespace

template <class Law>
PairLaw<Law> PairLaw<Law>::from_target(double tcol, double en, const Held& held, double velocity,
                                       const ContactFor<Law>& contact_for, const TargetNames& names) {
  support::require_positive(names.tcol, tcol);
  support::require(en > 0 && en <= 1, names.en, en, "0 < en <= 1");
  const auto unit = unit_of<Law>(en, held);
  support::require(unit.has_value(), names.en, en, "one that the law reaches with this " + std::string(names.alpha));
  const auto law = Reduction<Law>::in_si(unit->law, tcol, {velocity, 1});
  support::require(law.has_value(), names.tcol, tcol, "one whose coefficients a double carries");
  PairLaw pair(contact_for(*law), velocity);
  pair.target_ = Outcome{std::log(tcol), -std::log(en)};
  return pair;
}

template <class Law>
PairLaw<Law> PairLaw<Law>::from_parameters(const Law& law, double velocity, const ContactFor<Law>& contact_for) {
  return {contact_for(law), velocity};
}

template <class Law>
LinearEquivalent PairLaw<Law>::linear_equivalent(double mass_eff) const {
  const Outcome out = outcome(mass_eff);
  const auto [k, c] = Reduction<Linear>::values_by_overlap(out.loss);
  const double per_time = std::exp(-out.log_tcol);
  return {k * mass_eff * per_time * per_time, c * mass_eff * per_time};
}

// Of the fractional law ln t_col is linear in ln m, so that nothing is lost between the nodes.
template <class Law>
typename PairLaw<Law>::Outcome PairLaw<Law>::outcome(double mass_eff) const {
  if (target_) return *target_;
  const double at = nodes_per_octave * std::log2(mass_eff), low = std::floor(at), part = at - low;
  const Outcome &below = node(static_cast<int>(low)), &above = node(static_cast<int>(low) + 1);
  return {below.log_tcol + part * (above.log_tcol - below.log_tcol), below.loss + part * (above.loss - below.loss)};
}

template <class Law>
const typename PairLaw<Law>::Outcome& PairLaw<Law>::node(int place) const {
  if (const auto known = nodes_.find(place); known != nodes_.end()) return known->second;
  const double mass = std::exp2(place / nodes_per_octave);
  const Collision out = collide(contact_.law(), {velocity_, mass}, {});
  support::require(out.separated(), "mass", mass, "one with which this contact ends");
  return nodes_.emplace(place, Outcome{std::log(out.tcol), -std::log(out.en)}).first->second;
}

template class PairLaw<Fractional>;
template class PairLaw<FractionalKelvinVoigt>;
template class PairLaw<FractionalHertz>;
template class PairLaw<FractionalZener>;

}  // namespace ricochet::half_step
