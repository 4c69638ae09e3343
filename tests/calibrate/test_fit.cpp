#include <calibrate/fit.hpp>
#include <catch2/catch.hpp>
#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <fmt/format.h>

#include <algorithm>
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

/// What `law` does at these speeds, by collide, with Gaussian errors of the given sizes; noise = 0: stated, but not
/// made.
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
  LawKind name;
  AnyLaw law;
};
const Truth truths[] = {{kind_of<Linear>, Linear(5000, 0.1)},
                        {kind_of<KuwabaraKono>, KuwabaraKono(1.4e6, 30)},
                        {kind_of<Tsuji>, Tsuji(1.4e6, 2)},
                        {kind_of<Hysteretic>, Hysteretic(4000, 9000)},
                        {kind_of<Fractional>, Fractional(5000, 0.3, 0.3)}};

bool said(const Fit& fit, const std::string& what) {
  return std::any_of(fit.findings.begin(), fit.findings.end(),
                     [&](const std::string& finding) { return finding.find(what) != std::string::npos; });
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

TEST_CASE("losses that no end by overlap knows are fitted where contacts end by force") {
  for (const LawKind kind : {kind_of<Linear>, kind_of<Tsuji>}) {
    std::vector<Measurement> data;
    for (const double v : speeds(5)) data.push_back({v, 0.05, 0.001});
    const Fit fit = fit_law({kind, ContactEnd::force, mass}, data);
    CAPTURE(kind.name());
    CHECK(predict(fit, 0.3).en == Approx(0.05).epsilon(1e-6));
    for (const std::string& finding : fit.findings) CHECK(finding.find("end of its range") == std::string::npos);
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
  FitRequest request{kind_of<Fractional>, ContactEnd::force, mass, true};
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
  CHECK(constant.findings.back() ==
        "misfit: the law gives the same restitution at every speed, the data change with it");
}

TEST_CASE("ended by overlap the laws that offer it are recovered") {
  const Truth ended[] = {truths[0], truths[2], {kind_of<Fractional>, Fractional(5000, 0.3, 0.3)}};
  for (const Truth& truth : ended) {
    std::vector<Measurement> data;
    for (const double v : speeds(8)) {
      const auto out = collide(truth.law, {v, mass}, {ContactEnd::overlap});
      data.push_back({v, out.en, 0.01, out.tcol, 0.01 * out.tcol});
    }
    const Fit fit = fit_law({truth.name, ContactEnd::overlap, mass}, data);
    CAPTURE(fit_name(fit.request));
    const auto known = identifiable(truth.law);
    for (std::size_t i = 0; i < known.size(); ++i)
      CHECK(fit.parameters.at(i).value == Approx(known[i].value).epsilon(1e-6));
  }
  std::vector<Measurement> data;
  const double a = 0.2, b = -0.4;
  for (const double v : speeds(8))
    data.push_back(
        {v, fractional_contact(overlap_limit / (1 + std::exp(-a - b * std::log(v))), ContactEnd::overlap).en});
  const Fit fit = fit_law({kind_of<Fractional>, ContactEnd::overlap, mass, true}, data);
  CHECK(fit.parameters.at(0).value == Approx(a).epsilon(1e-5));
  CHECK(fit.parameters.at(1).value == Approx(b).epsilon(1e-5));
}

TEST_CASE("the fit's own collisions are those of the laws, to 1e-9") {
  // u = (ln of what sets e_n, ln k), as in the fit.
  const auto predicted = [](LawKind name, ContactEnd end, double loss, double velocity) {
    Fit fit{};
    fit.request = {name, end, mass};
    fit.solution = {loss, std::log(7000.0)};
    fit.observations = 1;  // so that times are told
    return predict(fit, velocity);
  };
  for (double loss = -9.3; loss < 3; loss += 0.37)
    for (const ContactEnd end : {ContactEnd::force, ContactEnd::overlap}) {
      const double limit = end == ContactEnd::force ? 1 : overlap_limit;
      const double alpha = limit / (1 + std::exp(-loss));
      const Collision exact = collide(Fractional(7000, 7000, alpha), {0.5, mass}, {end});
      const Prediction p = predicted(kind_of<Fractional>, end, loss, 0.5);
      CAPTURE(loss, text(end));
      CHECK(p.en == Approx(exact.en).margin(1e-9).epsilon(0));
      CHECK(p.tcol == Approx(exact.tcol).epsilon(1e-9));
    }
  for (double gamma = -9.3; gamma < 3; gamma += 0.37) {
    const double time = std::pow(mass / 7000, 0.4);  // at v = 1 m/s
    const Collision kuwabara_kono =
        collide(KuwabaraKono(7000, std::exp(gamma) * mass * std::pow(time, -1.5)), {0.5, mass});
    const Collision tsuji = collide(Tsuji(7000, std::exp(gamma) * mass * std::pow(time, -1.25)), {0.5, mass});
    CAPTURE(gamma);
    const Prediction k = predicted(kind_of<KuwabaraKono>, ContactEnd::force, gamma, 0.5);
    const Prediction t = predicted(kind_of<Tsuji>, ContactEnd::force, gamma, 0.5);
    CHECK(k.en == Approx(kuwabara_kono.en).margin(1e-9).epsilon(0));
    CHECK(k.tcol == Approx(kuwabara_kono.tcol).epsilon(1e-9));
    CHECK(t.en == Approx(tsuji.en).margin(1e-9).epsilon(0));
    CHECK(t.tcol == Approx(tsuji.tcol).epsilon(1e-9));
  }
}

TEST_CASE("what the data cannot tell is said") {
  const FitRequest follows{kind_of<Fractional>, ContactEnd::force, mass, true};
  CHECK_THROWS_WITH(fit_law(follows, {{1, 0.5}, {1, 0.4}, {1, 0.45}}),
                    "b has no effect on these data, which cannot tell it");
  CHECK_THROWS_WITH(fit_law(follows, {{2, 0.5}, {2, 0.4}, {2, 0.45}}), "these data cannot tell a and b apart");
  for (const LawKind law :
       {kind_of<Linear>, kind_of<KuwabaraKono>, kind_of<Tsuji>, kind_of<Hysteretic>, kind_of<Fractional>}) {
    CAPTURE(law.name());
    CHECK(
        said(fit_law({law, ContactEnd::force, mass}, {{1, 1, 0.01}, {2, 1, 0.01}, {4, 1, 0.01}}), "end of its range"));
    const Fit timed = fit_law({law, ContactEnd::force, mass}, {{1, 1, 0.01, 1e-4, 1e-6}, {1, 1, 0.01, 1e-4, 1e-6}});
    const char* loss = law == kind_of<Hysteretic> ? "k" : law == kind_of<Fractional> ? "alpha" : "c";
    CHECK(std::any_of(timed.findings.begin(), timed.findings.end(), [&](const std::string& finding) {
      return finding.starts_with(loss) && finding.find("end of its range") != std::string::npos;
    }));
    const Fit vague = fit_law({law, ContactEnd::force, mass}, {{1, 0.5, 10}, {2, 0.6, 10}});
    CHECK(said(vague, "is not determined"));
    CHECK_FALSE(said(vague, "misfit"));
  }
  // No scatter at all: errors are 0, correlations stay what they are, and no law is hundreds of AIC better for its
  // rounding.
  const std::vector<Measurement> equal{{1, 0.5}, {2, 0.5}, {4, 0.5}, {8, 0.5}};
  const Fit linear = fit_law({kind_of<Linear>, ContactEnd::force, mass}, equal), two = fit_law(follows, equal);
  CHECK(std::abs(two.correlations.at(0).at(1)) < 1);
  CHECK(two.aic - linear.aic == Approx(2));
  CHECK_FALSE(said(linear, "misfit"));
  // A law that follows the speed can miss, too.
  CHECK(said(fit_law({kind_of<KuwabaraKono>, ContactEnd::force, mass}, equal),
             "what the law leaves over follows the speed"));
}

TEST_CASE("scatter of a few rows is seldom taken for a misfit, a real one still is") {
  std::mt19937_64 random(11);
  const FitRequest request{kind_of<Linear>, ContactEnd::force, mass};
  for (const int rows : {3, 4, 6, 12}) {
    CAPTURE(rows);
    int missed = 0;
    constexpr int trials = 2000;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<Measurement> data;
      for (int i = 0; i < rows; ++i)
        data.push_back({std::exp2(i), std::normal_distribution<double>(0.6, 0.02)(random)});
      missed += said(fit_law(request, data), "misfit");
    }
    CHECK(missed < 10);  // two of 2000 are to be expected at most
  }
  std::vector<Measurement> sloping;
  for (int i = 0; i < 6; ++i) sloping.push_back({std::exp2(i), 0.9 - 0.05 * i + 0.004 * (i % 2)});
  CHECK(said(fit_law(request, sloping), "misfit"));
}

TEST_CASE("errors and correlations are those of a parametric bootstrap") {
  std::mt19937_64 random(5);
  const auto data = measured(truths[1].law, 0.01, 0.02, random);
  const FitRequest request{kind_of<KuwabaraKono>, ContactEnd::force, mass};
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

TEST_CASE("a fit of one number is judged by the textbook's formulas") {
  // The linear law's restitution is one number at every speed, so its fit is the mean of the data. By hand, of three:
  const std::vector<double> en{0.7, 0.72, 0.77};
  const double mean = 0.73, squares = 0.03 * 0.03 + 0.01 * 0.01 + 0.04 * 0.04;
  const auto fitted = [&](double sigma) {
    std::vector<Measurement> data;
    for (std::size_t i = 0; i < en.size(); ++i) data.push_back({0.1 * static_cast<double>(i + 1), en[i], sigma});
    return fit_law({kind_of<Linear>, ContactEnd::overlap, mass}, data);
  };
  const double beta = damping_of_restitution(mean, ContactEnd::overlap);
  const double slope = (restitution_of_damping(beta + 1e-6, ContactEnd::overlap) -
                        restitution_of_damping(beta - 1e-6, ContactEnd::overlap)) /
                       2e-6;

  const double sigma = 0.03, chi2 = squares / (sigma * sigma);
  const Fit weighted = fitted(sigma);
  CHECK(weighted.parameters[0].value == Approx(beta).epsilon(1e-6));
  CHECK(weighted.parameters[0].error == Approx(sigma / std::sqrt(3.0) / std::abs(slope)).epsilon(1e-5));
  CHECK(weighted.chi2 == Approx(chi2).epsilon(1e-8));
  CHECK(weighted.freedom == 2);
  CHECK(weighted.aic == Approx(chi2 + 2).epsilon(1e-8));
  CHECK(weighted.aicc.value() == Approx(chi2 + 2 + 2 * 1 * 2 / (3 - 1 - 1)).epsilon(1e-8));
  CHECK(weighted.probability == Approx(std::exp(-chi2 / 2)).epsilon(1e-8));  // of two degrees of freedom

  const Fit plain = fitted(0);  // σ² = Σ/(n − 1)
  CHECK(plain.parameters[0].error == Approx(std::sqrt(squares / 2 / 3) / std::abs(slope)).epsilon(1e-5));
  CHECK(plain.aic == Approx(3 * std::log(squares / 3) + 4).epsilon(1e-8));
  CHECK_FALSE(plain.aicc.has_value());  // a mean and a scatter of three numbers leave nothing
  CHECK(plain.probability == 1);
}

TEST_CASE("a chi2 is called a misfit where it comes less than once in a thousand") {
  // Of two degrees of freedom a χ² is passed with the probability exp(−χ²/2); one speed, so that none is followed.
  const auto said = [](double probability) {
    const double sigma = std::sqrt((0.03 * 0.03 + 0.01 * 0.01 + 0.04 * 0.04) / (-2 * std::log(probability)));
    const Fit fit = fit_law({kind_of<Linear>, ContactEnd::overlap, mass},
                            {{0.3, 0.7, sigma}, {0.3, 0.72, sigma}, {0.3, 0.77, sigma}});
    CHECK(fit.probability == Approx(probability).epsilon(1e-6));
    return std::any_of(fit.findings.begin(), fit.findings.end(), [](const std::string& finding) {
      return finding == "misfit: a chi2 this large comes by chance less than once in a thousand";
    });
  };
  CHECK(said(0.99e-3));
  CHECK_FALSE(said(1.01e-3));
}

TEST_CASE("the AIC's order is told, laws that say the same together") {
  std::mt19937_64 random(11);
  const auto data = measured(KuwabaraKono(1.4e6, 30), 0.01, 0, random);
  std::vector<Fit> fits;
  for (const LawKind law : {kind_of<Linear>, kind_of<KuwabaraKono>, kind_of<Tsuji>})
    fits.push_back(fit_law({law, ContactEnd::force, mass}, data));
  const Preference found = preferred(fits);
  CHECK(found.best == std::vector<std::size_t>{1});
  CHECK((found.next == 0 || found.next == 2));
  CHECK(found.ahead == Approx(fits[0].aic - fits[1].aic).epsilon(1e-6));
  CHECK(preference_text(fits) == fmt::format("By the AIC kuwabara-kono fits best; {:.1f} over it comes {}.",
                                             found.ahead, fit_name(fits[*found.next].request)));
  CHECK(preference_text({fits[0], fits[2]}) == "By the AIC none fits better than another of linear, tsuji.");
  fits[1].aic = fits[0].aic + 5;
  CHECK(preference_text(fits) == "By the AIC linear, tsuji fit best; 5.0 over them comes kuwabara-kono.");
  CHECK(preference_text({fits[0]}).empty());
  CHECK_THROWS_WITH(preferred({}), "fits = 0: must be at least 1");
}

TEST_CASE("a fit names what it cannot use") {
  const FitRequest request{kind_of<Linear>, ContactEnd::force, mass};
  CHECK_THROWS_WITH(fit_law(request, {}), "measurements = 0: must be at least 1");
  CHECK_THROWS_WITH(fit_law(request, {{1, 0.5, 0.1}}),
                    "observations = 1: must be more than the parameters of linear, 1");
  CHECK_THROWS_WITH(fit_law(request, {{1e31, 0.5}, {2, 0.5}}), "velocity = 1e+31: must be in [1e-30, 1e30]");
  CHECK_THROWS_WITH(fit_law({kind_of<Tsuji>, ContactEnd::force, mass, true}, {{1, 0.5}, {2, 0.5}}),
                    "alpha_of_speed = true: must be false for the law tsuji");
  CHECK_THROWS_WITH(fit_law(request, {{1, 1.5}, {2, 0.5}}), "en = 1.5: must be in (0, 1]");
  CHECK_THROWS_WITH(fit_law(request, {{-1, 0.5}, {2, 0.5}}), "velocity = -1: must be finite and > 0");
  CHECK_THROWS_WITH(fit_law(request, {{1, 0.5, 0.1}, {2, 0.5}}), Catch::StartsWith("en_sigma = 0: must be"));
  CHECK_THROWS_WITH(fit_law(request, {{1, 0.5, 0, 1e-4, 1e-6}, {2, 0.5, 0, 1e-4, 1e-6}}),
                    Catch::StartsWith("en_sigma = 0: must be"));
  CHECK_THROWS_WITH(fit_law({kind_of<Hysteretic>, ContactEnd::overlap, mass}, {{1, 0.5}, {2, 0.5}}),
                    "end = overlap: must be force for the law hysteretic");
}

TEST_CASE("impacts of bodies of several sizes tell one material") {
  constexpr double radius = 1e-3;
  // Each law at another size, as a material makes it: k of ζ^{3/2} goes with √R, c/k of Kuwabara and Kono's law stays,
  // and of the others what sets e_n.
  const auto resized = [](const AnyLaw& law, double m, double r) -> AnyLaw {
    const double hertz = std::sqrt(r);
    if (const auto* l = std::get_if<Linear>(&law)) return Linear(l->k(), l->c() * std::sqrt(m));
    if (const auto* l = std::get_if<Tsuji>(&law)) return Tsuji(l->k() * hertz, l->c() * std::sqrt(m * hertz));
    if (const auto* l = std::get_if<KuwabaraKono>(&law)) return KuwabaraKono(l->k() * hertz, l->c() * hertz);
    return law;
  };
  for (const Truth& truth : truths) {
    CAPTURE(truth.name.name());
    std::vector<Measurement> data;
    for (const double v : speeds(6))
      for (const double size : {1.0, 2.0, 0.5}) {
        const double m = size * size * size;
        const auto out = collide(resized(truth.law, m, size), {v, mass * m});
        data.push_back({v, out.en, 0.01, out.tcol, 0.01 * out.tcol, mass * m, radius * size});
      }
    const Fit fit = fit_law({truth.name, ContactEnd::force, mass, false, radius}, data);
    CHECK(fit.chi2 < 1e-8);
    const auto known = identifiable(truth.law);
    for (std::size_t i = 0; i < known.size(); ++i)
      CHECK(fit.parameters[i].value == Approx(known[i].value).epsilon(1e-6));
    CHECK(fit.predictions[1].tcol == Approx(data[1].tcol).epsilon(1e-6));
  }
}

TEST_CASE("a slip of the pen is named, by its line where that is known") {
  std::mt19937_64 random(7);
  auto data = measured(Linear(5000, 0.1), 0.01, 0, random);
  const auto names_one = [&](const std::string& where) {
    const Fit fit = fit_law({kind_of<Linear>, ContactEnd::force, mass}, data);
    return std::any_of(fit.findings.begin(), fit.findings.end(), [&](const std::string& f) {
      return f.starts_with(where) && f.find("far outside") != std::string::npos;
    });
  };
  CHECK_FALSE(names_one(""));
  data[4].en *= 0.1;
  CHECK(names_one("measurement 5: "));
  data[4].line = 9;
  CHECK(names_one("line 9: "));
  for (Measurement& m : data) m.en_sigma = 0;
  CHECK(names_one("line 9: "));
  data.resize(5);  // one of five is still out
  CHECK(names_one("line 9: "));
  data.erase(data.begin());
  CHECK_FALSE(names_one(""));
}
