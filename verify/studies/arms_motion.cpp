#include "arms_motion.hpp"

#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include <algorithm>
#include <complex>
#include <vector>

namespace ricochet::verify {

namespace {

using Complex = std::complex<double>;

/// s + K̂(s) and its slope.
struct Characteristic {
  const MemoryKernel& kernel;

  template <class Number>
  Number operator()(Number s) const {
    Number sum = s + kernel.spring() / s + kernel.dashpot();
    for (const Arm& arm : kernel.arms()) sum += arm.strength / (s + arm.rate);
    return sum;
  }
  Complex slope(Complex s) const {
    Complex sum = 1.0 - kernel.spring() / (s * s);
    for (const Arm& arm : kernel.arms()) sum -= arm.strength / ((s + arm.rate) * (s + arm.rate));
    return sum;
  }
};

std::vector<Complex> poles_of(const Characteristic& f) {
  std::vector<double> rates;
  for (const Arm& arm : f.kernel.arms()) rates.push_back(arm.rate);
  std::sort(rates.begin(), rates.end());
  std::vector<Complex> poles;
  // Of the pair: the sum of all is −Σ rate − dashpot, their product ±spring Π rate.
  double sum = -f.kernel.dashpot(), product = f.kernel.spring(), above = 0;
  for (const double rate : rates) {
    // From plus infinity right of a rate to minus infinity left of the next, or of 0.
    const double s = support::root(f, -rate, above, 1, -1);
    poles.emplace_back(s);
    sum -= rate + s;
    product *= rate / -s;
    above = -rate;
  }
  const Complex half = std::sqrt(Complex(0.25 * sum * sum - product));
  for (Complex s : {0.5 * sum + half, 0.5 * sum - half}) {
    for (int i = 0; i < 4; ++i) s -= f(s) / f.slope(s);  // takes the roundings of sum and product away
    poles.push_back(s);
  }
  return poles;
}

}  // namespace

ArmsMotion exact_motion(const MemoryKernel& kernel, double near) {
  support::require_positive("spring", kernel.spring());
  const Characteristic f{kernel};
  const std::vector<Complex> poles = poles_of(f);
  /// Σ s^power e^{st}/f'(s): the overlap for −1, as ∫ζ' tends to 0 under a spring; the rate for 0; ζ'' for 1.
  const auto of_motion = [&](int power, double t) {
    double sum = 0;
    for (const Complex s : poles) sum += (std::pow(s, power) * std::exp(s * t) / f.slope(s)).real();
    return sum;
  };
  const double end = support::root([&](double t) { return of_motion(1, t); }, 0.8 * near, 1.2 * near);
  return {end, -of_motion(0, end), of_motion(-1, end)};
}

}  // namespace ricochet::verify
