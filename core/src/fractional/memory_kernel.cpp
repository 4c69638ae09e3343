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

/// Largest relative deviation of the rounded sum from t^{−α}/Γ(1−α) on [1, ratio] δ: eight samples per half wave.
double measured_error(const MemoryKernel& kernel, Real ratio, std::size_t arms) {
  const Real alpha = kernel.alpha(), gamma = std::tgamma(1 - alpha);
  const std::size_t samples = 64 + 16 * (arms + 1);
  Real worst = 0;
  for (std::size_t i = 0; i <= samples; ++i) {
    // Between uniform and Chebyshev in log t, as the error's own waves are.
    const Real u = static_cast<Real>(i) / samples, v = 0.25L * (1 - std::cos(fractional::pi * u)) + 0.5L * u;
    const Real t = kernel.shortest() * std::pow(ratio, v);
    Real sum = kernel.spring();
    for (const Arm& arm : kernel.arms()) sum += arm.strength * std::exp(-arm.rate * t);
    worst = std::max(worst, std::fabs(1 - sum * gamma * std::pow(t, alpha)));
  }
  return static_cast<double>(worst);
}

}  // namespace

double MemoryKernel::operator()(double t) const noexcept {
  double sum = spring_;
  for (const Arm& arm : arms_) sum += arm.strength * std::exp(-arm.rate * t);
  return sum;
}

MemoryKernel memory_kernel(double alpha, double shortest, double longest, double tolerance) {
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

}  // namespace ricochet
