#pragma once

#include <ricochet/contact/law.hpp>

#include <cmath>

namespace ricochet {

/// Hertzian spring with the viscous term of Kuwabara and Kono, the paper's "nonlinear" law: R = kζ^{3/2} + cζ^{1/2}ζ'.
/// ζ < 0 counts as no overlap.
class KuwabaraKono {
 public:
  using Memory = NoMemory;
  static constexpr std::string_view name = "kuwabara-kono";

  /// k > 0 [kg/(s² m^{1/2})], c ≥ 0 [kg/(s m^{1/2})]; throws std::invalid_argument otherwise.
  KuwabaraKono(double k, double c);

  double k() const noexcept { return k_; }
  double c() const noexcept { return c_; }

  double force(Approach a, const Memory&) const noexcept { return root(a) * (k_ * a.overlap + c_ * a.rate); }
  void advance(Memory&, Approach, Approach, double) const noexcept {}
  double stored_energy(Approach a, const Memory&) const noexcept { return 0.4 * k_ * a.overlap * a.overlap * root(a); }
  double dissipated_power(Approach a, const Memory&) const noexcept { return c_ * root(a) * a.rate * a.rate; }

 private:
  static double root(Approach a) noexcept { return std::sqrt(std::max(0.0, a.overlap)); }

  double k_, c_;
};

}  // namespace ricochet
