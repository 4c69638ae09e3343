#pragma once

#include <calibrate/calibration.hpp>
#include <ricochet/detail/panel.hpp>

#include <array>
#include <vector>

namespace ricochet::calibration {

/// e_n and the scaled collision time as functions of a law's dimensionless group.
struct Reduced {
  double en, tcol;
};

/// A damped power law at k = m = v₀ = 1 as a function of ln γ (γ = c there): panels of width 1/2, on which powers of γ are
/// nearly polynomials. Outside, and where the bodies do not part (en = tcol = 0), the collision itself. Error: 1e-10.
class ForwardDamped {
 public:
  ForwardDamped(LawName law, ContactEnd end);
  Reduced operator()(double log_group) const;

 private:
  static constexpr double low = -9, width = 0.5;
  static constexpr std::size_t count = 22;
  struct Pair {
    detail::Panel en, tcol;
  };
  LawName law_;
  ContactEnd end_;
  std::vector<Pair> panels_;
};

/// The fractional law ended by force, as a function of α: e_n and τ = t_col A^{1/(2−α)}. Panels up to 0.97, the closed form
/// beyond. Error: 1e-10.
class ForwardFractional {
 public:
  ForwardFractional();
  Reduced operator()(double alpha) const;

 private:
  static constexpr std::array<double, 8> edges{0, 0.25, 0.5, 0.7, 0.82, 0.89, 0.94, 0.97};
  struct Pair {
    detail::Panel en, tau;
  };
  std::vector<Pair> panels_;
};

}  // namespace ricochet::calibration
