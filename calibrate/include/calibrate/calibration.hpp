#pragma once

#include <ricochet/contact/laws.hpp>
#include <ricochet/collision/reduction.hpp>

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ricochet::calibration {

/// "overlap" or "force".
std::string_view text(ContactEnd end) noexcept;

/// Where tcol, velocity, mass_eff and stiffness must lie, in SI units: powers and products of them stay within the
/// range of a double.
inline constexpr double least_scale = 1e-30, greatest_scale = 1e30;
inline constexpr const char* range_of_scales = "in [1e-30, 1e30]";

/// What the collision shall do.
struct Target {
  double tcol = 0;  ///< [s], > 0
  double en = 0;    ///< in (0, 1]
  Impact impact;    ///< the velocity and effective mass it shall do it at
};

struct Request {
  LawKind law;
  ContactEnd end = ContactEnd::force;
  Target target;
  /// The k to hold [kg/s²]. fractional: default that of linear, ended by force. fractional-kelvin-voigt: its α then
  /// follows, and `held.alpha` is not asked.
  std::optional<double> stiffness = {};
  Held held = {};  ///< what (tcol, en) leave open of the laws of real solids
};

enum class Method { nlopt, direct };
std::string_view text(Method method) noexcept;

struct Settings {
  Method method = Method::nlopt;
  std::string algorithm = "LN_BOBYQA";  ///< one of `algorithms()`
  double tolerance = 1e-10;             ///< relative, in tcol and en; in [1e-11, 0.1]
};

/// NLopt's local algorithms that reach the tolerance on every law from the blind start. The others do not: L-BFGS, VAR2
/// and truncated Newton stop at residuals near 1e-8, MMA, CCSAQ and COBYLA need thousands of collisions at e_n = 0.01,
/// and NEWUOA refuses one unknown.
const std::vector<std::string>& algorithms();

/// A constant load that a contact was followed under.
struct UnderLoad {
  double load;            ///< [N]
  double least_velocity;  ///< below it the bodies do not come off, and e_n is not defined [m/s]
  bool clears;            ///< they get out of the overlap that is left against the load alone
};

struct Calibration {
  Request request;  ///< that it answers
  AnyLaw law;
  ContactEnd end;
  Collision achieved;                   ///< of `law`, by the numerical path; see `remarks`
  double tcol_residual, en_residual;    ///< (achieved − target)/target
  std::optional<double> tcol_estimate;  ///< fractional, ended by force: Eq. (57) [s]
  Method method;                        ///< that found `law`: direct, too, where nlopt was worse (see calibrate)
  std::string algorithm;                ///< NLopt's, or "bracketed root" or "closed form" of the direct reduction
  std::size_t evaluations;              ///< collisions that `method` tried
  Method cross_method;                  ///< the other one
  double cross_difference;              ///< greatest relative difference of an identifiable parameter between the two
  /// What is not as usual: that the search missed the tolerance, how far the numerical path can confirm.
  std::vector<std::string> remarks = {};
  std::optional<UnderLoad> under_load = {};
};

/// A target outside what the law can do.
struct Infeasible {
  LawKind law;
  ContactEnd end;
  std::string reason;
  /// What is out of range ("en", "stiffness", "alpha"), its value and the range computed for it; empty: there is none.
  std::string quantity;
  double asked = 0, lowest = 0, highest = 0;
  bool open = false;      ///< `highest` itself is out of reach
  bool low_open = false;  ///< and so is `lowest`
};

using Outcome = std::variant<Calibration, Infeasible>;

/// A computation whose result contradicts its check, or that has none.
class NotConverged : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Finds the law whose collision takes target.tcol and keeps target.en of the velocity.
///
/// Both methods work in the units of the target (m, tcol, v₀), where every law has one dimensionless group that sets
/// e_n and one scale that sets t_col. `direct` solves for the group by a closed form or a bracketed root and reads the
/// scale off one collision. `nlopt` minimises ln²(t/t_col) + ln²(ln e/ln e_n) over the logarithms of the parameters,
/// starting from parameters that are 1 in those units. The chosen one is answered, the other cross-checks it, and the
/// answer is run through the numerical collision. Where nlopt was chosen and missed the tolerance, the answer is
/// direct's; and also where it met the tolerance in e_n, but not in the parameters: close to e_n = 1 the rounding of a
/// collision hides −ln e_n, with which they go, from a search.
///
/// In exact arithmetic every e_n in (0, 1] can be reached, but for the laws of real solids: at what is held of them
/// none keeps less than `restitution_bound`. Infeasible are also those to which the rounding of parameters to doubles
/// leaves a relative error above the tolerance (1e-16 L³, L = |ln e_n|, for linear by overlap, 1e-15 L³ for tsuji,
/// 1e-15/e_n² for fractional and fractional-kelvin-voigt by overlap, 2e-16/(1 − α) for fractional by force), and those
/// with a parameter that is no normal double. What the check cannot confirm to the tolerance, because its own error
/// bound (see `collide`) is larger, is answered with a remark.
///
/// Throws std::invalid_argument for a target, stiffness, what is held, algorithm or tolerance outside its domain and
/// for an end that the law does not offer; NotConverged when the check contradicts the answer.
Outcome calibrate(const Request& request, const Settings& settings = {});

}  // namespace ricochet::calibration
