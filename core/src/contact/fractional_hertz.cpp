#include <ricochet/contact/fractional_hertz.hpp>
#include <ricochet/fractional/decay_moments.hpp>

namespace ricochet {

static_assert(ContactLaw<FractionalHertzArms>);

namespace {

/// A rate over a step 0 ≤ τ ≤ 1 as first + linear τ + square τ²: the parabola with these ends and this mean.
struct Parabola {
  double first, linear, square;

  Parabola(double before, double after, double mean)
      : first(before), linear(6 * mean - 4 * before - 2 * after), square(3 * (before + after - 2 * mean)) {}
};

/// φ₄(−x) = (1/6 − φ₃(−x))/x, by its series Σ (−x)^k/(k+4)! where that cancels.
double fourth(double x, double third) noexcept {
  if (x >= 0.5) return (1.0 / 6 - third) / x;
  double sum = 0, term = 1.0 / 24;
  for (int k = 0; k < 14; ++k) {
    sum += term;
    term *= -x / (k + 5);
  }
  return sum;
}

double power_two_thirds(double f) noexcept {
  const double root = std::cbrt(f);
  return root * root;
}

}  // namespace

FractionalHertzArms::FractionalHertzArms(const FractionalHertz& law, const MemoryKernel& kernel, double step)
    : MaxwellArms(parts(law, kernel), step), law_(law) {
  for (std::size_t j = 0; j < arms(); ++j) at_step_[j] = moments_of(relaxation_rate(j) * step);
}

FractionalHertzArms::Moments FractionalHertzArms::moments_of(double x) noexcept {
  const auto m = fractional::decay_moments(x);
  return {m.decay, fractional::decay_mean(x), m.falling, m.falling_once, fourth(x, m.falling_once)};
}

// ∫ τ^n e^{−x(1−τ)} dτ = ∫ (1−τ)^n e^{−xτ} dτ: φ₁, φ₂ and 2φ₃ of decay_moments.hpp.
void FractionalHertzArms::advance(Memory& m, Approach before, Approach after, double dt) const noexcept {
  if (!(dt > 0)) return;
  const Approach from = stretched(before), to = stretched(after);
  const Parabola rate(from.rate, to.rate, (to.overlap - from.overlap) / dt);
  for (std::size_t j = 0; j < arms(); ++j) {
    const Moments of = moments(j, dt);
    m.elongation[j] = of.decay * m.elongation[j] +
                      dt * (rate.first * of.mean + rate.linear * of.falling + 2 * rate.square * of.falling_once);
  }
}

// Of the parabola's coefficients −2 and 3 go with the rate at its end.
double FractionalHertzArms::rate_gain(double dt, double overlap) const noexcept {
  double gain = dashpot();
  for (std::size_t j = 0; j < arms(); ++j) {
    const Moments of = moments(j, dt);
    gain += stiffness(j) * dt * (6 * of.falling_once - 2 * of.falling);
  }
  return gain * stretched({overlap, 1}).rate;
}

double FractionalHertzArms::stored_energy(Approach a, const Memory& m) const noexcept {
  const double f = stretched(a).overlap, zeta = f > 0 ? a.overlap : 0;
  double sum = 0.4 * spring() * f * zeta;
  for (std::size_t j = 0; j < arms(); ++j) {
    const double w = f - m.elongation[j];
    sum += stiffness(j) * (0.4 * f * zeta - w * zeta + 0.6 * w * power_two_thirds(w));
  }
  return sum;
}

double FractionalHertzArms::dissipated_power(Approach a, const Memory& m) const noexcept {
  const Approach f = stretched(a);
  if (!(f.overlap > 0)) return 0;
  double power = dashpot() * f.rate * a.rate;
  for (std::size_t j = 0; j < arms(); ++j) {
    const double q = m.elongation[j];
    power += stiffness(j) * relaxation_rate(j) * q * (a.overlap - power_two_thirds(f.overlap - q));
  }
  return power;
}

double FractionalHertzArms::mean_force(double overlap, double rate, const Memory& m, double dt) const noexcept {
  const double end = overlap + rate * dt;
  const Approach from = stretched({overlap, rate}), to = stretched({end, rate});
  const double a2 = std::max(0.0, overlap), b2 = std::max(0.0, end), a = std::sqrt(a2), b = std::sqrt(b2);
  // The mean of ζ^{3/2}, as in power_law.hpp.
  const double f = a + b > 0 ? 0.4 * (a2 * a2 + b2 * b2 + a * b * (a2 + b2) + a2 * b2) / (a + b) : 0;
  const double mean = (to.overlap - from.overlap) / dt;
  const Parabola stretching(from.rate, to.rate, mean);
  double sum = spring() * f + dashpot() * mean;
  for (std::size_t j = 0; j < arms(); ++j) {
    const Moments of = moments(j, dt);
    const double q =
        stretching.first * of.falling + stretching.linear * of.falling_once + 2 * stretching.square * of.fourth;
    sum += stiffness(j) * (of.mean * m.elongation[j] + dt * q);
  }
  return sum;
}

}  // namespace ricochet
