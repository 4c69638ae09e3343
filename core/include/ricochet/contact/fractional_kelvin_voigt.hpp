#pragma once

#include <ricochet/contact/description.hpp>
#include <ricochet/contact/maxwell_arms.hpp>

#include <array>
#include <vector>

namespace ricochet {

class FractionalKelvinVoigtArms;

/// A spring beside a springpot, R = kζ + c D^α ζ, D^α from the contact's start t_b: a solid that creeps to a finite
/// stiffness. α = 1 is the linear law, α = 0 a spring of k + c, c = 0 one of k. The ideal law: its memory is the whole
/// past, so it has no `force`; `FractionalKelvinVoigtArms` is what engines run.
///
/// In the units of an impact, time √(m/k), all that is left of the parameters is α and the group
/// g = (c/k) (k/m)^{α/2}: e_n depends on these two and not on the velocity.
/// Source: Rossikhin & Shitikova, Appl. Mech. Rev. 63, 010801 (2010), for the contact models of which it is the first.
class FractionalKelvinVoigt {
 public:
  using Arms = FractionalKelvinVoigtArms;
  static constexpr std::string_view name = "fractional-kelvin-voigt";
  static constexpr std::array<Parameter, 3> parameters{{{"k", {4, 0, -8}, domains::positive},
                                                        {"c", {4, 0, -8, 4}, domains::not_negative},
                                                        {"alpha", {}, domains::degree}}};
  static constexpr Ends ends{.overlap = true, .both_by_default = false};

  /// k > 0 [kg/s²], c ≥ 0 [kg s^{α−2}], 0 ≤ α ≤ 1; throws std::invalid_argument otherwise.
  FractionalKelvinVoigt(double k, double c, double alpha) : k_(k), c_(c), alpha_(alpha) {
    require_parameters<FractionalKelvinVoigt>(values());
  }

  double k() const noexcept { return k_; }
  double c() const noexcept { return c_; }
  double alpha() const noexcept { return alpha_; }
  std::array<double, 3> values() const noexcept { return {k_, c_, alpha_}; }
  static FractionalKelvinVoigt from(const std::array<double, 3>& values) { return {values[0], values[1], values[2]}; }
  /// What (t_col, e_n) tell where α is held.
  std::vector<NamedValue> identifiable() const {
    return {{"k", k_, parameters[0].unit()}, {"c", c_, parameters[1].unit()}};
  }
  /// What a restitution tells where nothing tells the time, α being held.
  static NamedValue loss_measure(double group) { return {"(c/k) (k/m)^(alpha/2)", group, ""}; }

 private:
  double k_, c_, alpha_;
};

/// The same on Maxwell arms, k beside the springpot's own.
class FractionalKelvinVoigtArms : public MaxwellArms {
 public:
  static constexpr std::string_view name = FractionalKelvinVoigt::name;

  /// As FractionalArms.
  FractionalKelvinVoigtArms(const FractionalKelvinVoigt& law, const MemoryKernel& kernel, double step)
      : MaxwellArms(parts(law, kernel), step), law_(law) {}

  const FractionalKelvinVoigt& law() const noexcept { return law_; }

 private:
  static Parts parts(const FractionalKelvinVoigt& law, const MemoryKernel& kernel) {
    Parts all = fractional_parts(law.c(), law.alpha(), kernel);
    all.spring += law.k();
    return all;
  }

  FractionalKelvinVoigt law_;
};

}  // namespace ricochet
