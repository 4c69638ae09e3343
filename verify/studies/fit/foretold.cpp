#include "foretold.hpp"

#include "../paper.hpp"

#include <gsl/gsl_cdf.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace ricochet::verify {
namespace {

using namespace calibration;

constexpr double mass = paper::pair.impact.mass_eff;
constexpr double en_sigma = 0.01;

/// What the law does at twelve speeds over two decades.
std::vector<Measurement> exact_data(const AnyLaw& law) {
  constexpr int speeds = 12;
  std::vector<Measurement> data;
  for (int i = 0; i < speeds; ++i) {
    const double v = 0.02 * std::pow(100.0, i / (speeds - 1.0));
    data.push_back({v, collide(law, {v, mass}).en, en_sigma});
  }
  return data;
}

/// The share of `trials` noisy copies of `exact` of which `what` is true.
template <class F>
double share_of(const std::vector<Measurement>& exact, int trials, const F& what) {
  std::mt19937_64 random(1905);
  std::normal_distribution<double> normal;
  int count = 0;
  for (int trial = 0; trial < trials; ++trial) {
    auto data = exact;
    for (Measurement& m : data) m.en += m.en_sigma * normal(random);
    count += what(data) ? 1 : 0;
  }
  return static_cast<double>(count) / trials;
}

}  // namespace

std::array<Thirds, 2> thirds(std::vector<Measurement> data) {
  std::stable_sort(data.begin(), data.end(),
                   [](const Measurement& a, const Measurement& b) { return a.velocity < b.velocity; });
  const auto third = static_cast<std::ptrdiff_t>(data.size() / 3);
  return {{{"slowest", {data.begin() + third, data.end()}, {data.begin(), data.begin() + third}},
           {"fastest", {data.begin(), data.end() - third}, {data.end() - third, data.end()}}}};
}

std::size_t Foretold::nearest() const {
  return static_cast<std::size_t>(std::min_element(miss.begin(), miss.end()) - miss.begin());
}

Foretold foretell(const Thirds& of) {
  Foretold out{of, all_fits(of.kept), {}};
  for (const Fit& fit : out.fits) {
    double sum = 0;
    for (const Measurement& m : of.rest) sum += std::pow(predict(fit, m.velocity).en - m.en, 2);
    out.miss.push_back(std::sqrt(sum / static_cast<double>(of.rest.size())));
  }
  return out;
}

double chow(const Fit& all, const Fit& part) {
  const auto further = static_cast<double>(all.observations - part.observations);
  return (all.chi2 - part.chi2) / further / (part.chi2 / static_cast<double>(part.freedom));
}

double share_foretold(int trials) {
  const FitRequest request{kind_of<FractionalHertz>, ContactEnd::force, mass};
  const auto holds = [&](const std::vector<Measurement>& data) {
    const auto fastest = thirds(data)[1];
    const double more = fit_law(request, data).chi2 - fit_law(request, fastest.kept).chi2;
    return more < gsl_cdf_chisq_Pinv(0.95, static_cast<double>(fastest.rest.size()));
  };
  return share_of(exact_data(FractionalHertz(1.4e6, 1600, 0.6)), trials, holds);
}

double share_misled(int trials) {
  const auto misled = [](const std::vector<Measurement>& data) {
    const FitRequest constant{kind_of<Fractional>, ContactEnd::force, mass};
    FitRequest of_speed = constant;
    of_speed.alpha_of_speed = true;
    return fit_law(of_speed, data).aic < fit_law(constant, data).aic;
  };
  return share_of(exact_data(Fractional(5000, 0.3, 0.3)), trials, misled);
}

}  // namespace ricochet::verify
