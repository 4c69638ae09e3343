#include <ricochet/contact/mean_force.hpp>
#include <ricochet/fractional/decay_moments.hpp>

namespace ricochet {

SteadyArm steady_arm(double relaxation_rate, double dt) noexcept {
  const double x = relaxation_rate * dt, mean = fractional::decay_mean(x);
  const auto m = fractional::decay_moments(x);
  return {m.decay, dt * mean, mean, dt * m.falling};
}

namespace contact {

double mean_force(const MaxwellArms& law, double overlap, double rate, const MaxwellArms::Memory& memory,
                  double dt) noexcept {
  double sum = law.spring() * (overlap + 0.5 * rate * dt) + law.dashpot() * rate;
  for (std::size_t a = 0; a < law.arms(); ++a) {
    const SteadyArm arm = steady_arm(law.relaxation_rate(a), dt);
    sum += law.stiffness(a) * (arm.mean_before * memory.elongation[a] + arm.mean_gain * rate);
  }
  return sum;
}

}  // namespace contact

}  // namespace ricochet
