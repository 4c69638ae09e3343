#include "mindlin_spring.hpp"

#include <ricochet/support/root.hpp>

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace ricochet::calibration {
namespace {

Infeasible beyond(const AnyLaw& normal, ContactEnd end, double beta0, double lowest, double highest,
                  const std::string& reason) {
  return {.law = LawKind::of(normal),
          .end = end,
          .reason = reason,
          .quantity = "beta0",
          .asked = beta0,
          .lowest = lowest,
          .highest = highest};
}

/// The first rise of β₀ with ln k: from no spring, −1, to its top. k in units of `unit`.
struct FirstRise {
  double log_low = 0, log_top = 0, top = -1;
};

template <class F>
FirstRise first_rise(const F& beta) {
  constexpr double step = 0.25;
  FirstRise rise{-9, -9, -1};
  double x = -9;
  for (double here = beta(x); here >= rise.top && x < 8; here = beta(x)) {
    rise.top = here;
    rise.log_top = x;
    x += step;
  }
  double low = rise.log_top - step, high = rise.log_top + step;  // the top lies between
  for (int i = 0; i < 60; ++i) {
    const double a = low + (high - low) * 0.382, b = low + (high - low) * 0.618;
    (beta(a) < beta(b) ? low : high) = beta(a) < beta(b) ? a : b;
  }
  rise.log_top = 0.5 * (low + high);
  rise.top = beta(rise.log_top);
  return rise;
}

/// β₀ under a dashpot.
struct Damped {
  double log_c = 0, beta = 0;
};

/// Of samples over ln c in steps of `step`, the one of the greatest sign·β₀, moved to the maximum between its
/// neighbours by Brent's method.
template <class F>
Damped extreme(const F& beta, const std::vector<Damped>& all, double step, double sign) {
  const auto best = std::max_element(all.begin(), all.end(),
                                     [&](const Damped& a, const Damped& b) { return sign * a.beta < sign * b.beta; });
  if (best == all.begin() || best == all.end() - 1) return *best;
  const auto [x, value] = boost::math::tools::brent_find_minima([&](double log_c) { return -sign * beta(log_c); },
                                                                best->log_c - step, best->log_c + step, 26);
  return -value > sign * best->beta ? Damped{x, -sign * value} : *best;
}

}  // namespace

std::variant<MindlinSpring, Infeasible> spring_for(double beta0, const AnyLaw& normal, ContactEnd end,
                                                   const Sticking& stuck, double unit_k) {
  const auto beta = [&](double log_k) { return stuck(MindlinTangential(unit_k * std::exp(log_k))).beta; };
  const FirstRise rise = first_rise(beta);
  if (!(beta0 > -1 && beta0 <= rise.top)) {
    Infeasible out = beyond(normal, end, beta0, -1, rise.top,
                            "-1 is no spring at all, and what a shrinking contact lets go no spring gives back");
    out.low_open = true;
    return out;
  }
  const double low = beta(rise.log_low);
  if (beta0 <= low) return beyond(normal, end, beta0, low, rise.top, "so weak a spring is none");
  const double log_k = support::root([&](double x) { return beta(x) - beta0; }, rise.log_low, rise.log_top, low - beta0,
                                     rise.top - beta0);
  return MindlinSpring{MindlinTangential(unit_k * std::exp(log_k)), rise.log_top};
}

std::variant<MindlinTangential, Infeasible> dashpot_for(double beta0, double k, const AnyLaw& normal, ContactEnd end,
                                                        const Sticking& stuck) {
  constexpr double step = 0.25;
  const double unit_c = stuck.mass() / stuck.tcol(), free = stuck(MindlinTangential(k)).beta;
  if (beta0 == free) return MindlinTangential(k);
  const auto with = [&](double c) { return stuck(MindlinTangential(k, c)).beta; };
  const auto beta = [&](double log_c) { return with(unit_c * std::exp(log_c)); };
  const auto within = [&](double low, double high) {
    return MindlinTangential(k,
                             support::root([&](double c) { return with(c) - beta0; }, low, high, {.relative = 1e-13}));
  };
  constexpr int first = -40, last = 24;
  std::vector<Damped> all;
  all.reserve(last - first + 1);
  for (int i = first; i <= last; ++i) {
    all.push_back({step * i, beta(step * i)});
    const double before = i == first ? free : all.rbegin()[1].beta;
    const double low = i == first ? 0.0 : std::exp(step * (i - 1));
    if ((all.back().beta > beta0) != (before > beta0)) return within(unit_c * low, unit_c * std::exp(step * i));
  }
  double lowest = std::min(free, 0.0), highest = std::max(free, 0.0);
  for (const double sign : {-1.0, 1.0}) {
    const Damped far = extreme(beta, all, step, sign);
    if (sign * far.beta >= sign * beta0 && sign * beta0 > sign * free)
      return within(unit_c * std::exp(far.log_c - step), unit_c * std::exp(far.log_c));
    lowest = std::min(lowest, far.beta);
    highest = std::max(highest, far.beta);
  }
  Infeasible out = beyond(normal, end, beta0, lowest, highest, "no dashpot beside the spring of these moduli gives it");
  out.low_open = lowest == 0 && free > 0;
  out.open = highest == 0 && free < 0;
  return out;
}

}  // namespace ricochet::calibration
