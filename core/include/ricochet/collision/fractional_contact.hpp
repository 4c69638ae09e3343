#pragma once

#include <ricochet/contact/law.hpp>
#include <ricochet/fractional/mittag_leffler.hpp>

namespace ricochet {

/// A binary collision under the fractional law (30) without units. With A = c^α k^{1−α}/m and y = A t^{2−α} the motion
/// (47)–(56) depends on α alone, and so does its end; E is the Mittag-Leffler function, a = 2 − α:
///   ζ = v₀ t E_{a,2}(−y),  ζ' = v₀ E_{a,1}(−y),  R = m A v₀ t^{1−α} E_{a,a}(−y).
struct FractionalContact {
  double alpha;          ///< conversion degree
  double z_star;         ///< A t_col^{2−α}
  double tau;            ///< t_col A^{1/(2−α)}
  double en;             ///< restitution, −ζ'(t_col)/v₀
  double overlap_end;    ///< ζ(t_col) [v₀ t_col]
  double z_max_overlap;  ///< A t^{2−α} at the greatest overlap
  double t_max_overlap;  ///< when the overlap is greatest [t_col]
  double max_overlap;    ///< greatest overlap [v₀ t_col]
  double t_max_force;    ///< when the force is greatest [t_col]
  double max_force;      ///< greatest force [m v₀/t_col]
};

/// The collision at conversion degree α, ended by the first zero of the force (25) for 0 ≤ α < 1, or of the overlap
/// (24) for 0 ≤ α < overlap_limit. For −1 ≤ α < 0 by that of the overlap, whichever is asked for: the force (30) still
/// repels there. Throws std::invalid_argument for another α, and for α = 1 − 1.1e-16, whose 2 − α is 1.
/// Error: 1e-12 relative by force, and 1e-16/(1 − α) more, by which the rounding of 2 − α moves e_n; by overlap
/// 1e-12 + 1e-15/e_n², as its zero nears a double one at overlap_limit. e_n is 1 at α = 0, below 1 above, above 1
/// below.
FractionalContact fractional_contact(double alpha, ContactEnd end = ContactEnd::force);

/// The overlap returns to zero only below this α: there its first minimum touches zero, E_{a,1}(−y) = E_{a,2}(−y) = 0.
inline constexpr double overlap_limit = 0.40088479367698698;

/// The least e_n that `conversion_degree` takes. Below, the rounding of α leaves nothing of it.
constexpr double least_restitution(ContactEnd end) noexcept { return end == ContactEnd::force ? 1e-15 : 1e-6; }

/// The inverse α(e_n), e_n falling from 1 at α = 0 towards 0 at α = 1 (by force) or at overlap_limit (by overlap).
/// Domain least_restitution(end) ≤ e_n ≤ 1; throws std::invalid_argument otherwise. Error: 1e-12 for 0.006 ≤ e_n ≤ 1,
/// and of the e_n of that α the error of fractional_contact.
double conversion_degree(double en, ContactEnd end = ContactEnd::force);

/// Estimate (57) of the collision time [s], read as (1.641^{1−α} Γ(4−α)/A)^{1/(2−α)}: below the exact one.
/// coefficient = A [s^{α−2}] > 0, 0 ≤ α < 1; throws std::invalid_argument otherwise.
double tcol_estimate(double coefficient, double alpha);

/// Closed-form motion of two bodies under c^α k^{1−α} D^α ζ from t_b on, never ended: also where e_n > 1 (α < 0) and
/// where nothing rebounds (α ≥ 1). Immutable.
class FractionalTrajectory {
 public:
  /// coefficient = c^α k^{1−α} [kg s^{α−2}] > 0, mass_eff [kg] > 0, velocity v₀ [m/s] > 0, −1 ≤ α < 2.
  /// Throws std::invalid_argument otherwise, and where a unit of the motion, time_scale(), v₀ or m v₀ times or over it,
  /// is no normal double.
  FractionalTrajectory(double coefficient, double alpha, double mass_eff, double velocity);

  // At t [s] ≥ 0, A t^{2−α} ≤ 1e6, where it is a double; else throws std::invalid_argument. Error: mittag_leffler's.
  double overlap(double t) const;  ///< ζ [m]
  double rate(double t) const;     ///< ζ' [m/s]
  double force(double t) const;    ///< R [N], signed; for α > 1 it is infinite at t = 0, which throws
  /// A^{−1/(2−α)} [s], the time in which the motion unfolds.
  double time_scale() const noexcept { return time_scale_; }

 private:
  double argument(double t) const;  // −A t^{2−α}

  double alpha_, mass_eff_, velocity_, time_scale_;
  MittagLeffler overlap_, rate_, force_;
};

}  // namespace ricochet
