#include <ricochet/motion/tuned_law.hpp>

#include <ricochet/contact/damping_ratio.hpp>
#include <ricochet/contact/fractional_contact.hpp>
#include <ricochet/detail/require.hpp>

#include <boost/math/tools/toms748_solve.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>

namespace ricochet {

namespace {

/// Exponents of kζ^a + cζ^bζ': how its coefficients scale from mass, velocity and time 1 to those of the target.
struct Exponents {
  double a, b;
};

/// `law` collides in `unit_tcol` where mass and velocity are 1; brings it to `tcol` at the given impact.
template <class Law>
Law scaled(const Law& law, Exponents e, double unit_tcol, double tcol, const Impact& impact) {
  const double time = tcol / unit_tcol, m = impact.mass_eff, v = impact.velocity;
  return Law(law.k() * m * std::pow(v, 1 - e.a) * std::pow(time, -e.a - 1),
             law.c() * m * std::pow(v, -e.b) * std::pow(time, -e.b - 1));
}

template <class Law>
Law damped(double c, Exponents e, double tcol, const Impact& impact, ContactEnd end) {
  const Law law(1, c);
  CollideOptions options;
  options.end = end;
  return scaled(law, e, collide(law, {1, 1}, options).tcol, tcol, impact);
}

/// ln e_n of the Kuwabara–Kono law falls from 0 as ln c grows: a root in ln c.
double kuwabara_kono_damping(double en) {
  const auto miss = [en](double log_c) {
    const Collision out = collide(KuwabaraKono(1, std::exp(log_c)), {1, 1});
    return (out.separated() ? std::log(out.en) : -100.0) - std::log(en);
  };
  double low = std::log(-std::log(en)) - 4, high = low + 8;
  std::uintmax_t trials = 200;
  const auto root = boost::math::tools::toms748_solve(miss, low, high, boost::math::tools::eps_tolerance<double>(48),
                                                      trials);
  return std::exp(0.5 * (root.first + root.second));
}

Hysteretic hysteretic(double tcol, double en, double mass_eff, ContactEnd end) {
  detail::require(end == ContactEnd::force, "end", 0, "by force for the hysteretic law");
  // t = (π/2) √(m/k₁) (1 + e), e = √(k₁/k₂).
  const double root = 0.5 * std::numbers::pi * (1 + en) / tcol, k1 = mass_eff * root * root;
  return {k1, k1 / (en * en)};
}

Fractional fractional(double alpha, const FractionalContact& contact, double tcol, double mass_eff) {
  const double coefficient = mass_eff * std::pow(contact.tau / tcol, 2 - alpha);
  return {coefficient, coefficient, alpha};
}

}  // namespace

Fractional tuned_fractional(double alpha, double tcol, double mass_eff) {
  detail::require_positive("tcol", tcol);
  detail::require_positive("mass_eff", mass_eff);
  detail::require(alpha > 0 && alpha < 0.97, "alpha", alpha, "between 0 and 0.97");
  return fractional(alpha, fractional_contact(alpha), tcol, mass_eff);
}

AnyLaw tuned_law(LawKind kind, double tcol, double en, const Impact& impact, ContactEnd end) {
  detail::require_positive("tcol", tcol);
  detail::require(std::isfinite(en) && en >= 1e-3 && en < 1, "en", en, "in [0.001, 1)");
  detail::require_positive("velocity", impact.velocity);
  detail::require_positive("mass_eff", impact.mass_eff);
  switch (kind) {
    case LawKind::linear:
      return damped<Linear>(2 * damping_of_restitution(en, end), {1, 0}, tcol, impact, end);
    case LawKind::tsuji:
      return damped<Tsuji>(std::sqrt(5.0) * damping_of_restitution(en, end), {1.5, 0.25}, tcol, impact, end);
    case LawKind::kuwabara_kono:
      detail::require(end == ContactEnd::force, "end", 0, "by force for the Kuwabara-Kono law");
      return damped<KuwabaraKono>(kuwabara_kono_damping(en), {1.5, 0.5}, tcol, impact, end);
    case LawKind::hysteretic: return hysteretic(tcol, en, impact.mass_eff, end);
    case LawKind::fractional: break;
  }
  const double alpha = conversion_degree(en, end);
  return fractional(alpha, fractional_contact(alpha, end), tcol, impact.mass_eff);
}

}  // namespace ricochet
