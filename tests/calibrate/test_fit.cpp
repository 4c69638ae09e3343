#include <calibrate/fit.hpp>
#include <catch2/catch.hpp>
#include <ricochet/contact/damping_ratio.hpp>
#include <ricochet/contact/fractional_contact.hpp>

#include <cmath>
#include <random>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

constexpr double mass = 2e-5;

/// Speeds over two decades.
std::vector<double> speeds(int n) {
  std::vector<double> v;
  for (int i = 0; i < n; ++i) v.push_back(0.02 * std::pow(100.0, i / (n - 1.0)));
  return v;
}

/// What `law` does at these speeds, by collide, with Gaussian errors of the given sizes; noise = 0: stated, but not made.
std::vector<Measurement> measured(const AnyLaw& law, double en_sigma, double tcol_share, std::mt19937_64& random,
                                  double noise = 1) {
  std::normal_distribution<double> normal;
  std::vector<Measurement> data;
  for (const double v : speeds(12)) {
    const auto out = collide(law, {v, mass});
    Measurement m{v, out.en + noise * en_sigma * normal(random), en_sigma};
    if (tcol_share > 0) {
      m.tcol_sigma = tcol_share * out.tcol;
      m.tcol = out.tcol + noise * m.tcol_sigma * normal(random);
    }
    data.push_back(m);
  }
  return data;
}

struct Truth {
  LawName name;
  AnyLaw law;
};
const Truth truths[] = {{LawName::linear, Linear(5000, 0.1)},
                        {LawName::kuwabara_kono, KuwabaraKono(1.4e6, 30)},
                        {LawName::tsuji, Tsuji(1.4e6, 2)},
                        {LawName::hysteretic, Hysteretic(4000, 9000)},
                        {LawName::fractional, Fractional(5000, 0.3, 0.3)}};

/// Of the intervals value ± 1.96 errors of all parameters, how many hold the truth.
struct Coverage {
  int held = 0, asked = 0;
};

Coverage coverage(const Truth& truth, bool with_times, int trials, unsigned seed) {
  std::mt19937_64 random(seed);
  Coverage found;
  const auto exact = fit_law({truth.name, ContactEnd::force, mass}, measured(truth.law, 0.01, with_times ? 0.02 : 0, random, 0));
  for (int trial = 0; trial < trials; ++trial) {
    const Fit fit = fit_law({truth.name, ContactEnd::force, mass}, measured(truth.law, 0.01, with_times ? 0.02 : 0, random));
    for (std::size_t i = 0; i < fit.parameters.size(); ++i, ++found.asked)
      found.held += std::abs(fit.parameters[i].value - exact.parameters[i].value) <= 1.959964 * fit.parameters[i].error;
  }
  return found;
}

}  // namespace

TEST_CASE("data without error give their law back") {
  std::mt19937_64 random(1);
  for (const Truth& truth : truths) {
    const Fit fit = fit_law({truth.name, ContactEnd::force, mass}, measured(truth.law, 0.01, 0.01, random, 0));
    CAPTURE(fit_name(fit.request));
    CHECK(fit.chi2 < 1e-8);
    const auto known = identifiable(truth.law);
    REQUIRE(fit.parameters.size() == known.size());
    for (std::size_t i = 0; i < known.size(); ++i) {
      CHECK(fit.parameters[i].name == known[i].name);
      CHECK(fit.parameters[i].value == Approx(known[i].value).epsilon(1e-6));
    }
    CHECK(predict(fit, 0.3).en == Approx(collide(truth.law, {0.3, mass}).en).epsilon(1e-6));
    CHECK(predict(fit, 0.3).tcol == Approx(collide(truth.law, {0.3, mass}).tcol).epsilon(1e-6));
  }
}

TEST_CASE("without times the combination that sets the restitution is what is told") {
  std::mt19937_64 random(2);
  const auto only = [&](const Truth& truth) {
    const Fit fit = fit_law({truth.name, ContactEnd::force, mass}, measured(truth.law, 1e-6, 0, random, 0));
    REQUIRE(fit.parameters.size() == 1);
    CHECK(fit.findings.at(0) == "no collision times: the stiffness cannot be told, only what sets the restitution");
    return fit.parameters[0].value;
  };
  CHECK(only(truths[0]) == Approx(damping_ratio(Linear(5000, 0.1), mass)).epsilon(1e-4));
  CHECK(only(truths[1]) == Approx(30 * std::pow(1.4e6, -0.6) * std::pow(mass, -0.4)).epsilon(1e-4));
  CHECK(only(truths[2]) == Approx(damping_ratio(Tsuji(1.4e6, 2), mass)).epsilon(1e-4));
  CHECK(only(truths[3]) == Approx(4.0 / 9).epsilon(1e-4));
  CHECK(only(truths[4]) == Approx(0.3).epsilon(1e-4));
}

TEST_CASE("an alpha that follows the speed is recovered, and tells k from c") {
  std::vector<Measurement> data;
  const double a = -0.5, b = 0.3, k = 5000, c = 0.3;
  for (const double v : speeds(10)) {
    const double alpha = 1 / (1 + std::exp(-a - b * std::log(v)));
    const auto contact = fractional_contact(alpha);
    const double A = std::pow(c, alpha) * std::pow(k, 1 - alpha) / mass;
    const double tcol = contact.tau * std::pow(A, -1 / (2 - alpha));
    data.push_back({v, contact.en, 0.01, tcol, 0.01 * tcol});
  }
  FitRequest request{LawName::fractional, ContactEnd::force, mass, true};
  const Fit fit = fit_law(request, data);
  REQUIRE(fit.parameters.size() == 4);
  CHECK(fit.parameters[0].value == Approx(a).epsilon(1e-5));
  CHECK(fit.parameters[1].value == Approx(b).epsilon(1e-5));
  CHECK(fit.parameters[2].value == Approx(k).epsilon(1e-4));
  CHECK(fit.parameters[3].value == Approx(c).epsilon(1e-4));
  CHECK(fit.findings.empty());
  for (auto& m : data) m.tcol = m.tcol_sigma = 0;
  const Fit without = fit_law(request, data);
  REQUIRE(without.parameters.size() == 2);
  CHECK(without.parameters[1].value == Approx(b).epsilon(1e-5));
  request.alpha_of_speed = false;
  const Fit constant = fit_law(request, data);
  CHECK(constant.aic > without.aic);
  CHECK(constant.findings.back() == "misfit: the law gives the same restitution at every speed, the data change with it");
}

TEST_CASE("stated errors hold the truth as often as they say") {
  // 120 trials of two parameters: 0.95 ± 4 standard deviations of a share, the parameters counted as one (they correlate).
  constexpr int trials = 120;
  const double slack = 4 * std::sqrt(0.95 * 0.05 / trials);
  for (const Truth& truth : truths) {
    const Coverage c = coverage(truth, true, trials, 77);
    CAPTURE(text(truth.name));
    CHECK(c.held / static_cast<double>(c.asked) > 0.95 - slack);
    CHECK(c.held < c.asked);
  }
}

TEST_CASE("stated errors hold the truth in 95 % of 2000 trials", "[.thorough]") {
  for (const Truth& truth : truths)
    for (const bool with_times : {true, false}) {
      const Coverage c = coverage(truth, with_times, 2000, 78);
      CAPTURE(text(truth.name), with_times);
      CHECK(std::abs(c.held / static_cast<double>(c.asked) - 0.95) < 0.02);
    }
}

TEST_CASE("errors and correlations are those of a parametric bootstrap") {
  std::mt19937_64 random(5);
  const auto data = measured(truths[1].law, 0.01, 0.02, random);
  const FitRequest request{LawName::kuwabara_kono, ContactEnd::force, mass};
  const Fit fit = fit_law(request, data);
  constexpr int samples = 400;
  std::normal_distribution<double> normal;
  double sum[2] = {}, square[2] = {}, product = 0;
  for (int s = 0; s < samples; ++s) {
    std::vector<Measurement> again = data;
    for (std::size_t i = 0; i < data.size(); ++i) {
      again[i].en = fit.predictions[i].en + data[i].en_sigma * normal(random);
      again[i].tcol = fit.predictions[i].tcol + data[i].tcol_sigma * normal(random);
    }
    const Fit sample = fit_law(request, again);
    double d[2];
    for (int p = 0; p < 2; ++p) {
      d[p] = sample.parameters[p].value - fit.parameters[p].value;
      sum[p] += d[p], square[p] += d[p] * d[p];
    }
    product += d[0] * d[1];
  }
  double error[2];
  for (int p = 0; p < 2; ++p) {
    error[p] = std::sqrt((square[p] - sum[p] * sum[p] / samples) / (samples - 1));
    // A standard deviation from n samples has the relative error 1/√(2n); four of them.
    CHECK(error[p] / fit.parameters[p].error == Approx(1).margin(4 / std::sqrt(2.0 * samples)));
  }
  const double correlation = (product - sum[0] * sum[1] / samples) / (samples - 1) / (error[0] * error[1]);
  const double rho = fit.correlations[0][1];
  CHECK(correlation == Approx(rho).margin(4 * (1 - rho * rho) / std::sqrt(samples)));
}

TEST_CASE("a fit names what it cannot use") {
  const FitRequest request{LawName::linear, ContactEnd::force, mass};
  CHECK_THROWS_WITH(fit_law(request, {}), "measurements = 0: must be more than there are parameters");
  CHECK_THROWS_WITH(fit_law(request, {{1, 0.5, 0.1}}), "measurements = 1: must be more than there are parameters");
  CHECK_THROWS_WITH(fit_law(request, {{1, 1.5}, {2, 0.5}}), "en = 1.5: must be in (0, 1]");
  CHECK_THROWS_WITH(fit_law(request, {{-1, 0.5}, {2, 0.5}}), "velocity = -1: must be finite and > 0");
  CHECK_THROWS_WITH(fit_law(request, {{1, 0.5, 0.1}, {2, 0.5}}), Catch::StartsWith("en_sigma = 0: must be"));
  CHECK_THROWS_WITH(fit_law(request, {{1, 0.5, 0, 1e-4, 1e-6}, {2, 0.5, 0, 1e-4, 1e-6}}), Catch::StartsWith("en_sigma = 0: must be"));
  CHECK_THROWS_WITH(fit_law({LawName::hysteretic, ContactEnd::overlap, mass}, {{1, 0.5}, {2, 0.5}}),
                    "end = overlap: must be force for the law hysteretic");
}
