#pragma once

#include <calibrate/calibration.hpp>
#include <ricochet/support/panel.hpp>

#include <array>
#include <vector>

namespace ricochet::calibration {

/// e_n and the scaled collision time as functions of a law's dimensionless group.
struct Reduced {
  double en, tcol;
};

/// A damped power law at k = m = v₀ = 1 as a function of ln γ (γ = c there): panels of width 1/2, on which powers of γ
/// are nearly polynomials. Outside, and where the bodies do not part (en = tcol = 0), the collision itself. Error:
/// 1e-10.
class ForwardDamped {
 public:
  ForwardDamped(LawName law, ContactEnd end);
  Reduced operator()(double log_group) const;

 private:
  static constexpr double low = -9, width = 0.5;
  static constexpr std::size_t count = 22;
  struct Pair {
    support::Panel en, tcol;
  };
  LawName law_;
  ContactEnd end_;
  std::vector<Pair> panels_;
};

/// The fractional law as a function of α: e_n and τ = t_col A^{1/(2−α)}. By force, panels in α up to 0.97 and the
/// closed form beyond. By overlap e_n falls to 0 like √(overlap_limit − α), so the panels are in w = √(1 −
/// α/overlap_limit), down to w = 0.02 (e_n = 0.012). Error: 1e-10, beyond the panels that of fractional_contact.
class ForwardFractional {
 public:
  explicit ForwardFractional(ContactEnd end);
  /// 0 ≤ α < 1, or < overlap_limit; throws std::invalid_argument otherwise.
  Reduced operator()(double alpha) const;

 private:
  double variable(double alpha) const;

  ContactEnd end_;
  std::vector<double> edges_;  // of the panels, rising
  struct Pair {
    support::Panel en, tau;
  };
  std::vector<Pair> panels_;
};

}  // namespace ricochet::calibration
