#include <ricochet/collision/solvers/hertzian_forms.hpp>

#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include "../sphere/power_series.hpp"

#include <cmath>
#include <vector>

namespace ricochet {
namespace {

using Real = long double;  // the epsilon table loses digits: by 40 terms half of a double's
using Series = std::vector<Real>;

Real gamma_quotient(Real x, Real alpha) { return std::exp(std::lgamma(x) - std::lgamma(x - alpha)); }

/// Σ c_j z^j by the last diagonal Padé approximant that its terms allow.
Real summed(const Series& c, Real z) {
  std::vector<Real> last;
  Real sum = 0, power = 1, limit = 0;
  for (const Real term : c) {
    sum += term * power;
    power *= z;
    std::vector<Real> row{sum};
    for (std::size_t k = 0; k < last.size() && row[k] != last[k]; ++k)
      row.push_back((k > 0 ? last[k - 1] : 0) + 1 / (row[k] - last[k]));
    limit = row[(row.size() - 1) / 2 * 2];
    last = std::move(row);
  }
  return limit;
}

/// Of ζ', and of what the force vanishes with: D^α ζ^{3/2} or D^α ζ.
struct Motion {
  Series rate, event;
};

Motion motion(HertzianForm form, Real alpha) {
  constexpr int terms = 40;
  const Real p = 2.5L - alpha;
  const bool outside = form == HertzianForm::derivative_of_power;
  Series overlap{1}, power{1}, event;
  for (int j = 0; j < terms; ++j) {
    const Real at = p * j, next = p * (j + 1);
    event.push_back((outside ? power.back() : overlap.back()) * gamma_quotient((outside ? 2.5L : 2.0L) + at, alpha));
    Real force = event.back();
    if (!outside) {
      force = 0;
      for (std::size_t k = 0; k < event.size(); ++k) force += power[k] * event[event.size() - 1 - k];
    }
    overlap.push_back(-force / ((1 + next) * next));
    power.push_back(collision::next_of_power<Real>(overlap, power, outside ? 1.5L : 0.5L));
  }
  Series rate;
  for (std::size_t j = 0; j < overlap.size(); ++j) rate.push_back(overlap[j] * (1 + p * static_cast<Real>(j)));
  return {rate, event};
}

}  // namespace

HertzianRebound hertzian_rebound(HertzianForm form, double alpha) {
  support::require(alpha >= 0.05 && alpha <= 0.8, "alpha", alpha, "in [0.05, 0.8]");
  const Motion m = motion(form, alpha);
  const auto at = [&](const Series& series, double t) {
    return static_cast<double>(summed(series, std::pow(Real(t), 2.5L - Real(alpha))));
  };
  const auto event = [&](double t) { return at(m.event, t); };
  double after = 2;
  while (event(after) > 0) after += 0.1;
  const double end = support::root(event, after - 0.1, after);
  return {.en = -at(m.rate, end), .tcol = end, .terms = static_cast<int>(m.rate.size())};
}

}  // namespace ricochet
