#pragma once

#include <calibrate/calibration.hpp>
#include <ricochet/contact/tangential.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ricochet::calibration {

/// How a tangential spring is found beside a normal law.
enum class TangentialForm {
  linear,  ///< spring and dashpot: half a period in t_col, k_t = m_t (π² + ln²β₀)/t_col², c_t = −2 m_t ln β₀/t_col
  undamped,  ///< spring alone: k_t = m_t (arccos(−β₀)/t_col)²
  mindlin    ///< k_t √ζ: of the moduli, 8 G* √R*, with c_t for β₀; without moduli k_t for β₀ alone
};
/// "linear", "linear-undamped", "mindlin".
std::string_view text(TangentialForm form) noexcept;
std::optional<TangentialForm> tangential_form(std::string_view name) noexcept;
/// Why the form cannot have β₀: (0, 1] is the range of linear, (−1, 1] of linear-undamped; mindlin's hangs on the
/// normal law, of which nothing is said here.
std::optional<Infeasible> out_of_form(TangentialForm form, double beta0, LawKind normal, ContactEnd end);
/// k_t and c_t with their units.
std::span<const Parameter> parameters_of(TangentialForm form) noexcept;

/// What the contact shall do in its tangent plane.
struct TangentialRequest {
  TangentialForm form = TangentialForm::linear;
  std::optional<double> beta0 = {};  ///< −u_t'/u_t of the contact point while it sticks; mindlin with moduli: optional
  std::optional<double> mu = {};     ///< coefficient of friction, ≥ 0
  std::optional<double> mindlin = {};  ///< 8 G* √R* [kg/(s² m^{1/2})] of mindlin, where moduli give it
};

/// 1/G* = (2−ν₁)/G₁ + (2−ν₂)/G₂ with G = E/(2(1+ν)) [Pa] and R* [m] into 8 G* √R*: Mindlin's no-slip stiffness
/// 8 G* a over √ζ. Moduli [Pa] > 0; throws std::invalid_argument.
double mindlin_stiffness(double young, double poisson, double young2, double poisson2, double radius_eff);

/// A tangential law beside a normal one.
struct TangentialCalibration {
  TangentialForm form = TangentialForm::linear;
  TangentialLaw law;
  std::optional<double> mu = {};
  double beta0 = 0;             ///< asked for; of moduli without one, as it came out
  double achieved = 0;          ///< of the contact that sticks throughout, by the oblique collision of the normal law
  std::size_t evaluations = 0;  ///< oblique collisions that the search tried
  std::optional<double> cross_difference = {};  ///< greatest relative difference of a parameter, the search's and ours
  std::string algorithm = {};                   ///< of ours: "closed form", "bracketed root", "moduli"
  std::vector<std::string> remarks = {};
};

using TangentialOutcome = std::variant<TangentialCalibration, Infeasible>;

/// The tangential law whose contact sticks with β₀ beside `normal`, which takes target.tcol. Sticking is an oscillator
/// of its own that no normal force enters, so that the two linear forms are closed; mindlin is a bracketed root over
/// the oblique collision, up to the greatest β₀ that its first half period reaches. Cross-checked by a search (NLopt,
/// BOBYQA) over the oblique collision at a friction that never slides: β₀, and of `linear` also that nothing is left in
/// the spring at the end, which is what half a period means. Where that search ends more than 1e-6 away, a remark says
/// so: the collision's own error hides what is left, as close to −1 and 1.
///
/// The oblique collision's tangential forces end where repulsion does. Of a contact that ends by overlap the linear
/// forms go by t_col all the same, as is usual; what then comes out is in `achieved` and a remark; so it is where
/// the repulsion falls too low for any friction to hold.
///
/// Infeasible where β₀ is out of the form's range: (0, 1] of linear, (−1, 1] of linear-undamped.
/// Throws std::invalid_argument for μ < 0, β₀ missing where it is needed.
TangentialOutcome calibrate_tangential(const TangentialRequest& request, const AnyLaw& normal, ContactEnd end,
                                       const Target& target);

/// One oblique impact, seen on the bodies' centres: angle [rad] from the normal, v_n as the law was calibrated for.
struct ObliqueRebound {
  double angle = 0;
  double et = 0;             ///< v_t'/v_t of the centre
  double beta = 0;           ///< −u_t'/u_t of the contact point
  double rebound_angle = 0;  ///< atan(v_t'/v_n') [rad]
  double impulse_ratio = 0;  ///< tangential over normal impulse; μ: slides throughout
};

/// Angles of 5° to 85° in steps of 5°.
std::vector<double> usual_angles();

/// What the contact does to impacts without spin at these angles; μ must be known. Throws std::invalid_argument, and
/// NotConverged where a contact that slides has a dashpot too weak to be followed, c_t < 2e-5 k_t t_col or so.
std::vector<ObliqueRebound> rebounds(const TangentialLaw& law, double mu, const AnyLaw& normal, ContactEnd end,
                                     const Impact& impact, std::span<const double> angles);

/// Change of e_t at an angle for one percent more of each, by central differences over ±0.1 %. Where the time is
/// changed the tangential law stays as it is: with β₀ held e_t does not know the time at all.
struct ObliqueSensitivity {
  double angle = 0;                            ///< [rad]
  double tcol = 0, en = 0, beta0 = 0, mu = 0;  ///< Δe_t
};

/// Of what was found for `target` under the normal law's kind and end; μ must be known and e_n < 1/1.001. Throws
/// std::invalid_argument.
std::vector<ObliqueSensitivity> sensitivities(const TangentialCalibration& found, const TangentialRequest& request,
                                              LawKind normal, ContactEnd end, const Target& target,
                                              std::span<const double> angles);

}  // namespace ricochet::calibration
