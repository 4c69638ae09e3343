#pragma once

#include <span>
#include <vector>

namespace ricochet {

/// One Maxwell arm of a memory kernel: strength·exp(−rate·t).
struct Arm {
  double strength;  ///< > 0, in units of time^{-α}
  double rate;      ///< > 0 [1/s]
};

/// The kernel of the Caputo derivative of order α as a spring, Maxwell arms and a dashpot,
///   t^{-α}/Γ(1−α) ≈ spring + Σ strength_j exp(−rate_j t) + dashpot δ(t),
/// every coefficient positive, so that each part only stores or dissipates. Immutable.
class MemoryKernel {
 public:
  double alpha() const noexcept { return alpha_; }
  double shortest() const noexcept { return shortest_; }  ///< δ [s]
  double longest() const noexcept { return longest_; }    ///< T [s]
  double spring() const noexcept { return spring_; }      ///< [s^{-α}]
  double dashpot() const noexcept { return dashpot_; }    ///< [s^{1−α}]
  std::span<const Arm> arms() const noexcept { return arms_; }
  double error() const noexcept { return error_; }  ///< a-posteriori relative error on [δ, T]

 private:
  friend MemoryKernel memory_kernel(double alpha, double shortest, double longest, double tolerance);
  MemoryKernel() = default;

  double alpha_ = 0, shortest_ = 0, longest_ = 0, spring_ = 0, dashpot_ = 0, error_ = 0;
  std::vector<Arm> arms_;
};

/// Builds the kernel for 0 ≤ alpha ≤ 1, steps ≥ shortest [s] and contacts ≤ longest [s], to the relative error
/// `tolerance` on [shortest, longest].
MemoryKernel memory_kernel(double alpha, double shortest, double longest, double tolerance);

}  // namespace ricochet
