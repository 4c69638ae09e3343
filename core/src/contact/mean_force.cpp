#include <ricochet/contact/mean_force.hpp>

#include <cmath>

namespace ricochet {

SteadyArm steady_arm(double relaxation_rate, double dt) noexcept {
  const double x = relaxation_rate * dt, decay = std::exp(-x);
  const double first = x > 0 ? -std::expm1(-x) / x : 1.0;
  if (x >= 0.5) return {decay, dt * first, first, dt * (1 - first) / x};
  // (1 − φ₁)/x = Σ (−x)^k/(k+2)!: the closed form would cancel.
  double second = 0, term = 0.5;
  for (int k = 0; k < 14; ++k) {
    second += term;
    term *= -x / (k + 3);
  }
  return {decay, dt * first, first, dt * second};
}

double mean_force(const FractionalArms& law, double overlap, double rate, const FractionalArms::Memory& memory,
                  double dt) noexcept {
  double sum = law.spring() * (overlap + 0.5 * rate * dt) + law.dashpot() * rate;
  for (std::size_t a = 0; a < law.arms(); ++a) {
    const SteadyArm arm = steady_arm(law.relaxation_rate(a), dt);
    sum += law.stiffness(a) * (arm.mean_before * memory.elongation[a] + arm.mean_gain * rate);
  }
  return sum;
}

}  // namespace ricochet
