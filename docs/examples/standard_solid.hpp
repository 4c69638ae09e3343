#pragma once

// The example of docs/adding-a-law.md; tests/motion/test_added_law.cpp runs it.

#include <ricochet/contact/law.hpp>

#include <cmath>

/// A spring beside one Maxwell arm (the standard linear solid): R = kζ + κq, q' = ζ' − q/τ, q(t_b) = 0.
class StandardSolid {
 public:
  struct Memory {
    double elongation = 0;  ///< q, of the arm's spring [m]
    bool operator==(const Memory&) const = default;
  };
  static constexpr std::string_view name = "standard-solid";

  /// k, kappa [kg/s²], tau [s].
  StandardSolid(double k, double kappa, double tau) : k_(k), kappa_(kappa), tau_(tau) {}

  double force(ricochet::Approach a, const Memory& m) const noexcept { return k_ * a.overlap + kappa_ * m.elongation; }

  /// Exact where the rate is linear over the step: q = q₀E + the response to a constant rate and to a ramp.
  void advance(Memory& m, ricochet::Approach before, ricochet::Approach after, double dt) const noexcept {
    if (!(dt > 0)) return;
    const double x = dt / tau_, gone = -std::expm1(-x);
    const double slope = (after.rate - before.rate) / dt;
    m.elongation = m.elongation * (1 - gone) + tau_ * (before.rate * gone + slope * (dt - tau_ * gone));
  }

  double stored_energy(ricochet::Approach a, const Memory& m) const noexcept {
    return 0.5 * (k_ * a.overlap * a.overlap + kappa_ * m.elongation * m.elongation);
  }
  double dissipated_power(ricochet::Approach, const Memory& m) const noexcept {
    return kappa_ * m.elongation * m.elongation / tau_;
  }

 private:
  double k_, kappa_, tau_;
};
