#pragma once

#include <ricochet/contact/description.hpp>
#include <ricochet/support/quarter_power.hpp>

#include <cmath>
#include <limits>

namespace ricochet {

/// A spring and a dashpot that follow powers of the overlap, R = kζ^P + cζ^Q ζ'. ζ < 0 counts as no overlap where P or
/// Q is a fraction. `Form` is one of the structs below.
///
/// With the units of an impact, time T and length v₀T with k v₀^{P−1} T^{P+1} = m, all that is left of the parameters
/// is the group γ = c v₀^Q T^{Q+1}/m, so that e_n depends on γ alone.
template <class Form>
class PowerLaw {
 public:
  using Memory = NoMemory;
  static constexpr std::string_view name = Form::name;
  static constexpr std::array<Parameter, 2> parameters{
      {{"k", {4, 4 - Form::stiffness_quarters, -8}, domains::positive},
       {"c", {4, -Form::damping_quarters, -4}, domains::not_negative}}};
  static constexpr Ends ends = Form::ends;
  /// P and Q. Both are whole numbers of quarters.
  static constexpr double stiffness_power = Form::stiffness_quarters / 4.0,
                          damping_power = Form::damping_quarters / 4.0;
  /// The γ from which on the overlap never returns to zero.
  static constexpr double overdamped_from = Form::overdamped_from;

  /// k > 0, c ≥ 0, in the units of `parameters`; throws std::invalid_argument otherwise.
  PowerLaw(double k, double c) : k_(k), c_(c) { require_parameters<PowerLaw>(values()); }

  double k() const noexcept { return k_; }
  double c() const noexcept { return c_; }
  std::array<double, 2> values() const noexcept { return {k_, c_}; }
  static PowerLaw from(const std::array<double, 2>& values) { return {values[0], values[1]}; }

  /// What a restitution tells of k and c where nothing tells the time: the damping ratio, or γ at 1 m/s without one.
  static NamedValue loss_measure(double group) {
    const double ratio = std::isfinite(overdamped_from) ? group / overdamped_from : group;
    return {std::string(Form::loss_name), ratio, std::string(Form::loss_unit)};
  }

  double force(Approach a, const Memory&) const noexcept {
    if constexpr (Form::stiffness_quarters == Form::damping_quarters + 4)  // ζ^Q is common to both
      return root<Form::damping_quarters>(a.overlap) * (k_ * a.overlap + c_ * a.rate);
    return k_ * a.overlap * root<Form::stiffness_quarters - 4>(a.overlap) +
           c_ * root<Form::damping_quarters>(a.overlap) * a.rate;
  }
  void advance(Memory&, Approach, Approach, double) const noexcept {}
  double stored_energy(Approach a, const Memory&) const noexcept {
    return 1 / (stiffness_power + 1) * k_ * a.overlap * a.overlap * root<Form::stiffness_quarters - 4>(a.overlap);
  }
  double dissipated_power(Approach a, const Memory&) const noexcept {
    return c_ * root<Form::damping_quarters>(a.overlap) * a.rate * a.rate;
  }
  /// See mean_force.hpp. A mean of ζ^P over ζ in (a², b²) is a quotient of differences of powers; what both share is
  /// divided out, so that nothing cancels.
  double mean_force(double overlap, double rate, double dt) const noexcept;

 private:
  /// ζ^{Quarters/4} for a fraction; 1 for 0.
  template <int Quarters>
  static double root(double overlap) noexcept {
    static_assert(Quarters >= 0 && Quarters < 4);
    if constexpr (Quarters == 0) return 1;
    return support::quarter_power<Quarters>(std::max(0.0, overlap));
  }
  static constexpr bool linear = Form::stiffness_quarters == 4 && Form::damping_quarters == 0;

  double k_, c_;
};

template <class Form>
double PowerLaw<Form>::mean_force(double overlap, double rate, double dt) const noexcept {
  if constexpr (linear) {
    return k_ * (overlap + 0.5 * rate * dt) + c_ * rate;
  } else {
    static_assert(Form::stiffness_quarters == 6, "the mean of another power has to be derived");
    const double a2 = std::max(0.0, overlap), b2 = std::max(0.0, overlap + rate * dt);
    const double a = std::sqrt(a2), b = std::sqrt(b2), sum = a + b;
    if (sum == 0) return 0;
    // ζ^{3/2}: (2/5)(b⁵ − a⁵)/(b² − a²); ζ^{1/2}: (2/3)(b³ − a³)/(b² − a²), each times a + b.
    const double spring = 0.4 * (a2 * a2 + b2 * b2 + a * b * (a2 + b2) + a2 * b2);
    if constexpr (Form::damping_quarters == 2) {
      return (k_ * spring + c_ * rate * (2.0 / 3.0) * (a2 + a * b + b2)) / sum;
    } else {
      // ζ^{1/4} with p, q = ζ^{1/4} at the ends: (4/5)(q⁵ − p⁵)/(q⁴ − p⁴).
      static_assert(Form::damping_quarters == 1, "the mean of another power has to be derived");
      const double p = std::sqrt(a), q = std::sqrt(b);
      const double dashpot = 0.8 * (a2 + b2 + p * q * (a + b) + a * b) / (p + q);
      return (k_ * spring + c_ * rate * dashpot) / sum;
    }
  }
}

/// Spring and dashpot, R = kζ + cζ'. "linear1" of the paper ends by overlap, "linear2" by force (see ContactEnd).
struct LinearForm {
  static constexpr std::string_view name = "linear", loss_name = "damping ratio c/(2 sqrt(m k))", loss_unit{};
  static constexpr int stiffness_quarters = 4, damping_quarters = 0;
  static constexpr Ends ends{.overlap = true, .both_by_default = true};
  static constexpr double overdamped_from = 2;
};
using Linear = PowerLaw<LinearForm>;

/// Hertzian spring with the viscous term of Kuwabara and Kono, the paper's "nonlinear" law: R = kζ^{3/2} + cζ^{1/2}ζ'.
/// Its damping grows weak as ζ → 0, so its overlap always returns, but slowly: it is calibrated by force alone.
struct KuwabaraKonoForm {
  static constexpr std::string_view name = "kuwabara-kono", loss_name = "c k^(-3/5) m^(-2/5)",
                                    loss_unit = "(s/m)^(1/5)";
  static constexpr int stiffness_quarters = 6, damping_quarters = 2;
  static constexpr Ends ends{.overlap = false, .both_by_default = false};
  static constexpr double overdamped_from = std::numeric_limits<double>::infinity();
};
using KuwabaraKono = PowerLaw<KuwabaraKonoForm>;

/// Hertzian spring with the dashpot of Tsuji, Tanaka and Ishida (Powder Technol. 71, 239 (1992)), whose restitution
/// does not depend on the impact velocity: R = kζ^{3/2} + cζ^{1/4}ζ'. What LAMMPS, LIGGGHTS and MercuryDPM call Hertz
/// with constant restitution. In ζ^{5/4} it is the damped oscillator again, overdamped from γ = √5 on.
struct TsujiForm {
  static constexpr std::string_view name = "tsuji", loss_name = "damping ratio c/sqrt(5 m k)", loss_unit{};
  static constexpr int stiffness_quarters = 6, damping_quarters = 1;
  static constexpr Ends ends{.overlap = true, .both_by_default = false};
  static constexpr double overdamped_from = 2.23606797749978969641;
};
using Tsuji = PowerLaw<TsujiForm>;

}  // namespace ricochet
