#pragma once

#include <ricochet/collision/collision.hpp>

#include <cstddef>
#include <optional>

namespace ricochet {

enum class LawKind { linear, kuwabara_kono, tsuji, hysteretic, fractional };

/// The ends that a law is tuned for: both for linear, Tsuji and fractional, else by force alone.
bool offers(LawKind kind, ContactEnd end) noexcept;

/// A law in the units of its impact.
struct UnitLaw {
  AnyLaw law;              ///< takes 1 where mass and velocity are 1; fractional: c = k in number
  std::size_t collisions;  ///< that it took to find it
  bool closed_form;        ///< its dimensionless group is a known function of e_n, not a bracketed root
};

/// The law of that kind that keeps e_n. Each kind has one dimensionless group that sets e_n (a closed form, but for
/// Kuwabara–Kono one bracketed root) and a scale that sets t_col. In exact arithmetic each reaches every e_n in (0, 1].
/// nullopt where a double cannot carry it: a parameter is no normal double, a collision out of range, or fractional
/// with e_n < 1e-15 (by overlap 1e-6).
/// Relative error of t_col and e_n: that of `collide`, Kuwabara–Kono 1e-10.
/// Throws std::invalid_argument unless 0 < en ≤ 1 and the kind ends so.
std::optional<UnitLaw> unit_law(LawKind kind, double en, ContactEnd end);

/// `unit_law` brought to a collision time [s] and an impact; nullopt where a parameter is then no normal double.
std::optional<AnyLaw> at_impact(const AnyLaw& unit_law, double tcol, const Impact& impact);

/// The law of that kind whose binary collision takes `tcol` [s] and keeps `en` of the velocity, at the given impact and
/// end: the first guess-free step of any study that compares laws at equal (t_col, e_n). Of the fractional law only α
/// and c^α k^{1−α} are determined; c = k in number here. Elastic contacts are left out.
/// Throws std::invalid_argument unless tcol > 0, 1e-3 ≤ en < 1, and the kind ends so; std::overflow_error where a
/// parameter is no normal double.
AnyLaw tuned_law(LawKind kind, double tcol, double en, const Impact& impact, ContactEnd end = ContactEnd::force);

/// The fractional law of conversion degree α, 0 < α < 0.97, whose binary collision takes `tcol` [s].
Fractional tuned_fractional(double alpha, double tcol, double mass_eff);

}  // namespace ricochet
