#include <ricochet/collision/solvers/permanent_contact.hpp>

#include <ricochet/fractional/operators.hpp>
#include <ricochet/support/require.hpp>

#include <cmath>

namespace ricochet {
namespace {

/// 1/Γ(β) ∫ (t−s)^{β−1} … ds over one step for a function linear there: the weights of its values at both ends.
struct Weights {
  double before, after;
};

Weights weights(double beta, double t, double from, double to) {
  const double old = t - from, young = t - to;
  const double old_power = std::pow(old, beta), young_power = young > 0 ? std::pow(young, beta) : 0;
  const double whole = (old_power - young_power) / std::tgamma(1 + beta);
  const double moment = (old * old_power - young * young_power) * beta / std::tgamma(2 + beta) - young * whole;
  const double before = moment / (to - from);
  return {before, whole - before};
}

}  // namespace

std::vector<Instant> follow_permanent_contact(const Fractional& law, const Impact& impact, double until, int steps,
                                              bool graded) {
  support::require(law.alpha() >= 1, "alpha", law.alpha(), "in [1, 2)");
  support::require_positive("velocity", impact.velocity);
  support::require_positive("mass_eff", impact.mass_eff);
  support::require_positive("until", until);
  support::require(steps >= 1 && steps <= 10000, "steps", steps, "in [1, 10000]");
  const double beta = 2 - law.alpha(), a = law.coefficient() / impact.mass_eff;
  const std::vector<double> times =
      graded_mesh(until, static_cast<std::size_t>(steps), graded ? 1.1 * 2 / (1 + beta) : 1);
  std::vector<Instant> path{{0, 0, impact.velocity, 0}};
  for (std::size_t n = 1; n < times.size(); ++n) {
    double remembered = 0, own = 0;
    for (std::size_t l = 0; l < n; ++l) {
      const Weights w = weights(beta, times[n], times[l], times[l + 1]);
      remembered += w.before * path[l].rate;
      if (l + 1 < n)
        remembered += w.after * path[l + 1].rate;
      else
        own = w.after;
    }
    const Instant& last = path.back();
    const double rate = (impact.velocity - a * remembered) / (1 + a * own);
    path.push_back({times[n], last.overlap + 0.5 * (times[n] - times[n - 1]) * (last.rate + rate), rate, 0});
  }
  return path;
}

}  // namespace ricochet
