#pragma once

#include <calibrate/fit.hpp>
#include <calibrate/tangential.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::calibration {

/// A measured quantity of an impact with its standard error, 0: not known.
struct Observed {
  double value = 0, sigma = 0;
};

/// One measured oblique impact without spin before it; at least one of the three was measured.
struct ObliqueMeasurement {
  double normal_velocity = 0;                  ///< [m/s], > 0
  double tangential_velocity = 0;              ///< [m/s], > 0
  std::optional<Observed> et = {};             ///< v_t'/v_t of the centre
  std::optional<Observed> rebound_angle = {};  ///< atan(v_t'/v_n') [rad]
  std::optional<Observed> spin = {};           ///< after, as it rolls forwards [1/s]
  std::size_t line = 0;                        ///< where it stands in its file; 0: nowhere
};

/// The contact whose μ and β₀ are sought: its normal law, and what its spring is called.
struct ObliqueFitRequest {
  TangentialForm form = TangentialForm::undamped;  ///< linear (0 < β₀ ≤ 1) or linear-undamped
  AnyLaw normal = Linear(1, 0);
  ContactEnd end = ContactEnd::force;
  double tcol = 0;      ///< of the normal law [s]
  double mass_eff = 0;  ///< [kg]
  /// ω r of the body that was looked at over that of a sphere of the effective mass at a wall: 1 at a wall, 1/2 of two
  /// equal spheres.
  double spin_share = 1;
  double radius = 0;  ///< of the sphere whose spin was measured [m]; 0: no spins
};

/// What one impact should give.
struct ObliquePrediction {
  double et = 0, rebound_angle = 0, spin = 0;
  bool slides = false;  ///< throughout, but for a moment at the first touch: the impulse is within 0.5 % of μ's
};

struct ObliqueFit {
  std::vector<Estimate> parameters = {};  ///< mu, and beta0 or sqrt(k_t/m_t) tcol, as the data tell them
  double correlation = 0;                 ///< of both, where both are told
  LinearTangential law = LinearTangential(1);
  double mu = 0, beta0 = 0;         ///< β₀ of the law
  std::optional<double> turn = {};  ///< of linear-undamped √(k_t/m_t) t_col, which a β₀ tells up to π
  double chi2 = 0;  ///< Σ of squared residuals over σ²; plain squares where no σ is known: of e_t, rad, ω r/v
  std::size_t observations = 0, freedom = 0;
  bool errors_known = false;
  double probability = 1;
  std::vector<ObliquePrediction> predictions = {};
  std::vector<std::string> findings = {};
};

/// Why no contact here can have done that, "et = 5: must be …"; nothing where one can. Of a sphere without spin before
/// energy has 3/7 ≤ e_t ≤ 1 and 0 ≤ ω r ≤ (10/7) v_t spin_share; 5 % of the greatest, or 3 σ, may be noise,
/// but of a spin below 0 3 σ alone.
std::optional<std::string> impossible(const ObliqueFitRequest& request, const ObliqueMeasurement& m);

/// Weighted least squares over oblique collisions: NLopt (BOBYQA) and Gauss-Newton in ln μ and β₀, up to 0.999, or the
/// turn √(k_t/m_t) t_col of a spring without dashpot, which goes up to 3π (grains turn back more than once), from the
/// eight best local minima of a scan; errors from (JᵀJ)⁻¹, times the scatter where σ is not known. Of impacts that all
/// slide throughout μ alone is told, of impacts none of which slides β₀ is told and μ by what the ends of a contact
/// slip; what is not told is said, and other springs within three standard errors are named.
///
/// Throws std::invalid_argument for data outside their domain or `impossible`, standard errors for some only, spins
/// without a radius, no more observations than unknowns, or a single angle; NotConverged where a collision could not be
/// followed.
ObliqueFit fit_oblique(const ObliqueFitRequest& request, const std::vector<ObliqueMeasurement>& data);

}  // namespace ricochet::calibration
