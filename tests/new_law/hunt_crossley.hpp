#pragma once

// The sixth law of tests/new_law/run: what one who adds a law to Ricochet's own writes, and all of it.

#include <ricochet/contact/description.hpp>

namespace ricochet {

/// Linear spring with the damping of K. H. Hunt and F. R. E. Crossley (J. Appl. Mech. 42, 440 (1975)), R = kζ + cζζ' =
/// kζ(1 + (c/k)ζ'): the force vanishes with the overlap, so both ends are one. With λ = v₀c/k a contact keeps e_n where
/// λ(1 + e_n) = ln((1 + λ)/(1 − λe_n)).
class HuntCrossley {
 public:
  using Memory = NoMemory;
  static constexpr std::string_view name = "hunt-crossley";
  static constexpr std::array<Parameter, 2> parameters{
      {{"k", {4, 0, -8}, domains::positive}, {"c", {4, -4, -4}, domains::not_negative}}};
  static constexpr Ends ends{.overlap = true, .both_by_default = false};

  HuntCrossley(double k, double c) : k_(k), c_(c) { require_parameters<HuntCrossley>(values()); }
  std::array<double, 2> values() const noexcept { return {k_, c_}; }
  static HuntCrossley from(const std::array<double, 2>& values) { return {values[0], values[1]}; }

  double force(Approach a, const Memory&) const noexcept { return a.overlap * (k_ + c_ * a.rate); }
  void advance(Memory&, Approach, Approach, double) const noexcept {}
  double stored_energy(Approach a, const Memory&) const noexcept { return 0.5 * k_ * a.overlap * a.overlap; }
  double dissipated_power(Approach a, const Memory&) const noexcept { return c_ * a.overlap * a.rate * a.rate; }

 private:
  double k_, c_;
};

}  // namespace ricochet
