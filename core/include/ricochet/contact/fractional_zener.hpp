#pragma once

#include <ricochet/contact/description.hpp>
#include <ricochet/contact/maxwell_arms.hpp>

#include <array>
#include <vector>

namespace ricochet {

class FractionalZenerArms;

/// A spring k beside an arm of a spring k₁ and a springpot k₁τ^α D^α in series, the modulus
///   k + k₁ (sτ)^α/(1 + (sτ)^α)
/// of s the Laplace variable: stiff k + k₁ to fast motion, k to slow one. α = 1 is the standard linear solid; τ → 0 and
/// k₁ = 0 are a spring of k, τ → ∞ one of k + k₁, α = 0 one of k + k₁/2. The ideal law: its memory is the whole past,
/// so it has no `force`; `FractionalZenerArms` is what engines run.
///
/// In the units of an impact e_n depends on k₁/k, τ√(k/m) and α, not on the velocity. Along τ it falls from 1 to a
/// least value and returns to 1.
/// Source: Rossikhin & Shitikova, Appl. Mech. Rev. 63, 010801 (2010).
class FractionalZener {
 public:
  using Arms = FractionalZenerArms;
  static constexpr std::string_view name = "fractional-zener";
  static constexpr std::array<Parameter, 4> parameters{{{"k", {4, 0, -8}, domains::positive},
                                                        {"k1", {4, 0, -8}, domains::not_negative},
                                                        {"tau", {0, 0, 4}, domains::positive},
                                                        {"alpha", {}, domains::degree}}};
  static constexpr Ends ends{.overlap = false, .both_by_default = false};

  /// k > 0 and k1 ≥ 0 [kg/s²], tau > 0 [s], 0 ≤ α ≤ 1; throws std::invalid_argument otherwise.
  FractionalZener(double k, double k1, double tau, double alpha) : k_(k), k1_(k1), tau_(tau), alpha_(alpha) {
    require_parameters<FractionalZener>(values());
  }

  double k() const noexcept { return k_; }
  double k1() const noexcept { return k1_; }
  double tau() const noexcept { return tau_; }
  double alpha() const noexcept { return alpha_; }
  std::array<double, 4> values() const noexcept { return {k_, k1_, tau_, alpha_}; }
  static FractionalZener from(const std::array<double, 4>& values) {
    return {values[0], values[1], values[2], values[3]};
  }
  /// What (t_col, e_n) tell where α and k₁/k are held.
  std::vector<NamedValue> identifiable() const {
    return {{"k", k_, parameters[0].unit()}, {"tau", tau_, parameters[2].unit()}};
  }

 private:
  double k_, k1_, tau_, alpha_;
};

/// The same on Maxwell arms. The arms of a kernel, in series with a spring, are arms again: with A(s) the modulus of
/// the springpot's, k₁A/(k₁ + A) has its poles −r where k₁ + A(−r) = 0, one between any two rates of A, and positive
/// residues. So the arms are as many as the kernel's, and one more where that has a dashpot; the step is the same.
class FractionalZenerArms : public MaxwellArms {
 public:
  static constexpr std::string_view name = FractionalZener::name;
  // cppcheck-suppress duplInheritedMember ; fewer than of the laws whose kernel is all that they have
  static constexpr std::size_t max_kernel_arms = max_arms - 1;

  /// As FractionalArms, for a kernel of at most max_kernel_arms arms.
  FractionalZenerArms(const FractionalZener& law, const MemoryKernel& kernel, double step)
      : MaxwellArms(parts(law, kernel), step), law_(law) {}

  const FractionalZener& law() const noexcept { return law_; }

 private:
  static Parts parts(const FractionalZener& law, const MemoryKernel& kernel);

  FractionalZener law_;
};

}  // namespace ricochet
