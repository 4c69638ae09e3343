#pragma once

#include <ricochet/motion/collision.hpp>

namespace ricochet {

enum class LawKind { linear, kuwabara_kono, tsuji, hysteretic, fractional };

/// The law of that kind whose binary collision takes `tcol` [s] and keeps `en` of the velocity, at the given impact and
/// end: the first guess-free step of any study that compares laws at equal (t_col, e_n). Each kind has one dimensionless
/// group that sets e_n (a closed form, but for Kuwabara–Kono one bracketed root) and a scale that sets t_col.
/// Of the fractional law only α and c^α k^{1−α} are determined; c = k in number here. Elastic contacts are left out.
/// Relative error of t_col and e_n: 1e-11 (Kuwabara–Kono 1e-10).
/// Throws std::invalid_argument unless tcol > 0, 1e-3 ≤ en < 1, and the kind ends so (see `collide`).
AnyLaw tuned_law(LawKind kind, double tcol, double en, const Impact& impact, ContactEnd end = ContactEnd::force);

/// The fractional law of conversion degree α, 0 < α < 0.97, whose binary collision takes `tcol` [s].
Fractional tuned_fractional(double alpha, double tcol, double mass_eff);

}  // namespace ricochet
