// Fits of the laws of real solids.
#include <calibrate/fit.hpp>
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

constexpr double mass = 2e-5;

/// What a law does at ten speeds over two decades, as collide has it, with stated errors that are not made.
template <class Law>
std::vector<Measurement> exact(const Law& law, bool with_times, ContactEnd end = ContactEnd::force) {
  std::vector<Measurement> data;
  for (int i = 0; i < 10; ++i) {
    const double v = 0.02 * std::pow(100.0, i / 9.0);
    const auto out = collide(law, {v, mass}, {end});
    data.push_back({v, out.en, 0.01});
    if (with_times) data.back().tcol = out.tcol, data.back().tcol_sigma = 0.01 * out.tcol;
  }
  return data;
}

template <class Law>
FitRequest request_of(const Held& held = {}, ContactEnd end = ContactEnd::force) {
  return {kind_of<Law>, end, mass, false, 0, held};
}

void check_parameters(const Fit& fit, const std::vector<NamedValue>& known, double relative) {
  REQUIRE(fit.parameters.size() == known.size());
  for (std::size_t i = 0; i < known.size(); ++i) {
    CHECK(fit.parameters[i].name == known[i].name);
    CHECK(fit.parameters[i].value == Approx(known[i].value).epsilon(relative));
  }
}

bool said(const Fit& fit, const std::string& what) {
  return std::any_of(fit.findings.begin(), fit.findings.end(),
                     [&](const std::string& finding) { return finding.find(what) != std::string::npos; });
}

}  // namespace

TEST_CASE("the speed tells the alpha of fractional-hertz, times its stiffness") {
  const FractionalHertz law(1.4e6, 2500, 0.6);
  const double group = law.c() / law.k() * std::pow(law.k() / mass, 0.4 * 0.6);
  const Fit timeless = fit_law(request_of<FractionalHertz>(), exact(law, false));
  CHECK(timeless.chi2 < 1e-9);
  check_parameters(timeless, {{"alpha", 0.6, ""}, {"(c/k) (k/m)^(2 alpha/5) at 1 m/s", group, ""}}, 1e-4);
  CHECK(predict(timeless, 0.3).en == Approx(collide(law, {0.3, mass}).en).margin(1e-6));
  CHECK(predict(timeless, 0.3).tcol == 0);
  CHECK(held(timeless.request).empty());
  const Fit timed = fit_law(request_of<FractionalHertz>(), exact(law, true));
  CHECK(timed.chi2 < 1e-9);
  check_parameters(timed, {{"k", 1.4e6, ""}, {"c", 2500, ""}, {"alpha", 0.6, ""}}, 1e-4);
  CHECK(predict(timed, 0.3).tcol == Approx(collide(law, {0.3, mass}).tcol).epsilon(1e-6));
}

TEST_CASE("of the linear two one restitution tells one number, with times two") {
  const FractionalKelvinVoigt kelvin_voigt(5000, 30, 0.4);
  const FractionalZener zener(5000, 1e5, 1e-7, 0.4);
  const Held held{.alpha = 0.4, .stiffening = 20};
  check_parameters(fit_law(request_of<FractionalKelvinVoigt>(held), exact(kelvin_voigt, true)),
                   {{"k", 5000, ""}, {"c", 30, ""}}, 1e-5);
  check_parameters(fit_law(request_of<FractionalZener>(held), exact(zener, true)), {{"k", 5000, ""}, {"tau", 1e-7, ""}},
                   1e-5);
  const double stiff = std::sqrt(5000 / mass);
  check_parameters(fit_law(request_of<FractionalKelvinVoigt>(held), exact(kelvin_voigt, false)),
                   {{"(c/k) (k/m)^(alpha/2)", 30.0 / 5000 * std::pow(stiff, 0.4), ""}}, 1e-5);
  const Fit timeless = fit_law(request_of<FractionalZener>(held), exact(zener, false));
  check_parameters(timeless, {{"tau sqrt(k/m)", 1e-7 * stiff, ""}}, 1e-5);
  CHECK(said(timeless,
             "held, not fitted: alpha = 0.4, k1/k = 20; the law says the same at every speed, one restitution"));
}

TEST_CASE("another alpha held says the same of the linear two: no speed tells it") {
  const FractionalKelvinVoigt law(5000, 30, 0.4);
  const Fit fit = fit_law(request_of<FractionalKelvinVoigt>({.alpha = 0.8}), exact(law, true));
  CHECK(fit.chi2 < 1e-9);
  CHECK(said(fit, "held, not fitted: alpha = 0.8; the law says the same at every speed, a time and a restitution"));
  CHECK_FALSE(follows_speed(fit.request));
  // Where α is 0 there is a spring and no loss.
  CHECK_THROWS_WITH(fit_law(request_of<FractionalKelvinVoigt>({.alpha = 0}), exact(law, false)),
                    "(c/k) (k/m)^(alpha/2) has no effect on these data, which cannot tell it");
  CHECK_THROWS_WITH(fit_law(request_of<FractionalZener>({.alpha = 0}), exact(law, false)),
                    "tau sqrt(k/m) has no effect on these data, which cannot tell it");
  CHECK_THROWS_WITH(fit_law(request_of<FractionalZener>({.alpha = 1.5}), exact(law, false)),
                    "alpha = 1.5: must be in [0, 1]");
  CHECK_THROWS_WITH(fit_law(request_of<FractionalZener>({.stiffening = 0}), exact(law, false)),
                    "k1/k = 0: must be finite and > 0");
}

TEST_CASE("a restitution below what the held alpha reaches runs to the end of the range") {
  const std::vector<Measurement> data{{0.1, 0.1, 0.01}, {0.3, 0.11, 0.01}, {1, 0.1, 0.01}};
  CHECK(said(fit_law(request_of<FractionalZener>(), data), "tau sqrt(k/m) has run to the end of its range"));
  CHECK(said(fit_law(request_of<FractionalKelvinVoigt>(), data), "has run to the end of its range"));
}

TEST_CASE("ended by overlap Kelvin and Voigt's law is recovered") {
  for (const double alpha : {0.25, 0.5}) {  // overlap returns at any loss of the first, at a bounded one of the second
    const FractionalKelvinVoigt law(5000, 30, alpha);
    const Fit fit = fit_law(request_of<FractionalKelvinVoigt>({.alpha = alpha}, ContactEnd::overlap),
                            exact(law, true, ContactEnd::overlap));
    check_parameters(fit, {{"k", 5000, ""}, {"c", 30, ""}}, 1e-5);
  }
}

TEST_CASE("impacts of several sizes tell one Hertzian material") {
  const double k = 1.4e6, c = 2500, alpha = 0.6;
  std::vector<Measurement> data;
  for (const double v : {0.02, 0.1, 0.5, 2.0})
    for (const double size : {1.0, 2.0, 0.5}) {
      const double hertz = std::sqrt(size), m = mass * size * size * size;
      const auto out = collide(FractionalHertz(k * hertz, c * hertz, alpha), {v, m});
      data.push_back({v, out.en, 0.01, out.tcol, 0.01 * out.tcol, m, 1e-3 * size});
    }
  const Fit fit = fit_law({kind_of<FractionalHertz>, ContactEnd::force, mass, false, 1e-3}, data);
  CHECK(fit.chi2 < 1e-9);
  check_parameters(fit, {{"k", k, ""}, {"c", c, ""}, {"alpha", alpha, ""}}, 1e-4);
}

TEST_CASE("the fit's own Hertzian collisions are those of the law, to 1e-9 and 2e-9") {
  // Inside the cells, across their edges and outside of them.
  for (const double alpha : {0.0012, 0.02, 0.11, 0.3, 0.5, 0.72, 0.74, 0.9, 0.97, 0.998})
    for (const double log_group : {-12.5, -3.7, -1.4, 0.3, 1.4, 1.6, 2.2}) {
      Fit fit{};
      fit.request = request_of<FractionalHertz>();
      fit.solution = {log_group, std::log(alpha / (1 - alpha)), std::log(7000.0)};
      fit.observations = 1;  // so that times are told
      const double unit = std::pow(mass / 7000, 0.4);
      const FractionalHertz law(7000, 7000 * std::exp(log_group) * std::pow(unit, alpha), alpha);
      const Prediction p = predict(fit, 1);
      const Collision out = collide(law, {1, mass});
      CAPTURE(alpha, log_group);
      CHECK(p.en == Approx(out.en).margin(1e-9).epsilon(0));
      CHECK(p.tcol == Approx(out.tcol).epsilon(2e-9));
    }
}

TEST_CASE("data of one restitution take the spring from fractional-hertz, or leave it elastic") {
  std::vector<Measurement> data;
  for (const double v : {0.02, 0.05, 0.1, 0.3, 1.0, 2.0})
    data.push_back({v, collide(FractionalHertz(0, 2500, 0.3), {v, mass}).en, 0.01});
  const Fit fit = fit_law(request_of<FractionalHertz>(), data);
  CHECK(fit.chi2 < 1e-4);
  CHECK(fit.parameters.at(0).value == Approx(0.3).epsilon(1e-3));
  CHECK(said(
      fit,
      "the spring takes a hundredth or less: k = 0, the pure power law, fits with one restitution at every speed"));
  for (Measurement& m : data) m.en = 1;
  CHECK(said(fit_law(request_of<FractionalHertz>(), data), "end of its range"));
}
