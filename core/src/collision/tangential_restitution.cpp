#include <ricochet/collision/tangential_restitution.hpp>
#include <ricochet/support/require.hpp>

#include <cmath>
#include <numbers>

namespace ricochet {

LinearTangential tangential_for(double beta0, double tcol, double mass_eff, StickingForm form) {
  using std::numbers::pi;
  support::require_positive("tcol", tcol);
  support::require_positive("mass_eff", mass_eff);
  const double m = tangential_mass_ratio * mass_eff;
  if (form == StickingForm::undamped) {
    support::require(beta0 > -1 && beta0 <= 1, "beta0", beta0, "> -1 and <= 1");
    const double w = std::acos(-beta0) / tcol;
    return LinearTangential(m * w * w);
  }
  support::require(beta0 > 0 && beta0 <= 1, "beta0", beta0, "> 0 and <= 1 (damped form)");
  const double loss = 0.0 - std::log(beta0);  // 0, not −0, of β₀ = 1
  return LinearTangential(m * (pi * pi + loss * loss) / (tcol * tcol), 2 * m * loss / tcol);
}

double sticking_restitution(const LinearTangential& law, double tcol, double mass_eff) {
  support::require_positive("tcol", tcol);
  support::require_positive("mass_eff", mass_eff);
  const double m = tangential_mass_ratio * mass_eff;
  const double D = 0.5 * law.c_t() / m, W = std::sqrt(law.k_t() / m);
  const double w = std::sqrt(std::abs(W - D)) * std::sqrt(W + D), turn = w * tcol;
  if (turn < 1e-8) return -std::exp(-D * tcol) * (1 - D * tcol);
  if (D < W) return -std::exp(-D * tcol) * (std::cos(turn) - D / w * std::sin(turn));
  // The two real exponents −D ± w, of which the slow one is −W²/(D + w).
  const double slow = W / (D + w) * W;
  return 0.5 * (slow / w * std::exp(-slow * tcol) - (1 + D / w) * std::exp(-(D + w) * tcol));
}

}  // namespace ricochet
