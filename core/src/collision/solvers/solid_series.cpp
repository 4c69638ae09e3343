#include <ricochet/collision/solvers/solid_series.hpp>

#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace ricochet {
namespace {

using Real = long double;
constexpr std::size_t powers = 60;  // of t: Γ of a long double reaches far beyond

/// α = p/q.
struct Fraction {
  std::size_t p, q;
};

Fraction fraction(double alpha) {
  for (const std::size_t q : {20, 100}) {
    const double p = alpha * static_cast<double>(q), whole = std::round(p);
    if (whole >= 1 && std::abs(p - whole) <= 1e-12 * p) return {static_cast<std::size_t>(whole), q};
  }
  support::require(false, "alpha", alpha, "a multiple of 1/100");
  return {};
}

/// x = Σ A_n t^{1+n/q}/Γ(2+n/q) of 1/(1 + Σ b_n w^n).
class Series {
 public:
  Series(const std::vector<Real>& b, std::size_t q) : q_(static_cast<Real>(q)), a_(b.size()) {
    std::vector<std::size_t> present;
    for (std::size_t n = 1; n < b.size(); ++n)
      if (b[n] != 0) present.push_back(n);
    a_[0] = 1;
    for (std::size_t n = 1; n < a_.size(); ++n)
      for (const std::size_t k : present)
        if (k <= n) a_[n] -= b[k] * a_[n - k];
  }

  double rate(double t) const { return value(t, 1); }
  double force(double t) const { return -value(t, 2); }
  int terms() const { return static_cast<int>(a_.size()); }

 private:
  /// A derivative of x; of t itself the second is none.
  double value(Real t, int derivative) const {
    Real sum = derivative == 1 ? 1 : 0;
    for (std::size_t n = 1; n < a_.size(); ++n) {
      const Real power = 1 + static_cast<Real>(n) / q_ - static_cast<Real>(derivative);
      if (a_[n] != 0) sum += a_[n] * std::pow(t, power) / std::tgamma(power + 1);
    }
    return static_cast<double>(sum);
  }

  Real q_;
  std::vector<Real> a_;
};

SeriesRebound rebound(const Series& series) {
  constexpr double stride = 0.05, latest = 10;
  double after = stride;
  while (after < latest && series.force(after) > 0) after += stride;
  support::require(after < latest, "tcol", after, "less than 10");
  const double end = support::root([&](double t) { return series.force(t); }, after - stride, after);
  return {.tcol = end, .en = -series.rate(end), .terms = series.terms()};
}

}  // namespace

SeriesRebound series_rebound(const FractionalKelvinVoigt& law) {
  const auto [p, q] = fraction(law.alpha());
  std::vector<Real> b(powers * q);
  b[2 * q] = law.k();
  b[2 * q - p] += law.c();
  return rebound(Series(b, q));
}

SeriesRebound series_rebound(const FractionalZener& law) {
  const auto [p, q] = fraction(law.alpha());
  std::vector<Real> b(powers * q);
  b[2 * q] = law.k();
  Real arm = law.k1();
  for (std::size_t n = 2 * q; n < b.size(); n += p) {
    b[n] += arm;
    arm *= -std::pow(Real(law.tau()), -Real(law.alpha()));
  }
  return rebound(Series(b, q));
}

}  // namespace ricochet
