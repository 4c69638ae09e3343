#pragma once

#include <ricochet/contact/law.hpp>

#include <cmath>

namespace ricochet {

/// Hertzian spring with the dashpot of Tsuji, Tanaka and Ishida (Powder Technol. 71, 239 (1992)), whose restitution
/// does not depend on the impact velocity: R = kζ^{3/2} + cζ^{1/4}ζ'. What LAMMPS, LIGGGHTS and MercuryDPM call Hertz
/// with constant restitution. ζ < 0 counts as no overlap.
class Tsuji {
 public:
  using Memory = NoMemory;
  static constexpr std::string_view name = "tsuji";

  /// k > 0 [kg/(s² m^{1/2})], c ≥ 0 [kg/(s m^{1/4})]; throws std::invalid_argument otherwise.
  Tsuji(double k, double c);

  double k() const noexcept { return k_; }
  double c() const noexcept { return c_; }

  double force(Approach a, const Memory&) const noexcept {
    const double root = std::sqrt(std::max(0.0, a.overlap));
    return k_ * a.overlap * root + c_ * std::sqrt(root) * a.rate;
  }
  void advance(Memory&, Approach, Approach, double) const noexcept {}
  double stored_energy(Approach a, const Memory&) const noexcept {
    return 0.4 * k_ * a.overlap * a.overlap * std::sqrt(std::max(0.0, a.overlap));
  }
  double dissipated_power(Approach a, const Memory&) const noexcept {
    return c_ * std::sqrt(std::sqrt(std::max(0.0, a.overlap))) * a.rate * a.rate;
  }

 private:
  double k_, c_;
};

}  // namespace ricochet
