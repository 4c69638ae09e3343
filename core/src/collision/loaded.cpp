#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/loaded.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include "closed_forms.hpp"
#include "loaded_motion.hpp"

#include <cmath>
#include <limits>

namespace ricochet {
namespace {

/// The fractional law's collision in the units m = v₀ = A = 1 under a load p.
class LoadedFractional {
 public:
  LoadedFractional(double alpha, double load)
      : alpha_(alpha),
        load_(load),
        one_(2 - alpha, 1),
        two_(2 - alpha, 2),
        three_(2 - alpha, 3),
        same_(2 - alpha, 2 - alpha) {}

  double overlap(double t) const { return t * (two_(-y(t)) + load_ * t * three_(-y(t))); }
  double rate(double t) const { return one_(-y(t)) + load_ * t * two_(-y(t)); }
  double force(double t) const { return std::pow(t, 1 - alpha_) * same_(-y(t)) + load_ * (1 - one_(-y(t))); }

 private:
  double y(double t) const { return std::pow(t, 2 - alpha_); }

  double alpha_, load_;
  MittagLeffler one_, two_, three_, same_;
};

}  // namespace

namespace collision {

void require_load(double load) { support::require_not_negative("load", load); }

/// Bisection in ln v between the nearest powers of 2 that do and do not part.
double speed_to_part(const std::function<bool(double)>& parts, double guess) {
  constexpr int least = -7, greatest = 16;  // below 1/128 of it a grazing force is not told from one that stays
  const auto at = [&](double step) { return guess * std::exp2(step); };
  int step = 0;
  const bool first = parts(guess);
  while (step > least && step < greatest && parts(at(step)) == first) step += first ? -1 : 1;
  if (step == least) return 0;
  if (step == greatest) return std::numeric_limits<double>::infinity();
  double low = first ? step : step - 1, high = low + 1;
  while (high - low > 5e-4) {
    const double middle = 0.5 * (low + high);
    (parts(at(middle)) ? high : low) = middle;
  }
  return at(high);
}

}  // namespace collision

Collision collide_under_load(const Fractional& law, const Impact& impact, double load, const CollideOptions&) {
  support::require_positive("velocity", impact.velocity);
  support::require_positive("mass_eff", impact.mass_eff);
  collision::require_load(load);
  support::require(law.alpha() >= 0 && law.alpha() < 1, "alpha", law.alpha(), "in [0, 1) under a load");
  const double alpha = law.alpha(), unit = std::pow(impact.mass_eff / law.coefficient(), 1 / (2 - alpha));
  const LoadedFractional motion(alpha, load * unit / (impact.mass_eff * impact.velocity));
  const double tau = fractional_contact(alpha).tau;
  return collision::in_units(collision::follow_loaded(motion, tau, 1.2 * tau), impact, unit);
}

bool clears(const Collision& out, const Impact& impact, double load) {
  const double speed = out.en * impact.velocity;
  return impact.mass_eff * speed * speed >= 2 * load * out.overlap_end;
}

double least_speed_to_part(const AnyLaw& law, double mass_eff, double load) {
  collision::require_load(load);
  return std::visit(
      [&]<class Law>(const Law& one) {
        // Where the load turns the contact's own momentum about in the time of a contact; if that never parts, 1 m/s.
        const Collision free = collide(one, {1, mass_eff});
        const double guess = free.separated() ? load * free.tcol / mass_eff : 1;
        return collision::speed_to_part(
            [&](double velocity) {
              const Impact impact{velocity, mass_eff};
              if constexpr (ContactLaw<Law>) {
                collision::Driven driven(one);
                return collision::parts_under(driven, impact, load);
              } else {
                return collide_under_load(one, impact, load).separated();
              }
            },
            guess);
      },
      law);
}

}  // namespace ricochet
