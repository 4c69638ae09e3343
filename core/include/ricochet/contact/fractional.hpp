#pragma once

#include <ricochet/contact/description.hpp>
#include <ricochet/fractional/memory_kernel.hpp>

#include <array>
#include <cstddef>
#include <vector>

namespace ricochet {

/// The fractional interaction law (30): R = c^α k^{1−α} D^α ζ, D^α from the contact's start t_b. The ideal law: its
/// memory is the whole past, so it has closed forms and solvers but no `force`; `FractionalArms` is what engines run.
class Fractional {
 public:
  static constexpr std::string_view name = "fractional";
  static constexpr std::array<Parameter, 3> parameters{
      {{"k", {4, 0, -8}, domains::positive},
       {"c", {4, 0, -4}, domains::positive},
       {"alpha", {}, {"finite and < 2", [](double x) { return std::isfinite(x) && x < 2; }}}}};
  static constexpr Ends ends{.overlap = true, .both_by_default = false};

  /// k > 0 [kg/s²], c > 0 [kg/s], α < 2; 0 ≤ α ≤ 1 is physical (α < 0 gains energy, α ≥ 1 never rebounds).
  /// Throws std::invalid_argument otherwise.
  Fractional(double k, double c, double alpha);

  double k() const noexcept { return k_; }
  double c() const noexcept { return c_; }
  double alpha() const noexcept { return alpha_; }
  std::array<double, 3> values() const noexcept { return {k_, c_, alpha_}; }
  static Fractional from(const std::array<double, 3>& values) { return {values[0], values[1], values[2]}; }
  std::vector<NamedValue> identifiable() const {
    return {{"alpha", alpha_, ""}, {"c^alpha k^(1-alpha)", coefficient_, "kg s^(alpha-2)"}};
  }
  /// c^α k^{1−α} [kg s^{α−2}], all of k and c that a collision can see.
  double coefficient() const noexcept { return coefficient_; }
  /// α ≥ 1, as far as the rounding of 2−α, the order of the motion's equation, tells it from 1.
  bool force_fades() const noexcept { return 2 - alpha_ <= 1; }

 private:
  double k_, c_, alpha_, coefficient_;
};

/// The fractional law with D^α carried by a MemoryKernel: spring, Maxwell arms and dashpot,
///   R = spring·ζ + Σ stiffness_j q_j + dashpot·ζ',   q_j' = ζ' − rate_j q_j,   q_j(t_b) = 0.
/// Its memory is the elongation q_j of each arm's spring, of fixed size whatever the contact's duration; a step costs
/// three multiplications an arm. `advance` is exact (to rounding) for a rate linear over the step, so the only errors
/// are the kernel's (see MemoryKernel) and the caller's interpolation of the rate.
class FractionalArms {
 public:
  /// Enough for a kernel error of 1e-12 over 100 shortest steps, 1e-10 over 1000 and 1e-6 over 1e5.
  static constexpr std::size_t max_arms = 24;
  struct Memory {
    std::array<double, max_arms> elongation{};  ///< [m]; those past the number of arms stay 0
    bool operator==(const Memory&) const = default;
  };
  static constexpr std::string_view name = "fractional";

  /// `kernel` is prepared for the law's α; `step` [s] > 0 is the time step that `advance` is fastest for (any other
  /// dt is as exact). Throws std::invalid_argument for another α or a kernel of more than max_arms arms.
  FractionalArms(const Fractional& law, const MemoryKernel& kernel, double step);

  const Fractional& law() const noexcept { return law_; }
  bool force_fades() const noexcept { return law_.force_fades(); }
  double step() const noexcept { return step_; }  ///< [s]
  std::size_t arms() const noexcept { return arms_; }
  double spring() const noexcept { return spring_; }                             ///< [N/m]
  double dashpot() const noexcept { return dashpot_; }                           ///< [N s/m]
  double stiffness(std::size_t arm) const noexcept { return stiffness_[arm]; }   ///< [N/m]
  double relaxation_rate(std::size_t arm) const noexcept { return rate_[arm]; }  ///< [1/s]

  double force(Approach a, const Memory& m) const noexcept;
  void advance(Memory& m, Approach before, Approach after, double dt) const noexcept;
  /// How much the force after `advance` over dt grows with the rate at its end [N s/m].
  double rate_gain(double dt) const noexcept { return dt == step_ ? step_gain_ : gain_over(dt); }
  /// `advance` over dt = step() and `force` at its end in one pass, for an engine that keeps the elongations in an
  /// array of its own of Slots ≥ arms() values, even, those past arms() being 0. Sums even and odd arms apart: it is
  /// bound by the latency of one sum otherwise.
  template <std::size_t Slots>
  double advance_step(double* elongation, Approach before, Approach after) const noexcept {
    static_assert(Slots % 2 == 0 && Slots <= max_arms);
    double sum[2] = {spring_ * after.overlap, dashpot_ * after.rate};
    for (std::size_t j = 0; j < Slots; j += 2)
      for (std::size_t lane = 0; lane < 2; ++lane) {
        double& q = elongation[j + lane];
        q = decay_[j + lane] * q + (gain_before_[j + lane] * before.rate + gain_after_[j + lane] * after.rate);
        sum[lane] += stiffness_[j + lane] * q;
      }
    return sum[0] + sum[1];
  }
  double stored_energy(Approach a, const Memory& m) const noexcept;
  double dissipated_power(Approach a, const Memory& m) const noexcept;

 private:
  double gain_over(double dt) const noexcept;

  Fractional law_;
  std::size_t arms_ = 0;
  double step_ = 0;
  double step_gain_ = 0;                                                 // rate_gain over step_ [N s/m]
  double spring_ = 0;                                                    // [N/m]
  double dashpot_ = 0;                                                   // [N s/m]
  std::array<double, max_arms> stiffness_{}, rate_{};                    // of each arm [N/m], [1/s]
  std::array<double, max_arms> decay_{}, gain_before_{}, gain_after_{};  // over step_
};

}  // namespace ricochet
