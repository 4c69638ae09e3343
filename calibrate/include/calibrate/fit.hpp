#pragma once

#include <calibrate/calibration.hpp>
#include <ricochet/collision/reduction.hpp>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::calibration {

/// One measured impact; numbers in [1e-30, 1e30]. Standard errors 0: not known (then of all, and without collision
/// times).
struct Measurement {
  double velocity = 0;    ///< [m/s], > 0
  double en = 0;          ///< in (0, 1]
  double en_sigma = 0;    ///< > 0 or not known
  double tcol = 0;        ///< [s], > 0 or not measured
  double tcol_sigma = 0;  ///< [s], > 0 where tcol is
  double mass_eff = 0;    ///< of this impact's bodies [kg]; 0: the request's
  double radius_eff = 0;  ///< of this impact's bodies [m]; 0: not known, or the same in all
  std::size_t line = 0;   ///< where it stands in its file, for findings; 0: nowhere
};

/// Which law is fitted, and how.
struct FitRequest {
  LawKind law;
  ContactEnd end = ContactEnd::force;
  double mass_eff = 0;  ///< [kg], > 0: that of the bodies whose parameters are told
  /// Fractional only: the paper's idea of an α that follows the impact, as ln(α/(α_max−α)) = a + b ln(v/(1 m/s)), where
  /// α_max is 1 by force and overlap_limit by overlap. Monotone in v, in (0, α_max) for every v, and constant for
  /// b = 0; with b > 0 a slow impact is elastic and a fast one loses all, with b < 0 the other way round.
  bool alpha_of_speed = false;
  double radius_eff = 0;  ///< [m] of those bodies; 0: not known
  Held held = {};         ///< what no speed tells of the two linear laws of real solids
};

/// A fitted parameter with its standard error.
struct Estimate {
  std::string name;
  double value = 0;
  double error = 0;
  std::string unit;
};

struct Prediction {
  double en = 0;
  double tcol = 0;  ///< [s]; 0 where the data have no times
};

/// A weighted least-squares fit: minimises χ² = Σ ((en − e(v))/σ)² + Σ ((tcol − t(v))/σ_t)².
struct Fit {
  FitRequest request;
  std::vector<Estimate> parameters;               ///< what these data can tell
  std::vector<std::vector<double>> correlations;  ///< of the parameters
  std::vector<Prediction> predictions;            ///< at the measurements
  double chi2 = 0;               ///< Σ of squared residuals over σ²; plain Σ of squares where no σ is known
  std::size_t observations = 0;  ///< restitutions and times
  std::size_t freedom = 0;       ///< observations − parameters
  bool errors_known = false;     ///< false: σ was taken from the scatter about the fit
  /// χ² + 2p where σ is known; n ln(χ²/n) + 2(p + 1) where it is not (constants left out). Less is better.
  double aic = 0;
  /// The AIC for few data: 2q(q + 1)/(n − q − 1) more, q the number of all that was estimated, with σ where it is not
  /// known (Hurvich and Tsai, Biometrika 76, 297 (1989)). Nothing where n ≤ q + 1.
  std::optional<double> aicc = {};
  double probability = 0;                  ///< of a χ² as large by chance, where σ is known; else 1
  std::vector<double> solution = {};       ///< in the fit's own variables, for `predict`
  std::vector<std::string> findings = {};  ///< what the data do not tell, and what does not fit, in words

  std::size_t unknowns() const { return parameters.size(); }
};

/// Fits one law. Impacts of other bodies than the request's are those of the same material: the damping ratio of linear
/// and Tsuji's law, k₂/k₁ and α are the same for all sizes, so is c/k of Kuwabara and Kono's; k of the laws in ζ^{3/2}
/// goes with √(effective radius) where radii are known, that of the others stays.
///
/// NLopt (SLSQP, with the Jacobian by central differences) minimises χ² over the logarithms of the
/// parameters, from the best of a coarse scan, and Gauss-Newton takes the last digits; errors and correlations are
/// those of (JᵀJ)⁻¹ at the minimum, times χ²/ν where σ is not known. Without collision times no law's stiffness can be
/// told: the parameters are then the combinations that set e_n, which are named so.
///
/// A linear law's restitution says nothing of the speed, so of a fractional-kelvin-voigt α is held, of a
/// fractional-zener α and k₁/k; fractional-hertz has e_n(v) of its own, 1 − e_n ∝ v^{α/5} where little is lost, and α
/// is fitted with the loss. k = 0, the pure power law, is its limit of great loss.
///
/// The forward model's error (e_n and t_col as functions of the parameters) is below 1e-9: polynomials through
/// numerical collisions for Kuwabara-Kono, Tsuji and fractional-hertz (2e-9 in its t_col) and through closed forms for
/// the fractional law; `collide` for the others.
///
/// Throws std::invalid_argument for data outside their domain, no more observations than parameters, an end that the
/// law does not offer, times without en_sigma; NotConverged, which names them, where the data leave parameters open.
Fit fit_law(const FitRequest& request, const std::vector<Measurement>& data);

/// Which of several fits to the same data the AIC prefers.
struct Preference {
  std::vector<std::size_t> best;         ///< their places, the least AIC first: more than one within `same`
  std::optional<std::size_t> next = {};  ///< the place of the next, where there is one
  double ahead = 0;                      ///< how far its AIC is over theirs
  static constexpr double same = 1e-3;   ///< laws that say the same differ by the fits' rounding
};
/// Throws std::invalid_argument where there are none.
Preference preferred(const std::vector<Fit>& fits);
/// The same in words, "By the AIC tsuji fits best; 3.1 over it comes linear."; "" of one fit.
std::string preference_text(const std::vector<Fit>& fits);

/// What of the law is held, because the data cannot tell it at any speed: of most laws nothing.
std::vector<NamedValue> held(const FitRequest& request);

/// Does the law change its restitution with the speed of the impact?
bool follows_speed(const FitRequest& request);

/// What the fitted law does at another velocity, between the request's bodies.
Prediction predict(const Fit& fit, double velocity);

/// "kuwabara-kono", …, "fractional, alpha(v)".
std::string fit_name(const FitRequest& request);

}  // namespace ricochet::calibration
