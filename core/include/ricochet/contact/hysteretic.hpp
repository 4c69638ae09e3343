#pragma once

#include <ricochet/contact/description.hpp>

namespace ricochet {

/// Piecewise linear loading and unloading of Walton and Braun (J. Rheol. 30, 949 (1986)): k₁ζ on first loading,
/// k₂(ζ − ζ₀) on unloading and reloading below the greatest overlap so far, ζ₀ = ζ_max(1 − k₁/k₂).
class Hysteretic {
 public:
  struct Memory {
    double max_overlap = 0;  ///< greatest overlap since t_b [m]
    bool operator==(const Memory&) const = default;
  };
  static constexpr std::string_view name = "hysteretic";
  static constexpr std::array<Parameter, 2> parameters{
      {{"k1", {4, 0, -8}, domains::positive}, {"k2", {4, 0, -8}, domains::positive}}};
  static constexpr Ends ends{.overlap = false, .both_by_default = false};

  /// 0 < k1 ≤ k2 [kg/s²]; throws std::invalid_argument otherwise.
  Hysteretic(double k1, double k2) : k1_(k1), k2_(k2) {
    require_parameters<Hysteretic>(values());
    support::require(k1 <= k2, "k1", k1, "at most k2");
  }

  double k1() const noexcept { return k1_; }
  double k2() const noexcept { return k2_; }
  std::array<double, 2> values() const noexcept { return {k1_, k2_}; }
  static Hysteretic from(const std::array<double, 2>& values) { return {values[0], values[1]}; }
  /// What a restitution tells where nothing tells the time: e_n² = k₁/k₂.
  NamedValue loss_measure() const { return {"k1/k2", k1_ / k2_, ""}; }
  /// ζ₀ [m]: where unloading from the greatest overlap so far reaches zero force.
  double residual_overlap(const Memory& m) const noexcept { return m.max_overlap * (1 - k1_ / k2_); }

  double force(Approach a, const Memory& m) const noexcept {
    return loads(a, m) ? k1_ * a.overlap : k2_ * (a.overlap - residual_overlap(m));
  }
  void advance(Memory& m, Approach, Approach after, double) const noexcept {
    m.max_overlap = std::max(m.max_overlap, after.overlap);
  }
  /// ½R²/k₂ for either sign of R: a spring k₂ about ζ₀, which first loading tightens and shifts. Unloading and
  /// reloading only work that spring; loading stores the part k₁/k₂ of its work and burns the rest.
  double stored_energy(Approach a, const Memory& m) const noexcept {
    const double f = force(a, m);
    return 0.5 * f * f / k2_;
  }
  double dissipated_power(Approach a, const Memory& m) const noexcept {
    return loads(a, m) && a.rate > 0 ? k1_ * (1 - k1_ / k2_) * a.overlap * a.rate : 0.0;
  }

 private:
  static bool loads(Approach a, const Memory& m) noexcept { return a.overlap >= m.max_overlap; }

  double k1_, k2_;
};

}  // namespace ricochet
