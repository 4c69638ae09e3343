#pragma once

#include <ricochet/contact/law.hpp>

namespace ricochet {

/// Linear spring and dashpot: R = kζ + cζ'. "linear1" ends by overlap, "linear2" by force (see ContactEnd).
class Linear {
 public:
  using Memory = NoMemory;
  static constexpr std::string_view name = "linear";

  /// k > 0 [kg/s²], c ≥ 0 [kg/s]; throws std::invalid_argument otherwise.
  Linear(double k, double c);

  double k() const noexcept { return k_; }
  double c() const noexcept { return c_; }

  double force(Approach a, const Memory&) const noexcept { return k_ * a.overlap + c_ * a.rate; }
  void advance(Memory&, Approach, Approach, double) const noexcept {}
  double stored_energy(Approach a, const Memory&) const noexcept { return 0.5 * k_ * a.overlap * a.overlap; }
  double dissipated_power(Approach a, const Memory&) const noexcept { return c_ * a.rate * a.rate; }

 private:
  double k_, c_;
};

}  // namespace ricochet
