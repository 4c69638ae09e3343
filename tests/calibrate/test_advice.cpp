#include <calibrate/advice.hpp>
#include <run_watch.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

constexpr Impact impact{.velocity = 0.5, .mass_eff = 7.06858e-6};

}  // namespace

TEST_CASE("sensitivities are the exponents of the closed forms") {
  // e_n = sqrt(k1/k2), t_col = (pi/2) sqrt(m/k1) (1 + e_n).
  const auto walton = sensitivities(Hysteretic(4000, 16000), ContactEnd::force, impact);
  CHECK(*walton[0].en == Approx(0.5).epsilon(1e-6));
  CHECK(*walton[1].en == Approx(-0.5).epsilon(1e-6));
  CHECK(*walton[0].tcol == Approx(-0.5 + 0.5 * 0.5 / 1.5).epsilon(1e-6));
  CHECK(*walton[1].tcol == Approx(-0.5 * 0.5 / 1.5).epsilon(1e-6));
  // t_col ~ (c^alpha k^(1-alpha))^(-1/(2-alpha)), e_n of alpha alone.
  const double alpha = 0.3;
  const auto fractional = sensitivities(Fractional(5000, 0.3, alpha), ContactEnd::force, impact);
  CHECK(*fractional[0].tcol == Approx(-(1 - alpha) / (2 - alpha)).epsilon(1e-6));
  CHECK(*fractional[1].tcol == Approx(-alpha / (2 - alpha)).epsilon(1e-6));
  CHECK(*fractional[0].en == Approx(0).margin(1e-6));
  CHECK(*fractional[1].en == Approx(0).margin(1e-6));
  // A spring has no c to move, and k1 cannot rise above k2.
  CHECK_FALSE(sensitivities(Linear(5000, 0), ContactEnd::overlap, impact)[1].en);
  CHECK_FALSE(sensitivities(Hysteretic(4000, 4000), ContactEnd::force, impact)[0].en);
}

TEST_CASE("the error of a plain engine's step falls in proportion to it") {
  const Linear law(7316.0209, 0.0979913);
  const Collision exact = collide(law, impact, {.end = ContactEnd::overlap});
  const auto errors = step_errors(law, ContactEnd::overlap, {exact.tcol, exact.en, impact}, Stepping::half_step);
  const auto at = [&](int steps) {
    for (const StepError& e : errors)
      if (e.steps == steps) return e.error;
    return std::nan("");
  };
  CHECK(std::log10(at(80) / at(800)) == Approx(1).margin(0.1));
  const int enough = steps_for(errors, 0.01, Stepping::half_step).value();
  CHECK(at(enough) <= 0.01);
  CHECK(errors.back().error <= 0.001);
  CHECK_FALSE(steps_for(errors, 1e-9, Stepping::half_step));
  // Of one step the same, whether a whole number of them takes the collision or not.
  const auto error = [&](double steps) {
    return step_error(law, ContactEnd::overlap, {exact.tcol, exact.en, impact}, steps, Stepping::half_step);
  };
  CHECK(error(80) == at(80));
  CHECK(std::log10(error(88.8) / error(888)) == Approx(1).margin(0.2));  // the end falls elsewhere in its step
  CHECK_THROWS_AS(error(0), std::invalid_argument);
}

TEST_CASE("no step is advised that a driver warns of, nor one that twenty steps would leave off by a percent") {
  for (const double en : {0.1, 0.5, 0.95})
    for (const LawKind kind : {kind_of<Fractional>, kind_of<FractionalKelvinVoigt>, kind_of<FractionalZener>}) {
      const auto found = calibrate({kind, ContactEnd::force, {1e-4, en, impact}}, {.method = Method::direct});
      const auto* calibration = std::get_if<Calibration>(&found);
      if (!calibration) continue;
      CAPTURE(en, kind.name());
      const AnyLaw& law = calibration->law;
      const Target target{1e-4, en, impact};
      half_step::RunWatch watch;
      watch.begin_run(1, 0, 100);
      for (const EngineStep& s : engine_steps(law, ContactEnd::force, target))
        CHECK_FALSE(watch.look_at_step(0, impact.mass_eff, target.tcol, s.step.value()));
      CHECK(step_error(law, ContactEnd::force, target, half_step::RunWatch::advised_steps, Stepping::located) <= 0.01);
    }
}

TEST_CASE("the drivers locate the contact: its error falls with the square of the step") {
  const Fractional law(5225, 0.2964, 0.31967859);
  const Collision exact = collide(law, impact);
  const auto errors = step_errors(law, ContactEnd::force, {exact.tcol, exact.en, impact}, Stepping::located);
  const auto at = [&](int steps) {
    for (const StepError& e : errors)
      if (e.steps == steps) return e.error;
    return std::nan("");
  };
  // Measured in the engine over five places of the touch: 1.0e-3 at tcol/25, docs/liggghts.md.
  CHECK(at(25) == Approx(1.0e-3).epsilon(0.1));
  CHECK(std::log2(at(15) / at(30)) == Approx(2).margin(0.4));
  CHECK_THROWS_AS(step_errors(Linear(1, 1), ContactEnd::force, {1, 0.5, {1, 1}}, Stepping::located),
                  std::invalid_argument);
}

TEST_CASE("steps are advised for the engines that run the law and end it so") {
  const auto engines_of = [](const AnyLaw& law, ContactEnd end) {
    const Collision exact = collide(law, impact, {.end = end});
    std::vector<std::string> names;
    for (const EngineStep& s : engine_steps(law, end, {exact.tcol, exact.en, impact})) {
      CHECK(s.step.value() < exact.tcol);
      if (s.error_en == step_bounds[0]) names.push_back(s.engine);
    }
    return names;
  };
  using Names = std::vector<std::string>;
  CHECK(engines_of(Linear(7316, 0.098), ContactEnd::overlap) == Names{"liggghts", "lammps", "mercurydpm", "mfix"});
  CHECK(engines_of(Linear(7316, 0.098), ContactEnd::force) == Names{"liggghts", "lammps", "yade"});
  for (const AnyLaw& law : {AnyLaw(Fractional(5225, 0.2964, 0.3197)), AnyLaw(FractionalKelvinVoigt(3000, 20, 0.5)),
                            AnyLaw(FractionalHertz(1e6, 3e3, 0.4)), AnyLaw(FractionalZener(3000, 3e5, 1e-9, 0.5))})
    CHECK(engines_of(law, ContactEnd::force) == Names{"liggghts-ricochet", "lammps-ricochet"});
  CHECK(engines_of(FractionalKelvinVoigt(3000, 20, 0.5), ContactEnd::overlap).empty());
}

TEST_CASE("the error of a step is that of the worst place of the touch, as another program steps it") {
  const Linear law(7316.0209, 0.0979913);
  const Collision exact = collide(law, impact, {.end = ContactEnd::overlap});
  // Velocity first, where the advice takes half steps: the same contact.
  const auto missed = [&](int steps, double lead) {
    const double h = exact.tcol / steps;
    double overlap = (lead - 1) * h * impact.velocity, rate = impact.velocity;
    do {
      if (overlap > 0) rate -= h * (law.k() * overlap + law.c() * rate) / impact.mass_eff;
      overlap += h * rate;
    } while (overlap > 0);
    return std::abs(-rate / impact.velocity / exact.en - 1);
  };
  int in_the_middle = 0;
  for (const StepError& e :
       step_errors(law, ContactEnd::overlap, {exact.tcol, exact.en, impact}, Stepping::half_step)) {
    CAPTURE(e.steps);
    double within = 0;
    for (int place = 0; place < 16; ++place) within = std::max(within, missed(e.steps, (place + 0.5) / 16));
    const double at_edges = std::max(missed(e.steps, 1e-6), missed(e.steps, 1 - 1e-6));
    CHECK(e.error == Approx(std::max(within, at_edges)).epsilon(1e-9));
    in_the_middle += within > 1.01 * at_edges;
  }
  CHECK(in_the_middle > 0);  // else the edges would tell all
}

TEST_CASE("an advisor that has seen an e_n says of another collision time what engine_steps says") {
  StepAdvisor advisor;
  std::size_t told = 0;
  std::optional<double> seen;
  for (const double tcol : {0x1p-13, 0x1p-8, 0x1p-17}) {  // powers of two, so that e_n is the same to the bit
    const Linear law(10 * impact.mass_eff / (tcol * tcol), 1.3 * impact.mass_eff / tcol);
    const Collision exact = collide(law, impact);
    REQUIRE(seen.value_or(exact.en) == exact.en);
    seen = exact.en;
    const Target target{exact.tcol, exact.en, impact};
    const auto ours = advisor(law, ContactEnd::force, target), theirs = engine_steps(law, ContactEnd::force, target);
    REQUIRE(ours.size() == theirs.size());
    for (std::size_t i = 0; i < ours.size(); ++i) {
      CHECK(ours[i].engine == theirs[i].engine);
      REQUIRE(ours[i].step.has_value() == theirs[i].step.has_value());
      if (!ours[i].step) continue;
      CHECK(*ours[i].step == Approx(*theirs[i].step).epsilon(1e-14));
      ++told;
    }
  }
  CHECK(told > 3);
}

TEST_CASE("Hertz' time is that of the elastic collision, Rayleigh's as its source states it") {
  const Tsuji elastic(1.3e6, 0);
  CHECK(hertz_time_of(elastic, impact).value() == Approx(collide(elastic, impact).tcol).epsilon(1e-10));
  CHECK_FALSE(hertz_time_of(Linear(1, 0), impact));
  // Steel, G = 80.77 GPa: pi 1e-3 sqrt(7850/80.77e9)/(0.1631*0.3 + 0.8766) = 1.05821e-6 s.
  CHECK(rayleigh_time(1e-3, 7850, 210e9, 0.3) == Approx(1.05821e-6).epsilon(1e-5));
  CHECK_THROWS_AS(rayleigh_time(1e-3, 7850, 210e9, 0.6), std::invalid_argument);
}
