#include "coverage.hpp"

#include "../paper.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <cmath>
#include <random>

namespace ricochet::verify {

namespace {

using namespace calibration;

constexpr double mass = paper::pair.impact.mass_eff;
constexpr int speeds = 12;
constexpr double en_sigma = 0.01, tcol_share = 0.02;
/// Of fractional-hertz less noise, as its c goes with e^{10 δα}: errors of the first order are to do for it.
double noise_of(const FitRequest& request) {
  if (request.law == kind_of<FractionalHertz>) return 0.1;
  return 1;
}

/// α = 1/(1 + e^{−a} v^{−b}), with the k and c of `truth_of`.
constexpr double a = -0.5, b = 0.3, k = 5000, c = 0.3;
double alpha_at(double velocity) { return 1 / (1 + std::exp(-a - b * std::log(velocity))); }

AnyLaw truth_of(const FitRequest& request, double velocity) {
  const Fractional fractional(k, c, request.alpha_of_speed ? alpha_at(velocity) : 0.3);
  for (const AnyLaw& law : {AnyLaw(Linear(5000, 0.1)), AnyLaw(KuwabaraKono(1.4e6, 30)), AnyLaw(Tsuji(1.4e6, 2)),
                            AnyLaw(Hysteretic(4000, 9000)), AnyLaw(FractionalKelvinVoigt(5000, 15, 0.5)),
                            AnyLaw(FractionalHertz(1.4e6, 1600, 0.6)), AnyLaw(FractionalZener(5000, 5e5, 1e-9, 0.5))})
    if (LawKind::of(law) == request.law) return law;
  return fractional;
}

/// What sets the restitution, where no times tell more.
struct Groups {
  using Values = std::vector<double>;
  Values operator()(const Linear& law) const { return {damping_ratio(law, mass)}; }
  Values operator()(const KuwabaraKono& law) const {
    return {law.c() * std::pow(law.k(), -0.6) * std::pow(mass, -0.4)};
  }
  Values operator()(const Tsuji& law) const { return {damping_ratio(law, mass)}; }
  Values operator()(const Hysteretic& law) const { return {law.k1() / law.k2()}; }
  Values operator()(const Fractional& law) const { return {law.alpha()}; }
  Values operator()(const FractionalKelvinVoigt& law) const {
    return {law.c() / law.k() * std::pow(law.k() / mass, 0.5 * law.alpha())};
  }
  Values operator()(const FractionalHertz& law) const {
    return {law.alpha(), law.c() / law.k() * std::pow(law.k() / mass, 0.4 * law.alpha())};
  }
  Values operator()(const FractionalZener& law) const { return {law.tau() * std::sqrt(law.k() / mass)}; }
};

/// What the fit tells of it.
std::vector<double> true_parameters(const CoverageCase& one) {
  if (one.request.alpha_of_speed) return one.with_times ? std::vector{a, b, k, c} : std::vector{a, b};
  const AnyLaw law = truth_of(one.request, 1);
  if (!one.with_times) return std::visit(Groups{}, law);
  std::vector<double> values;
  for (const auto& p : one.request.law == kind_of<FractionalHertz> ? parameters(law) : identifiable(law))
    values.push_back(p.value);
  return values;
}

/// Without noise, over two decades of speed.
std::vector<Measurement> exact_data(const CoverageCase& one) {
  std::vector<Measurement> data;
  for (int i = 0; i < speeds; ++i) {
    const double v = 0.02 * std::pow(100.0, i / (speeds - 1.0));
    const Collision out = collide(truth_of(one.request, v), {v, mass});
    const double noise = noise_of(one.request);
    data.push_back({v, out.en, noise * en_sigma});
    if (one.with_times) data.back().tcol = out.tcol, data.back().tcol_sigma = noise * tcol_share * out.tcol;
  }
  return data;
}

}  // namespace

std::vector<CoverageCase> coverage_cases() {
  std::vector<CoverageCase> cases;
  for (const bool with_times : {true, false}) {
    for (const LawKind law : LawKind::all()) cases.push_back({{law, ContactEnd::force, mass}, with_times});
    cases.push_back({{kind_of<Fractional>, ContactEnd::force, mass, true}, with_times});
  }
  return cases;
}

std::vector<Coverage> coverage_of(const CoverageCase& one, int trials) {
  std::mt19937_64 random(2004);
  std::normal_distribution<double> normal;
  const auto exact = exact_data(one);
  const auto truth = true_parameters(one);
  std::vector<Coverage> found;
  found.reserve(truth.size());
  for (const double value : truth) found.push_back({one.request, one.with_times, "", value, 0, 0});
  for (int trial = 0; trial < trials; ++trial) {
    auto data = exact;
    for (Measurement& m : data) {
      m.en += m.en_sigma * normal(random);
      m.tcol += m.tcol_sigma * normal(random);
    }
    const Fit fit = fit_law(one.request, data);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Estimate& p = fit.parameters.at(i);
      found[i].parameter = p.name;
      found[i].relative_error += p.error / std::abs(truth[i]) / trials;
      found[i].share += (std::abs(p.value - truth[i]) <= 1.959964 * p.error) / static_cast<double>(trials);
    }
  }
  return found;
}

}  // namespace ricochet::verify
