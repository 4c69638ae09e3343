#include <ricochet/collision/damping_ratio.hpp>

#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include <numbers>

namespace ricochet {

namespace {

using std::numbers::pi;

/// x cot x and x coth x, 1 at x = 0.
double x_cot(double x) { return x < 1e-8 ? 1.0 : x / std::tan(x); }
double x_coth(double x) { return x < 1e-8 ? 1.0 : x / std::tanh(x); }

/// −ln e_n of the contact ended by force.
double force_ended_loss(double beta) { return beta <= 1 ? 2 * x_cot(std::acos(beta)) : 2 * x_coth(std::acosh(beta)); }

/// β = cos ψ is solved for its complement φ = π/2 − ψ, because −ln e_n = 2(π/2 − φ) tan φ keeps its digits as φ → 0.
/// It rises from 0 to 2, a limit that rounding of π/2 − φ hides; 2u coth u rises from 2, and passes 2u.
double force_ended_damping(double loss) {
  if (loss == 0) return 0;
  if (loss < 2)
    return std::sin(support::root([=](double phi) { return (pi - 2 * phi) * std::tan(phi) - loss; }, 0.0,
                                  pi / 2 * (1 - 1e-9), -loss, 2 - loss));
  return std::cosh(support::root([=](double u) { return 2 * x_coth(u) - loss; }, 0.0, 0.5 * loss));
}

}  // namespace

double restitution_of_damping(double beta, ContactEnd end) {
  support::require_not_negative("damping_ratio", beta);
  if (end == ContactEnd::force) return std::exp(-force_ended_loss(beta));
  support::require(beta < 1, "damping_ratio", beta, "< 1, else the overlap never returns to zero");
  return std::exp(-pi * beta / std::sqrt((1 - beta) * (1 + beta)));
}

double damping_of_restitution(double en, ContactEnd end) {
  support::require(en > 0 && en <= 1, "en", en, "in (0, 1]");
  const double loss = 0 - std::log(en);  // not −0
  return end == ContactEnd::force ? force_ended_damping(loss) : loss / std::hypot(pi, loss);
}

double damping_ratio(const Linear& law, double mass_eff) {
  support::require_positive("mass_eff", mass_eff);
  return law.c() / (2 * std::sqrt(mass_eff * law.k()));
}

double damping_ratio(const Tsuji& law, double mass_eff) {
  support::require_positive("mass_eff", mass_eff);
  return law.c() / std::sqrt(5 * mass_eff * law.k());
}

}  // namespace ricochet
