#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace ricochet {

/// The times that a memory kernel is made for, and how well it keeps them.
struct MemoryWindow {
  double shortest;   ///< δ [s]: the shortest step
  double longest;    ///< T [s]: the longest contact
  double tolerance;  ///< relative error on [δ, T]
};

/// One Maxwell arm of a memory kernel: strength·exp(−rate·t).
struct Arm {
  double strength;  ///< > 0 [s^{−α}]
  double rate;      ///< > 0 [1/s]
};

/// The kernel of the Caputo derivative of order α as a spring, Maxwell arms and a dashpot,
///   t^{−α}/Γ(1−α) ≈ spring + Σ strength_j exp(−rate_j t) + dashpot δ(t),
/// every coefficient positive, so that each part only stores or dissipates. Immutable.
///
/// What it promises, with k the true kernel, K its spring and arms, and δ = shortest(), T = longest():
/// - on [δ, T]: |K(t) − k(t)| ≤ error()·k(t);
/// - on (0, δ): ∫K + dashpot = ∫k to rounding, and ∫τK = ∫τk to 1e-3 of the tolerance asked for, relative (where the
///   exchange of points stops; to rounding where that is 1e-10 or finer). So the derivative of a function whose rate
///   is linear over the last δ is exact but for this and error(): stepping with linear rates and steps ≥ δ is the
///   product trapezoid rule, second order in the step; for any smooth rate what the dashpot misses is O(δ^{3−α}), and
///   the impulse of a force that starts with a jump of the rate is right at once.
class MemoryKernel {
 public:
  double alpha() const noexcept { return alpha_; }
  double shortest() const noexcept { return shortest_; }  ///< δ [s]
  double longest() const noexcept { return longest_; }    ///< T [s]
  double spring() const noexcept { return spring_; }      ///< [s^{−α}]; 0 for α = 1
  double dashpot() const noexcept { return dashpot_; }    ///< [s^{1−α}]; 0 for α = 0
  std::span<const Arm> arms() const noexcept { return arms_; }

  /// Largest relative error on [δ, T] of the finished (rounded) coefficients: the highest top of all its waves, each
  /// found by Newton's method, and the two ends; rounded up. K in exact arithmetic keeps it. Larger than the asked
  /// tolerance only if max_kernel_arms did not suffice.
  double error() const noexcept { return error_; }

  /// K(t), spring and arms, at t ≥ 0 [s].
  double operator()(double t) const noexcept;

 private:
  friend MemoryKernel memory_kernel(double alpha, const MemoryWindow& window);
  MemoryKernel() = default;

  double alpha_ = 0, shortest_ = 0, longest_ = 0, spring_ = 0, dashpot_ = 0, error_ = 0;
  std::vector<Arm> arms_;
};

/// Most arms that memory_kernel spends: enough for 1e-12 up to longest/shortest = 1e6.
inline constexpr std::size_t max_kernel_arms = 64;

/// Builds the kernel for 0 ≤ alpha ≤ 1, steps ≥ shortest [s] and contacts ≤ longest [s], with the fewest arms that
/// hold the relative error `tolerance` on [shortest, longest] together with the two moments above.
/// Domain: 1e-200 ≤ shortest ≤ 1e200, shortest ≤ longest ≤ 1e6·shortest, 1e-12 ≤ tolerance ≤ 0.1. Throws
/// std::invalid_argument otherwise. α = 0 (spring 1) and α = 1 (dashpot 1) are exact and need no arm.
///
/// Method: t^{−α} is completely monotone, so by the theory of Chebyshev systems (Karlin & Studden 1966) exactly one
/// positive sum of n exponentials and a constant meets it at 2n given points and shares its first moment on (0, δ): a
/// generalised Gauss quadrature of its Laplace integral. Newton's method in the logarithms of strengths and rates
/// finds it; n grows one by one, each solution starting the next, and the points are those of the best approximation
/// (Braess & Hackbusch, IMA J. Numer. Anal. 25, 685 (2005)), found by exchange for small n and carried on by
/// interpolation. docs/theory/memory_kernel.md has the derivation and the counts.
MemoryKernel memory_kernel(double alpha, const MemoryWindow& window);

inline MemoryKernel memory_kernel(double alpha, double shortest, double longest, double tolerance) {
  return memory_kernel(alpha, {shortest, longest, tolerance});
}

/// The best kernel that `most_arms` arms carry: where the window's tolerance needs more, it gives way tenfold, and
/// error() says to what. Throws std::invalid_argument as memory_kernel does, and where not even 0.1 can be kept.
MemoryKernel affordable_kernel(double alpha, const MemoryWindow& window, std::size_t most_arms);

}  // namespace ricochet
