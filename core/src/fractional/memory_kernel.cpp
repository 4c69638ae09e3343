#include <ricochet/support/require.hpp>
#include <ricochet/fractional/memory_kernel.hpp>

#include "kernel_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet {

using fractional::KernelFit;
using Real = KernelFit::Real;

namespace {

/// The relative deviation of the rounded sum from t^{−α}/Γ(1−α) at t = δ e^u, and its first two derivatives in u.
struct Deviation {
  Real value, slope, bend;
};

Deviation deviation_at(const MemoryKernel& kernel, Real gamma, Real u) {
  const Real t = kernel.shortest() * std::exp(u), alpha = kernel.alpha(), scale = gamma * std::pow(t, alpha);
  Real sum = kernel.spring(), first = alpha * sum, second = alpha * first;
  for (const Arm& arm : kernel.arms()) {  // t^α e^{−st} has the logarithmic slope α − st, which falls by st
    const Real decay = arm.rate * t, part = arm.strength * std::exp(-decay), slope = alpha - decay;
    sum += part, first += slope * part, second += (slope * slope - decay) * part;
  }
  return {1 - scale * sum, -scale * first, -scale * second};
}

/// Upper bound of |deviation| on [1, ratio] δ: eight samples per half wave, and from the highest of each Newton's
/// method to the top. A sample is at most 0.2 of a wave's phase from it, two steps leave 1e-8 of the phase and 1e-16 of
/// the height.
double measured_error(const MemoryKernel& kernel, Real ratio, std::size_t arms) {
  const Real gamma = std::tgamma(1 - static_cast<Real>(kernel.alpha())), span = std::log(ratio);
  const std::size_t samples = 64 + 16 * (arms + 1);
  std::vector<Real> u(samples + 1);
  std::vector<Deviation> d(samples + 1);
  Real worst = 0;
  for (std::size_t i = 0; i <= samples; ++i) {
    // Between uniform and Chebyshev in log t, as the error's own waves are.
    const Real p = static_cast<Real>(i) / samples;
    u[i] = span * (0.25L * (1 - std::cos(fractional::pi * p)) + 0.5L * p);
    d[i] = deviation_at(kernel, gamma, u[i]);
    worst = std::max(worst, std::fabs(d[i].value));
  }
  for (std::size_t i = 1; i < samples; ++i) {
    const Real height = std::fabs(d[i].value);
    if (height < std::fabs(d[i - 1].value) || height < std::fabs(d[i + 1].value)) continue;
    Real at = u[i];
    Deviation top = d[i];
    for (int step = 0; step < 2 && top.bend != 0; ++step) {
      at = std::clamp(at - top.slope / top.bend, u[i - 1], u[i + 1]);
      top = deviation_at(kernel, gamma, at);
      worst = std::max(worst, std::fabs(top.value));
    }
  }
  return std::nextafter(static_cast<double>(worst), 1.0);
}

}  // namespace

double MemoryKernel::operator()(double t) const noexcept {
  double sum = spring_;
  for (const Arm& arm : arms_) sum += arm.strength * std::exp(-arm.rate * t);
  return sum;
}

MemoryKernel memory_kernel(double alpha, const MemoryWindow& window) {
  const auto [shortest, longest, tolerance] = window;
  support::require(alpha >= 0 && alpha <= 1, "alpha", alpha, "between 0 and 1");
  support::require(shortest >= 1e-200 && shortest <= 1e200, "shortest", shortest, "between 1e-200 and 1e200");
  support::require(longest >= shortest && longest <= 1e6 * shortest, "longest", longest,
                   "between shortest and 1e6 times shortest");
  support::require(tolerance >= 1e-12 && tolerance <= 0.1, "tolerance", tolerance, "between 1e-12 and 0.1");

  MemoryKernel kernel;
  kernel.alpha_ = alpha;
  kernel.shortest_ = shortest;
  kernel.longest_ = longest;
  if (alpha == 0 || alpha == 1) {
    (alpha == 0 ? kernel.spring_ : kernel.dashpot_) = 1;
    return kernel;
  }
  const Real ratio = static_cast<Real>(longest) / shortest;
  // The last rounding to double costs about 2e-16 an arm; the fit must leave room for it.
  const KernelFit fit = fractional::fit_kernel(alpha, ratio, 0.999L * tolerance, max_kernel_arms);

  const Real gamma = std::tgamma(1 - static_cast<Real>(alpha)), unit = std::pow(static_cast<Real>(shortest), -alpha);
  kernel.spring_ = static_cast<double>(fit.spring() * unit / gamma);
  for (std::size_t j = 0; j < fit.arms(); ++j)
    kernel.arms_.push_back(
        {static_cast<double>(fit.strength(j) * unit / gamma), static_cast<double>(fit.rate(j) / shortest)});
  // Of order α; where α is below 1e-12, what Newton leaves over may exceed it.
  const Real dashpot = std::max<Real>(0, 1 / (1 - static_cast<Real>(alpha)) - fit.impulse());
  kernel.dashpot_ = static_cast<double>(dashpot * unit * shortest / gamma);
  kernel.error_ = measured_error(kernel, ratio, fit.arms());
  return kernel;
}

MemoryKernel affordable_kernel(double alpha, const MemoryWindow& window, std::size_t most_arms) {
  constexpr double loosest = 0.1;
  MemoryWindow looser = window;
  for (;; looser.tolerance = std::min(10 * looser.tolerance, loosest)) {
    MemoryKernel kernel = memory_kernel(alpha, looser);
    if (kernel.arms().size() <= most_arms) return kernel;
    support::require(looser.tolerance < loosest, "most_arms", static_cast<double>(most_arms),
                     "enough for a relative error of 0.1");
  }
}

}  // namespace ricochet
