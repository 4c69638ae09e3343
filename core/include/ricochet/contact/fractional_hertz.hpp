#pragma once

#include <ricochet/contact/description.hpp>
#include <ricochet/contact/maxwell_arms.hpp>

#include <array>
#include <cmath>
#include <vector>

namespace ricochet {

class FractionalHertzArms;

/// Hertz's spring beside its fractional derivative, R = k f + c D^α f with f = ζ^{3/2}, D^α from the contact's start.
/// α = 1 is Kuwabara and Kono's law, whose c is 3/2 of this one; α = 0 Hertz's with k + c, c = 0 with k; k = 0 the pure
/// power law. The ideal law: its memory is the whole past, so it has no `force`; `FractionalHertzArms` is what engines
/// run.
///
/// In the units of an impact, time T_H = (m²/(k²v₀))^{1/5}, all that is left of the parameters is α and the group
/// g = (c/k) T_H^{−α}: for little loss 1 − e_n goes with g, so with v₀^{α/5}; with k = 0 it depends on α alone.
class FractionalHertz {
 public:
  using Arms = FractionalHertzArms;
  static constexpr std::string_view name = "fractional-hertz";
  static constexpr std::array<Parameter, 3> parameters{{{"k", {4, -2, -8}, domains::not_negative},
                                                        {"c", {4, -2, -8, 4}, domains::not_negative},
                                                        {"alpha", {}, domains::degree}}};
  static constexpr Ends ends{.overlap = false, .both_by_default = false};

  /// k ≥ 0 [kg/(s² m^{1/2})], c ≥ 0 [kg s^{α−2}/m^{1/2}], one of them > 0, 0 ≤ α ≤ 1; throws std::invalid_argument
  /// otherwise.
  FractionalHertz(double k, double c, double alpha) : k_(k), c_(c), alpha_(alpha) {
    require_parameters<FractionalHertz>(values());
    support::require(k > 0 || c > 0, "c", c, "finite and > 0 where k = 0");
  }

  double k() const noexcept { return k_; }
  double c() const noexcept { return c_; }
  double alpha() const noexcept { return alpha_; }
  std::array<double, 3> values() const noexcept { return {k_, c_, alpha_}; }
  static FractionalHertz from(const std::array<double, 3>& values) { return {values[0], values[1], values[2]}; }
  /// What (t_col, e_n) tell where α is held.
  std::vector<NamedValue> identifiable() const {
    return {{"k", k_, parameters[0].unit()}, {"c", c_, parameters[1].unit()}};
  }
  /// A dashpot alone never rebounds.
  bool force_fades() const noexcept { return k_ == 0 && alpha_ == 1; }

 private:
  double k_, c_, alpha_;
};

/// The same on Maxwell arms: those of c D^α beside k, stretched by f = ζ^{3/2} in the place of ζ,
///   R = (k + spring) f + Σ stiffness_j q_j + dashpot·f',   q_j' = f' − rate_j q_j.
/// `advance` is exact where f' is the parabola with its true values at both ends of the step and its true integral; it
/// is so for every rate linear over the step but for O(dt⁴) of f.
///
/// Energy. An arm that is unloaded at once from elongation q at f gives back, until its force is gone at f − q = w,
///   ψ = ∫_w^f stiffness (φ − w) dζ(φ) = stiffness (2/5 f^{5/3} − w f^{2/3} + 3/5 w^{5/3}),
/// which is what it stores; held still it loses stiffness·rate·q (f^{2/3} − w^{2/3}), which is never negative, as w
/// exceeds f just where q < 0. So the law only stores and dissipates: docs/theory/solids.md.
class FractionalHertzArms : public MaxwellArms {
 public:
  static constexpr std::string_view name = FractionalHertz::name;

  /// As FractionalArms.
  FractionalHertzArms(const FractionalHertz& law, const MemoryKernel& kernel, double step);

  const FractionalHertz& law() const noexcept { return law_; }
  bool force_fades() const noexcept { return law_.force_fades(); }

  /// f = ζ^{3/2} and its rate, 0 for ζ ≤ 0.
  static Approach stretched(Approach a) noexcept {
    if (!(a.overlap > 0)) return {0, 0};
    const double root = std::sqrt(a.overlap);
    return {a.overlap * root, 1.5 * root * a.rate};
  }

  double force(Approach a, const Memory& m) const noexcept { return MaxwellArms::force(stretched(a), m); }
  void advance(Memory& m, Approach before, Approach after, double dt) const noexcept;
  /// How much the force after `advance` over dt to that overlap grows with the rate at its end [N s/m].
  double rate_gain(double dt, double overlap) const noexcept;
  double stored_energy(Approach a, const Memory& m) const noexcept;
  double dissipated_power(Approach a, const Memory& m) const noexcept;
  /// See mean_force.hpp.
  double mean_force(double overlap, double rate, const Memory& m, double dt) const noexcept;

 private:
  static Parts parts(const FractionalHertz& law, const MemoryKernel& kernel) {
    Parts all = fractional_parts(law.c(), law.alpha(), kernel);
    all.spring += law.k();
    return all;
  }

  /// What an arm makes of a parabola of f' over a step: the exponential and φ₁ … φ₄ of rate·dt.
  struct Moments {
    double decay, mean, falling, falling_once, fourth;
  };
  static Moments moments_of(double x) noexcept;
  Moments moments(std::size_t arm, double dt) const noexcept {
    return dt == step() ? at_step_[arm] : moments_of(relaxation_rate(arm) * dt);
  }

  FractionalHertz law_;
  std::array<Moments, max_arms> at_step_{};  // they cost more than all else that an arm does
};

}  // namespace ricochet
