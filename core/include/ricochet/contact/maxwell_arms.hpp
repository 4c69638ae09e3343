#pragma once

#include <ricochet/contact/law.hpp>
#include <ricochet/fractional/memory_kernel.hpp>

#include <array>
#include <concepts>
#include <cstddef>
#include <vector>

namespace ricochet {

/// A spring, Maxwell arms and a dashpot side by side,
///   R = spring·ζ + Σ stiffness_j q_j + dashpot·ζ',   q_j' = ζ' − rate_j q_j,   q_j(t_b) = 0,
/// which is what engines run of every law with a fractional memory. Its memory is the elongation q_j of each arm's
/// spring, of fixed size whatever the contact's duration; a step costs three multiplications an arm. `advance` is exact
/// (to rounding) for a rate linear over the step, so the only errors are the kernel's (see MemoryKernel) and the
/// caller's interpolation of the rate. A law is a class derived from it, with a name and the ideal law that it stands
/// for.
class MaxwellArms {
 public:
  /// Enough for a kernel error of 1e-12 over 100 shortest steps, 1e-10 over 1000 and 1e-6 over 1e5.
  static constexpr std::size_t max_arms = 24;
  struct Memory {
    std::array<double, max_arms> elongation{};  ///< [m]; those past the number of arms stay 0
    bool operator==(const Memory&) const = default;
  };
  /// Of the kernel that such a law is made of.
  static constexpr std::size_t max_kernel_arms = max_arms;
  /// What stands side by side: N/m, N s/m, and of each arm N/m and 1/s.
  struct Parts {
    double spring = 0, dashpot = 0;
    std::vector<Arm> arms;
  };

  double step() const noexcept { return step_; }  ///< [s]
  std::size_t arms() const noexcept { return arms_; }
  double spring() const noexcept { return spring_; }                             ///< [N/m]
  double dashpot() const noexcept { return dashpot_; }                           ///< [N s/m]
  double stiffness(std::size_t arm) const noexcept { return stiffness_[arm]; }   ///< [N/m]
  double relaxation_rate(std::size_t arm) const noexcept { return rate_[arm]; }  ///< [1/s]

  double force(Approach a, const Memory& m) const noexcept;
  void advance(Memory& m, Approach before, Approach after, double dt) const noexcept;
  /// The force after `advance` over dt = step(), at `after`, in one pass that leaves the memory as it is.
  double force_after(Approach before, Approach after, const Memory& m) const noexcept;
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
  /// `advance` over dt = step(), and `force`, `stored_energy` and `dissipated_power` at its end, in one pass.
  struct Reading {
    double force = 0, stored = 0, dissipated = 0;  ///< [N], [J], [W]
  };
  Reading advance_and_read(Memory& m, Approach before, Approach after) const noexcept;

 protected:
  /// `step` [s] > 0 is the time step that `advance` is fastest for (any other dt is as exact). Throws
  /// std::invalid_argument for more than max_arms arms.
  MaxwellArms(const Parts& parts, double step);

 private:
  double gain_over(double dt) const noexcept;

  std::size_t arms_ = 0;
  double step_ = 0;
  double step_gain_ = 0, step_gain_before_ = 0;        // of the force after step_ from the rates at its ends [N s/m]
  double spring_ = 0;                                  // [N/m]
  double dashpot_ = 0;                                 // [N s/m]
  std::array<double, max_arms> stiffness_{}, rate_{};  // of each arm [N/m], [1/s]
  std::array<double, max_arms> decay_{}, gain_before_{}, gain_after_{};  // over step_
  std::array<double, max_arms> held_{};                                  // of an elongation in the force after step_
};

/// A law that engines step by MaxwellArms.
template <class Law>
concept ArmsLaw = ContactLaw<Law> && std::derived_from<Law, MaxwellArms>;

/// An ideal law whose memory is the whole past: what engines run of it is `Law::Arms`, made for a step with the
/// MemoryKernel of its `alpha()` of at most `Arms::max_kernel_arms` arms.
template <class Law>
concept RemembersAll = requires(const Law& law) {
  typename Law::Arms;
  { law.alpha() } -> std::same_as<double>;
};

/// The parts of coefficient·D^α [kg s^{α−2}]. Throws std::invalid_argument for a kernel of another α or of more than
/// MaxwellArms::max_arms arms.
MaxwellArms::Parts fractional_parts(double coefficient, double alpha, const MemoryKernel& kernel);

/// The arms of one collision that takes `duration` [s], made for steps of a 400th of it: their kernel is right to 1e-9
/// from there on, or as nearly as the most arms are that a contact carries (`affordable_kernel`), and what a collision
/// makes of it to 1e-8, where en is not small. A better kernel takes ten times as long to find.
/// Throws as `affordable_kernel` does.
template <RemembersAll Law>
typename Law::Arms arms_of_collision(const Law& law, double duration) {
  using Arms = typename Law::Arms;
  const double step = duration / 400;
  return Arms(law, affordable_kernel(law.alpha(), {step, 1.05 * duration, 1e-9}, Arms::max_kernel_arms), step);
}

}  // namespace ricochet
