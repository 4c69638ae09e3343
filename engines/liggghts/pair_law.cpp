#include "pair_law.hpp"

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/reduction.hpp>
#include <ricochet/support/require.hpp>

#include <cmath>

namespace ricochet::liggghts {

PairLaw::PairLaw(const HalfStepContact& contact) : contact_(contact) {
  const auto ideal = fractional_contact(contact.alpha());
  z_star_ = ideal.z_star;
  en_ = ideal.en;
  const Linear linear = Reduction<Linear>::unit(en_, ContactEnd::overlap)->law;
  linear_stiffness_ = linear.k();
  linear_damping_ = linear.c();
}

PairLaw PairLaw::from_target(double tcol, double en, const ContactFor& contact_for) {
  support::require_positive("collisionTime", tcol);
  support::require(en > 0 && en <= 1, "coefficientRestitution", en, "0 < en <= 1");
  PairLaw law(contact_for(conversion_degree(en)));
  law.tcol_ = tcol;
  law.per_mass_ = law.z_star_ / std::pow(tcol, 2 - law.contact_.alpha());
  return law;
}

PairLaw PairLaw::from_parameters(double k, double c, double alpha, const ContactFor& contact_for) {
  const double coefficient = Fractional(k, c, alpha).coefficient();
  PairLaw law(contact_for(alpha));
  law.coefficient_ = coefficient;
  return law;
}

}  // namespace ricochet::liggghts
