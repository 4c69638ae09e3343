#pragma once

namespace ricochet {

/// Two laws in ζ alone that are put in the place of a power-law sphere. Both are Hertz at α = 0 and the viscous form of
/// Kuwabara and Kono at α = 1; which of the two is meant is seldom said.
enum class HertzianForm {
  derivative_of_power,  ///< R = K D^α ζ^{3/2}: the sphere while the contact grows
  power_of_derivative   ///< R = (3/2) K ζ^{1/2} D^α ζ: Kuwabara and Kono's with D^α in the place of the rate
};

struct HertzianRebound {
  double en;
  double tcol;  ///< of m = v₀ = 1 and the constant before ζ^{3/2} or ζ^{1/2} 1
  int terms;    ///< of the series
};

/// The impact m ζ'' + R = 0 until R = 0. In t^{5/2−α} the motion is a power series as the sphere's approach is; what it
/// is beyond its circle Wynn's epsilon sums (the diagonal Padé approximants). Error: 1e-9 relative, less from α = 0.1
/// on. Domain: 0.05 ≤ α ≤ 0.8; throws std::invalid_argument otherwise. For studies.
HertzianRebound hertzian_rebound(HertzianForm form, double alpha);

}  // namespace ricochet
