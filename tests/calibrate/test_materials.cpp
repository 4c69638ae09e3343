#include <calibrate/materials.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

Materials sizes(LawKind law, ContactEnd end = ContactEnd::force) {
  Materials m{.law = law, .end = end, .velocity = 0.4};
  m.all = {{.name = "grain", .density = 2500, .least = 1e-3, .greatest = 3e-3, .solid = ElasticSolid{1e7, 0.3}},
           {.name = "wall", .wall = true, .solid = ElasticSolid{5e7, 0.2}}};
  m.pairs = {{0, 0, 0.7}, {0, 1, 0.6}};
  return m;
}

std::vector<PairResult> found(const Materials& m) {
  std::vector<PairResult> all;
  for (const PairOutcome& outcome : calibrate_pairs(m)) all.push_back(std::get<PairResult>(outcome));
  return all;
}

double sphere(double radius) { return 4 * std::numbers::pi / 3 * radius * radius * radius * 2500; }

}  // namespace

TEST_CASE("a pair of materials: Hertz' stiffness of both moduli, at the middle of the radii") {
  const auto pairs = found(sizes(kind_of<Tsuji>));
  const double of_grains = 1e7 / (2 * (1 - 0.09)), at_wall = 1 / ((1 - 0.09) / 1e7 + (1 - 0.04) / 5e7);
  CHECK(std::get<Tsuji>(pairs[0].found.law).k() == Approx(4.0 / 3 * of_grains * std::sqrt(1e-3)).epsilon(1e-9));
  CHECK(std::get<Tsuji>(pairs[1].found.law).k() == Approx(4.0 / 3 * at_wall * std::sqrt(2e-3)).epsilon(1e-9));
  CHECK(pairs[0].target.impact.mass_eff == Approx(sphere(2e-3) / 2).epsilon(1e-14));
  CHECK(pairs[1].target.impact.mass_eff == Approx(sphere(2e-3)).epsilon(1e-14));
  CHECK(pairs[1].found.achieved.en == Approx(0.6).epsilon(1e-9));
  Materials soft = sizes(kind_of<Tsuji>);
  soft.soften = 100;
  CHECK(100 * std::get<Tsuji>(found(soft)[0].found.law).k() ==
        Approx(std::get<Tsuji>(pairs[0].found.law).k()).epsilon(1e-9));
}

TEST_CASE("stiffnesses of materials act in series; a pair's own come first") {
  Materials m{.law = kind_of<Linear>, .end = ContactEnd::overlap, .velocity = 1};
  m.all = {{.name = "soft", .density = 1000, .least = 1e-3, .greatest = 1e-3, .stiffness = 1000},
           {.name = "hard", .density = 1000, .least = 1e-3, .greatest = 1e-3, .stiffness = 4000}};
  m.pairs = {{0, 0, 0.5}, {0, 1, 0.5}, {1, 1, 0.5, 1e-4}};
  const auto pairs = found(m);
  CHECK(std::get<Linear>(pairs[0].found.law).k() == Approx(1000).epsilon(1e-9));
  CHECK(std::get<Linear>(pairs[1].found.law).k() == Approx(1600).epsilon(1e-9));
  CHECK(pairs[2].target.tcol == 1e-4);
  m.all[0].stiffness.reset();
  CHECK_THROWS_AS(calibrate_pairs(m), std::invalid_argument);
}

TEST_CASE("over sizes Tsuji's law keeps the restitution, and its time follows from the material") {
  const Materials m = sizes(kind_of<Tsuji>);
  const auto pairs = found(m);
  const auto contacts = over_sizes(m, pairs[0], Kept::numbers);
  REQUIRE(contacts.size() == 3);
  for (const SizedContact& s : contacts) CHECK(s.collision.en == Approx(0.7).epsilon(1e-8));
  // t ~ (m^2/(k^2 v))^{1/5} with m ~ r^3 and k ~ r^{1/2}: in proportion to r.
  CHECK(contacts[2].collision.tcol / contacts[0].collision.tcol == Approx(3).epsilon(1e-8));
  CHECK(contacts[1].radius_a == 1e-3);
  CHECK(contacts[1].radius_b == 3e-3);
  CHECK(contacts[1].radius_eff == Approx(0.75e-3).epsilon(1e-14));
  const auto walls = over_sizes(m, pairs[1], Kept::numbers);
  REQUIRE(walls.size() == 2);
  CHECK(walls[1].collision.tcol / walls[0].collision.tcol == Approx(3).epsilon(1e-8));
}

TEST_CASE("over sizes the linear law keeps its numbers, its restitution or its target") {
  const Materials m = sizes(kind_of<Linear>, ContactEnd::overlap);
  const auto pairs = found(m);
  const Linear& law = std::get<Linear>(pairs[0].found.law);
  const double mass = sphere(1e-3) / 2;
  const auto numbers = over_sizes(m, pairs[0], Kept::numbers)[0];
  // e_n = exp(-pi beta/sqrt(1 - beta^2)).
  const double beta = law.c() / (2 * std::sqrt(mass * law.k()));
  CHECK(numbers.collision.en == Approx(std::exp(-std::numbers::pi * beta / std::sqrt(1 - beta * beta))).epsilon(1e-9));
  CHECK(numbers.collision.en < 0.5);
  const auto restitution = over_sizes(m, pairs[0], Kept::restitution)[0];
  CHECK(restitution.collision.en == Approx(0.7).epsilon(1e-9));
  CHECK(restitution.collision.tcol == Approx(pairs[0].target.tcol * std::sqrt(1 / 8.0)).epsilon(1e-9));
  const auto target = over_sizes(m, pairs[0], Kept::target)[0];
  CHECK(target.collision.en == Approx(0.7).epsilon(1e-9));
  CHECK(target.collision.tcol == Approx(pairs[0].target.tcol).epsilon(1e-9));
  CHECK(kept_by("lammps", kind_of<Linear>) == Kept::restitution);
  CHECK(kept_by("liggghts", kind_of<Linear>) == Kept::numbers);
  CHECK(kept_by("liggghts", kind_of<Fractional>) == Kept::target);
}

TEST_CASE("over sizes Kuwabara and Kono's law keeps Brilliantov's A and loses more in small grains") {
  const Materials m = sizes(kind_of<KuwabaraKono>);
  const auto pairs = found(m);
  const auto contacts = over_sizes(m, pairs[0], Kept::numbers);
  const auto A = [](const AnyLaw& law) {
    return 2 * std::get<KuwabaraKono>(law).c() / (3 * std::get<KuwabaraKono>(law).k());
  };
  CHECK(A(contacts[0].law) == Approx(A(pairs[0].found.law)).epsilon(1e-13));
  CHECK(contacts[0].collision.en < 0.7);
  CHECK(contacts[2].collision.en > 0.7);
}

TEST_CASE("the time step serves every pair and size") {
  const Materials m = sizes(kind_of<Tsuji>);
  const auto pairs = found(m);
  const auto steps = engine_steps(m, pairs);
  REQUIRE(steps.size() == 6);  // liggghts, lammps, yade; two bounds
  double least = 1;
  for (const PairResult& p : pairs)
    for (const SizedContact& s : over_sizes(m, p, Kept::numbers))
      for (const EngineStep& e : engine_steps(s.law, m.end, {s.collision.tcol, s.collision.en, s.impact}))
        if (e.engine == "lammps" && e.error_en == 0.001) least = std::min(least, e.step.value());
  CHECK(steps[3].engine == "lammps");
  CHECK(steps[3].step.value() == Approx(least).epsilon(1e-12));
  // The file sets the same one.
  const std::string text = export_contacts(Engine::lammps, contact_set(m, pairs, Kept::numbers)).text;
  CHECK(std::stod(text.substr(text.find("\ntimestep ") + 10)) == Approx(least).epsilon(1e-9));
}

TEST_CASE("exports tell of the sizes that never part under their numbers, and who keeps the restitution") {
  // c is kept while the mass falls as r³: from the middle (r = 5.5) to the least (r = 1) the damping ratio grows by
  // √(5.5³) = 12.9, from 0.2155 of e_n = 0.5 to 2.8. An overdamped contact ended by overlap does not end.
  Materials m = sizes(kind_of<Linear>, ContactEnd::overlap);
  m.all = {{.name = "grain", .density = 1000, .least = 1e-3, .greatest = 10e-3, .stiffness = 1000}};
  m.pairs = {{0, 0, 0.5}};
  const auto pairs = found(m);
  for (const Engine engine : {Engine::liggghts, Engine::mercurydpm}) {
    const Snippet snippet = export_contacts(engine, contact_set(m, pairs, kept_by(text(engine), m.law)));
    CHECK(snippet.text.find("NEVER PART: grain and grain") != std::string::npos);
    CHECK(snippet.remarks.back().find("lammps, yade") != std::string::npos);
  }
  const Snippet kept = export_contacts(Engine::lammps, contact_set(m, pairs, kept_by("lammps", m.law)));
  CHECK(kept.text.find("NEVER PART") == std::string::npos);
}

TEST_CASE("moduli of materials come back out of the matrix of an engine") {
  const Materials m = sizes(kind_of<Tsuji>);
  const std::string text = export_contacts(Engine::liggghts, contact_set(m, found(m), Kept::numbers)).text;
  const std::string mark = "youngsModulus peratomtype ";
  std::size_t next = 0;
  const std::string rest = text.substr(text.find(mark) + mark.size());
  CHECK(std::stod(rest, &next) == Approx(1e7).epsilon(1e-9));
  CHECK(std::stod(rest.substr(next)) == Approx(5e7).epsilon(1e-9));
  CHECK(text.find("poissonsRatio peratomtype 0.3 0.2\n") != std::string::npos);
}

TEST_CASE("a pair out of reach says so, the others stay") {
  Materials m{.law = kind_of<Linear>, .end = ContactEnd::overlap, .velocity = 1};
  m.all = {{.name = "a", .density = 1000, .least = 1e-3, .greatest = 1e-3}, {.name = "w", .wall = true}};
  m.pairs = {{0, 0, 0.5, 1e-4}, {0, 1, 1e-300, 1e-4}};
  const auto outcomes = calibrate_pairs(m);
  CHECK(std::holds_alternative<PairResult>(outcomes[0]));
  CHECK(std::holds_alternative<PairMissed>(outcomes[1]));
}

TEST_CASE("what keeps e_n at every size is written where the engine can be given these pairs' numbers") {
  const auto written = [](double en_of_grains, double en_at_wall) {
    Materials m = sizes(kind_of<Tsuji>);
    m.pairs = {{0, 0, en_of_grains}, {0, 1, en_at_wall}};
    std::vector<std::string> engines;
    for (const SizeChoice& c : size_choices(m, found(m))) {
      CHECK(c.written == c.refusal.empty());
      if (c.written) engines.push_back(c.engine);
    }
    return engines;
  };
  using Names = std::vector<std::string>;
  // LIGGGHTS damps by the logarithmic form of a restitution, which ends by force at 0.2137: beta = 1 of -ln e/hypot.
  CHECK(written(0.7, 0.6) == Names{"liggghts", "lammps", "yade", "mercurydpm", "mfix"});
  CHECK(written(0.7, 0.2).front() == "lammps");
  CHECK(written(0.2, 0.6).front() == "lammps");
  Materials two = sizes(kind_of<Linear>);
  two.all.insert(two.all.begin() + 1, two.all.front());
  two.all[1].name = "other";
  two.pairs = {{0, 0, 0.7}, {0, 1, 0.7}, {1, 1, 0.7}, {0, 2, 0.7}, {1, 2, 0.7}};
  for (const SizeChoice& c : size_choices(two, found(two)))
    if (c.engine == "mfix") CHECK(c.refusal.find("one solids phase") != std::string::npos);
}

TEST_CASE("a pair's beta0 is its tangential spring at its own mass and time; Mindlin's is of both materials' moduli") {
  Materials m = sizes(kind_of<Tsuji>);
  m.pairs[1].beta0 = 0.5;
  m.pairs[1].mu = 0.3;
  const auto linear = found(m);
  CHECK_FALSE(linear[0].tangential);
  const double m_t = 2.0 / 7 * sphere(2e-3), t = linear[1].target.tcol;
  CHECK(values(linear[1].tangential->law)[0] ==
        Approx(m_t * (std::pow(std::numbers::pi, 2) + std::pow(std::log(0.5), 2)) / (t * t)).epsilon(1e-12));
  CHECK(linear[1].tangential->mu == 0.3);
  m.tangential = TangentialForm::mindlin;
  m.pairs[1].beta0.reset();
  const double G1 = 1e7 / 2.6, G2 = 5e7 / 2.4, G = 1 / (1.7 / G1 + 1.8 / G2);
  CHECK(values(found(m)[1].tangential->law)[0] == Approx(8 * G * std::sqrt(2e-3)).epsilon(1e-12));
  m.tangential = TangentialForm::linear;
  m.pairs[1].beta0 = -0.5;
  CHECK(std::get<PairMissed>(calibrate_pairs(m)[1]).why.quantity == "beta0");
}
