#pragma once

#include <ricochet/contact/maxwell_arms.hpp>

#include <array>
#include <cstddef>

namespace ricochet {

/// What a block of contacts is stepped with: the processor's base set, or AVX2.
enum class Instructions { baseline, avx2 };

/// The widest of them that this processor, its operating system and (with glibc, by g++) GLIBC_TUNABLES allow.
Instructions widest_instructions() noexcept;

/// Steps the arms of many contacts of one law together, the overlap of each going linearly from ζ₀ to ζ₁ over the step
/// h:
///   q_j ← e^{−x} q_j + φ₁(x)(ζ₁ − ζ₀),   x = rate_j h,   φ₁(x) = (1 − e^{−x})/x,
/// which is `advance` at the constant rate (ζ₁ − ζ₀)/h, and gives what an engine needs next: the law's mean force over
/// the coming step is affine in the rate ζ' that the contact then has,
///   F̄ = held + slope·ζ',   held = spring·ζ₁ + Σ stiffness_j φ₁(x) q_j,
/// which is `mean_force`. An arm is touched once a step, at three multiplications and two additions.
///
/// Error: rounding alone, 2 + slots/4 roundings of the greatest term; the kernel's error is its own (see MemoryKernel).
/// The instructions chosen do not change a bit of any result: multiplications and additions stay apart, as the base set
/// knows no fused ones, and both add up four sums, every fourth arm in one, (s₀ + s₂) + (s₁ + s₃) at the end.
class ArmsBlock {
 public:
  static constexpr std::size_t lanes = 4;
  static_assert(MaxwellArms::max_arms % lanes == 0);

  /// `step` is h [s] > 0; a contact occupies `slots` doubles, a multiple of `lanes` from the law's arms() to max_arms.
  /// Throws std::invalid_argument for others, and for instructions that the machine does not have.
  ArmsBlock(const MaxwellArms& law, double step, std::size_t slots, Instructions = widest_instructions());

  /// Steps contacts 0 … contacts−1: their elongations [m] lie one contact after the other, `slots` each, those past the
  /// law's arms 0; `before`, `after` are ζ₀, ζ₁ [m] and `held` [N] the results, one a contact. No two arrays overlap.
  void advance(std::size_t contacts, double* elongation, const double* before, const double* after,
               double* held) const noexcept {
    run_(coefficients_, contacts, elongation, before, after, held);
  }

  /// `held` of one contact whose arms were stepped otherwise (by part of a step, say).
  double held(const double* elongation, double overlap) const noexcept;
  /// [N s/m]
  double slope() const noexcept { return slope_; }

  struct Coefficients {
    double spring = 0;  // [N/m]
    // Of each arm: e^{−x}, φ₁(x), stiffness·φ₁(x) [N/m].
    alignas(32) std::array<double, MaxwellArms::max_arms> decay{}, gain{}, weight{};
  };

 private:
  using Run = void (*)(const Coefficients&, std::size_t, double*, const double*, const double*, double*) noexcept;

  Coefficients coefficients_;
  std::size_t slots_;
  double slope_;
  Run run_;
};

}  // namespace ricochet
