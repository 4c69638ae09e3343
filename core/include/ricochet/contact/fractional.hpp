#pragma once

#include <ricochet/contact/description.hpp>
#include <ricochet/contact/maxwell_arms.hpp>
#include <ricochet/fractional/memory_kernel.hpp>

#include <array>
#include <vector>

namespace ricochet {

class FractionalArms;

/// The fractional interaction law (30): R = c^α k^{1−α} D^α ζ, D^α from the contact's start t_b. The ideal law: its
/// memory is the whole past, so it has closed forms and solvers but no `force`; `FractionalArms` is what engines run.
class Fractional {
 public:
  using Arms = FractionalArms;
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

/// The fractional law with D^α carried by a MemoryKernel, as MaxwellArms.
class FractionalArms : public MaxwellArms {
 public:
  static constexpr std::string_view name = Fractional::name;

  /// `kernel` is prepared for the law's α; `step` [s] > 0 is the time step that `advance` is fastest for (any other
  /// dt is as exact). Throws std::invalid_argument for another α or a kernel of more than max_arms arms.
  FractionalArms(const Fractional& law, const MemoryKernel& kernel, double step)
      : MaxwellArms(fractional_parts(law.coefficient(), law.alpha(), kernel), step), law_(law) {}

  const Fractional& law() const noexcept { return law_; }
  bool force_fades() const noexcept { return law_.force_fades(); }

 private:
  Fractional law_;
};

}  // namespace ricochet
