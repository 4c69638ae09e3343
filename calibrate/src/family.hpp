#pragma once

#include <calibrate/calibration.hpp>

namespace ricochet::calibration {

/// Where a search stands, in the units of the target (m = v₀ = t_col = 1): the logarithm of the law's stiffness and a
/// logarithmic measure of the loss; −∞ of the latter is the elastic law.
///   linear, kuwabara-kono, tsuji: ln k, ln c       hysteretic: ln k₁, ln(k₂/k₁ − 1)
///   fractional: ln c^α k^{1−α}, ln(α/(1−α))
struct Coordinates {
  double scale;
  double loss;
};

/// The law at `x`, in the units of the target. The fractional law's k and c are both c^α k^{1−α} there.
AnyLaw scaled_law(LawName law, const Coordinates& x);

/// The law whose collision takes 1 instead of the `tcol` that scaled_law(law, {0, loss}) takes, at the same e_n.
Coordinates with_unit_tcol(LawName law, double loss, double tcol);

/// A law in the units of the target brought to SI; `held_stiffness` is the fractional law's k [kg/s²].
/// nullopt where a parameter, such as the c that goes with the held k, is no normal double.
std::optional<AnyLaw> in_si(const AnyLaw& scaled, const Target& target, double held_stiffness);

}  // namespace ricochet::calibration
