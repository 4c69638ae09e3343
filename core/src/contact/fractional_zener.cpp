#include <ricochet/contact/fractional_zener.hpp>
#include <ricochet/support/require.hpp>
#include <ricochet/support/root.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet {

static_assert(ContactLaw<FractionalZenerArms>);

namespace {

/// The arms of A(s) = spring + dashpot s + Σ strength_j s/(s + rate_j), the rates ascending, in series with a spring.
class InSeries {
 public:
  InSeries(double spring, MaxwellArms::Parts arms) : spring_(spring), arms_(std::move(arms)) {
    std::sort(arms_.arms.begin(), arms_.arms.end(), [](const Arm& a, const Arm& b) { return a.rate < b.rate; });
  }

  MaxwellArms::Parts parts() const {
    MaxwellArms::Parts all{spring_ / (spring_ + arms_.spring) * arms_.spring, 0, {}};
    all.arms.reserve(arms_.arms.size() + 1);
    for (std::size_t i = 0; i < arms_.arms.size(); ++i) all.arms.push_back(arm(i == 0 ? 0 : rate(i - 1), rate(i)));
    if (arms_.dashpot > 0) all.arms.push_back(last_arm());
    return all;
  }

 private:
  double rate(std::size_t i) const { return arms_.arms[i].rate; }

  /// spring + A(−r) at r = from + off, the differences to the rates formed before they can cancel.
  double value(double from, double off) const {
    double sum = spring_ + arms_.spring - arms_.dashpot * (from + off);
    for (const Arm& a : arms_.arms) sum -= a.strength * ((from + off) / ((a.rate - from) - off));
    return sum;
  }
  /// A'(−r).
  double slope(double from, double off) const {
    double sum = arms_.dashpot;
    for (const Arm& a : arms_.arms) {
      const double apart = (a.rate - from) - off;
      sum += a.strength * (a.rate / apart) / apart;
    }
    return sum;
  }
  Arm arm_at(double from, double off) const {
    const double r = from + off;
    return {spring_ / slope(from, off) * spring_ / r, r};
  }

  /// Between two rates the value falls from +∞ to −∞; from 0 on from a finite one. The root is sought from the nearer
  /// of the two on, to whose distance the residue is inversely proportional squared.
  Arm arm(double low, double high) const {
    const double half = 0.5 * (high - low);
    const bool upper = value(high, -half) > 0;
    const double from = upper ? high : low, sign = upper ? -1 : 1;
    const auto f = [&](double off) { return value(from, sign * off); };
    const double least = std::numeric_limits<double>::min() / std::numeric_limits<double>::epsilon();
    const double tiny = std::max(half * 1e-200, least);
    const double off = support::root([&](double log_off) { return f(std::exp(log_off)); }, std::log(tiny),
                                     std::log(half), upper ? -1 : 1, f(half) == 0 ? 0 : (upper ? 1 : -1));
    return arm_at(from, sign * std::exp(off));
  }

  /// Past the last rate: from +∞, or spring + A(0), to −∞ as −dashpot r.
  Arm last_arm() const {
    const double low = arms_.arms.empty() ? 0 : arms_.arms.back().rate;
    double stiffest = spring_ + arms_.spring;
    for (const Arm& a : arms_.arms) stiffest += a.strength;
    if (arms_.arms.empty()) return arm_at(0, stiffest / arms_.dashpot);
    // At r = low + off: value ≤ stiffest + Σ strength low/off − dashpot off.
    const double far = stiffest / arms_.dashpot + std::sqrt(stiffest / arms_.dashpot) * std::sqrt(low);
    const double off = support::root([&](double log_off) { return value(low, std::exp(log_off)); },
                                     std::log(far * 1e-200), std::log(2 * far), 1, -1);
    return arm_at(low, std::exp(off));
  }

  double spring_;
  MaxwellArms::Parts arms_;
};

}  // namespace

MaxwellArms::Parts FractionalZenerArms::parts(const FractionalZener& law, const MemoryKernel& kernel) {
  support::require(kernel.arms().size() <= max_kernel_arms, "kernel arms", static_cast<double>(kernel.arms().size()),
                   "at most 23; a larger tolerance or a smaller longest/shortest needs fewer");
  const double pot = law.k1() * std::pow(law.tau(), law.alpha());
  Parts all;
  // Past the doubles the springpot is rigid: its arm is the spring k₁.
  if (law.k1() > 0 && !std::isnormal(pot))
    all.spring = pot > 1 ? law.k1() : 0;
  else if (law.k1() > 0)
    all = InSeries(law.k1(), fractional_parts(pot, law.alpha(), kernel)).parts();
  all.spring += law.k();
  return all;
}

}  // namespace ricochet
