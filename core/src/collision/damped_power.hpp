#pragma once

#include <ricochet/contact/power_law.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numeric>

namespace ricochet::collision {

/// A damped power law, force = kζ^{a} + cζ^{b}ζ', in the units of the impact (velocity v₀, time T, length v₀T, where
/// k v₀^{a−1} T^{a+1} = m; then γ = c v₀^b T^{b+1}/m is all that is left of the parameters) and in the variable y with
/// ζ = y^P. With dt = P y^{P−1} dσ the motion is polynomial,
///   dy/dσ = w,  dw/dσ = −P y^{P−1} force,  dt/dσ = P y^{P−1},  force = y^Q (y^R + γ w),
/// so it is analytic through the first touch and through the separation, where the law in ζ is not:
/// a = (Q+R)/P, b = Q/P.
template <int P, int Q, int R>
struct DampedPower {
  /// y, w = ζ'/v₀ and the scaled time.
  using State = std::array<double, 3>;
  static constexpr double stiffness_exponent = double(Q + R) / P;
  static constexpr double damping_exponent = double(Q) / P;
  static constexpr int force_power = Q;  ///< of the force's factor y^Q

  double gamma;

  static constexpr double power(double y, int n) noexcept {
    double product = 1;
    for (int i = 0; i < n; ++i) product *= y;
    return product;
  }

  State start() const noexcept { return {0, 1, 0}; }
  bool elastic() const noexcept { return gamma == 0; }
  static double rate(const State& s) noexcept { return s[1]; }
  /// The force without its factor y^Q: has the force's zero, and no other.
  double reduced_force(const State& s) const noexcept { return power(s[0], R) + gamma * s[1]; }
  double force(const State& s) const noexcept { return power(s[0], Q) * reduced_force(s); }
  static double overlap(const State& s) noexcept { return power(s[0], P); }
  double deceleration(const State& s) const noexcept { return P * power(s[0], P - 1) * force(s); }
  /// d(force)/dσ without the factor y^{Q−1} (none for Q = 0): changes sign where the force is greatest.
  double force_slope(const State& s) const noexcept {
    const double slope = R * power(s[0], R - 1) * s[1] - gamma * deceleration(s);
    if constexpr (Q == 0) return slope;
    return Q * s[1] * reduced_force(s) + s[0] * slope;
  }

  void operator()(const State& s, State& rate, double) const noexcept {
    rate = {s[1], -deceleration(s), P * power(s[0], P - 1)};
  }
};

/// The same motion with the reduced force f = y^R + γ w in the place of w. Where the damping is strong the force ends
/// when f is some γ^{−2} of either term, so w carries γ² times too few digits of it; w = (f − y^R)/γ from f carries
/// them all.
template <int P, int Q, int R>
struct StronglyDampedPower {
  /// y, f and the scaled time.
  using State = std::array<double, 3>;
  static constexpr int force_power = Q;  ///< of the force's factor y^Q

  double gamma;

  explicit StronglyDampedPower(const DampedPower<P, Q, R>& motion) : gamma(motion.gamma) {}

  static constexpr double power(double y, int n) noexcept { return DampedPower<P, Q, R>::power(y, n); }
  State start() const noexcept { return {0, gamma, 0}; }
  bool elastic() const noexcept { return false; }
  double rate(const State& s) const noexcept { return (s[1] - power(s[0], R)) / gamma; }
  static double reduced_force(const State& s) noexcept { return s[1]; }
  static double force(const State& s) noexcept { return power(s[0], Q) * s[1]; }
  static double overlap(const State& s) noexcept { return power(s[0], P); }
  double reduced_force_slope(const State& s) const noexcept {
    return R * power(s[0], R - 1) * rate(s) - gamma * P * power(s[0], P - 1 + Q) * s[1];
  }
  double force_slope(const State& s) const noexcept {
    if constexpr (Q == 0) return reduced_force_slope(s);
    return Q * rate(s) * s[1] + s[0] * reduced_force_slope(s);
  }

  void operator()(const State& s, State& change, double) const noexcept {
    change = {rate(s), reduced_force_slope(s), P * power(s[0], P - 1)};
  }
};

/// The motion of a form of PowerLaw: with ζ = y^P the powers of y are whole.
template <class Form>
struct MotionOfForm {
  static constexpr int spring = Form::stiffness_quarters, dashpot = Form::damping_quarters;
  static constexpr int p = 4 / std::gcd(4, std::gcd(spring, dashpot)), q = p * dashpot / 4;
  using type = DampedPower<p, q, p * spring / 4 - q>;
};
template <class Form>
using MotionOf = typename MotionOfForm<Form>::type;

using LinearMotion = MotionOf<LinearForm>;
using KuwabaraKonoMotion = MotionOf<KuwabaraKonoForm>;
using TsujiMotion = MotionOf<TsujiForm>;

/// From this γ on the overlap never returns to zero.
template <class Motion>
inline constexpr double overdamped_from = std::numeric_limits<double>::infinity();
template <>
inline constexpr double overdamped_from<LinearMotion> = Linear::overdamped_from;
template <>
inline constexpr double overdamped_from<TsujiMotion> = Tsuji::overdamped_from;

/// T of a damped power law's impact [s].
template <class Motion>
double time_unit(double k, double velocity, double mass_eff) {
  constexpr double a = Motion::stiffness_exponent;
  return std::pow(mass_eff / (k * std::pow(velocity, a - 1)), 1 / (a + 1));
}

/// γ of a damped power law's impact.
template <class Motion>
double damping_group(double c, double velocity, double mass_eff, double unit) {
  constexpr double b = Motion::damping_exponent;
  return c * std::pow(velocity, b) * std::pow(unit, b + 1) / mass_eff;
}

}  // namespace ricochet::collision
