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
  const double loss = -std::log(beta0);
  return LinearTangential(m * (pi * pi + loss * loss) / (tcol * tcol), 2 * m * loss / tcol);
}

double sticking_restitution(const LinearTangential& law, double tcol, double mass_eff) {
  support::require_positive("tcol", tcol);
  support::require_positive("mass_eff", mass_eff);
  const double m = tangential_mass_ratio * mass_eff;
  const double D = 0.5 * law.c_t() / m, square = law.k_t() / m - D * D, w = std::sqrt(std::abs(square));
  const double turn = w * tcol, fade = std::exp(-D * tcol);
  if (square > 0) return -fade * (std::cos(turn) - D / w * std::sin(turn));
  if (turn < 1e-8) return -fade * (1 - D * tcol);
  // e^{−Dt} cosh wt and sinh wt, neither of which overflows so: w < D.
  const double slow = std::exp((w - D) * tcol), fast = std::exp(-(w + D) * tcol);
  return -0.5 * (slow + fast - D / w * (slow - fast));
}

}  // namespace ricochet
