#include "conformance_cases.hpp"

#include "../../verify/conformance/causes.hpp"
#include "../../verify/conformance/half_step.hpp"
#include "../../verify/conformance/ricochet_run.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

using namespace ricochet;
using namespace ricochet::verify::conformance;

namespace {

/// What our own stepping makes of a case that was misunderstood, given as the answer to the case itself.
std::vector<Cause> causes_of(const std::string& name, const std::function<void(Case&)>& misunderstand,
                             Verdict* verdict = nullptr) {
  const Answered a = answered_case(name);
  Case other = a.of;
  misunderstand(other);
  CaseResult result{name};
  for (const int n : other.steps) result.runs.push_back(run_ricochet(other, n));
  const CaseGrade g = grade(a, &result);
  if (verdict) *verdict = g.verdict;
  return causes(a, result, g);
}

bool names(const std::vector<Cause>& causes, const std::string& what) {
  return !causes.empty() && causes.front().what.find(what) != std::string::npos;
}

void scale_law(std::optional<Meeting>& meeting, double spring, double dashpot) {
  std::vector<double> v = values(meeting->law);
  v[0] *= spring, v[1] *= dashpot;
  meeting->law = LawKind::of(meeting->law).with(v);
}

/// Symplectic steps of a sphere and a wall, written down once more: what engines do.
CaseResult half_steps(const Answered& a, double k, double c, bool clipped) {
  CaseResult result{a.of.name};
  for (const int n : a.of.steps) {
    const double h = a.of.time_scale / n, m = a.of.bodies[0].mass, r = a.of.bodies[0].radius;
    double x = r + 1.5 * h * 0.5, v = -0.5, force = 0;
    for (long i = 0; i < a.of.steps_of_run(n); ++i) {
      v += 0.5 * h * force / m;
      x += h * v;
      force = x < r ? k * (r - x) - c * v : 0;
      if (clipped) force = std::max(0.0, force);
      v += 0.5 * h * force / m;
    }
    Run run{n, a.of.bodies};
    run.bodies[0].position.x = x, run.bodies[0].velocity.x = v;
    result.runs.push_back(run);
  }
  return result;
}

/// How an engine makes the oblique contact of a sphere and a wall, where it departs from what is asked.
struct Engine {
  bool clips = true;
  /// What friction is limited by, of the force before and after clipping and the spring's part of it.
  std::function<double(double whole, double acts, double spring)> rubs = [](double, double acts, double) {
    return std::max(0.0, acts);
  };
};

/// Symplectic steps of such a contact, written down once more: tangential spring without dashpot, torsion the same.
CaseResult oblique_steps(const Answered& a, const Engine& engine) {
  const Case& of = a.of;
  const std::vector<double> law = values(of.wall_law->law);
  const TangentialContact& t = of.tangential.value();
  const double k_t = values(t.law).front(), mu = t.friction.mu_static();
  CaseResult result{of.name};
  for (const int n : of.steps) {
    const double h = of.step(n), m = of.bodies[0].mass, r = of.bodies[0].radius, inertia = 0.4 * m * r * r;
    Body b = of.start(n).front();
    double strain = 0, twist = 0;
    for (long i = 0; i < of.steps_of_run(n); ++i) {
      b.position += h * b.velocity;
      const double overlap = r - b.position.x;
      if (overlap <= 0) {
        strain = twist = 0;
        continue;
      }
      const double spring = law[0] * overlap, whole = spring - law[1] * b.velocity.x;
      const double acts = engine.clips ? std::max(0.0, whole) : whole, limit = mu * engine.rubs(whole, acts, spring);
      strain = std::clamp(strain + h * (b.velocity.y - r * b.spin.z), -limit / k_t, limit / k_t);
      b.velocity.x += h / m * acts, b.velocity.y -= h / m * k_t * strain, b.spin.z += h / inertia * r * k_t * strain;
      if (t.torsion.limit == Torsion::Limit::none) continue;
      const double k = t.torsion.spring.stiffness, disc = std::sqrt(overlap * (2 * r - overlap));
      const double most = t.torsion.arm * disc * limit / k;
      twist = std::clamp(twist + h * b.spin.x, -most, most);
      b.spin.x -= h / inertia * k * twist;
    }
    result.runs.push_back({n, {b}});
  }
  return result;
}

CaseGrade explained_of(const std::string& name, const Engine& engine) {
  static std::map<std::string, Answered> known;
  const Answered& a = known.try_emplace(name, answered_case(name)).first->second;
  const CaseResult result = oblique_steps(a, engine);
  return explained(a, &result);
}

}  // namespace

TEST_CASE("conformance: friction that goes with another normal force is told, and an end that attracts") {
  const auto size = [](double, double acts, double) { return std::abs(acts); };
  const auto unclipped = [](double whole, double, double) { return std::abs(whole); };
  const auto spring = [](double, double, double elastic) { return elastic; };
  const auto what_of = [](const std::string& name, const Engine& engine) {
    const CaseGrade g = explained_of(name, engine);
    CHECK(g.verdict == Verdict::elsewhere);
    return g.causes.empty() ? std::string("none") : g.causes.front().what;
  };
  for (const char* name : {"oblique-mixed", "oblique-sliding", "torsion-spin-down"}) {
    INFO(name);
    CHECK(explained_of(name, {}).verdict == Verdict::converges);
    CHECK(what_of(name, {.clips = false}) == "contacts end by overlap: attraction is not clipped");
    CHECK(what_of(name, {.clips = false, .rubs = size}) ==
          "contacts end by overlap: attraction is not clipped; friction is limited by μ|F|, under attraction too");
    CHECK(what_of(name, {.rubs = unclipped}) ==
          "friction is limited by μ|F| of the normal force before attraction is clipped");
    CHECK(what_of(name, {.rubs = spring}) == "friction is limited by μ times the force of the normal spring alone");
  }
}

TEST_CASE("conformance: no cause is told of what none explains") {
  // A little off in one number: nearer to many a misunderstanding than to nothing, and none of them.
  const auto with = [](double spring, double mu) {
    return [=](Case& c) {
      c.tangential->law = LinearTangential(spring * values(c.tangential->law).front());
      const double before = c.tangential->friction.mu_static();
      c.tangential->friction = Friction(mu * before, mu * before, 0);
    };
  };
  for (const char* name : {"dem05", "oblique-sticking", "oblique-mixed", "oblique-unequal-pair"})
    for (const double off : {-0.03, -0.01, 0.01, 0.03}) {
      INFO(name << ' ' << off);
      for (const auto& wrong : {with(1 + off, 1), with(1, 1 + off)})
        for (const Cause& cause : causes_of(name, wrong)) FAIL_CHECK(cause.what);
    }
}

TEST_CASE("conformance: causes that explain equally well are told as such") {
  // Nothing slides in this case but the torsion, which is friction.
  const std::vector<Cause> all = causes_of("torsion-spin-down", [](Case& c) { c.tangential->torsion = {}; });
  REQUIRE(all.size() == 2);
  CHECK(all[0].what == "torsion left out");
  CHECK(all[1].what == "friction left out");
  // What fits clearly better is told alone: k_t twice as great is not k_t left out.
  const std::vector<Cause> one = causes_of(
      "oblique-mixed", [](Case& c) { c.tangential->law = LinearTangential(2 * values(c.tangential->law).front()); });
  REQUIRE(one.size() == 1);
}

TEST_CASE("conformance: a rule for tangential springs that engines have is another rule, and not merely elsewhere") {
  const Answered a = answered_case("oblique-mindlin");
  const auto of_rule = [&](verify::Rule rule) {
    const Solution there = by_rule(a.of, rule, {}).value();
    CaseResult result{a.of.name};
    for (const int n : a.of.steps) result.runs.push_back({n, there.bodies});
    return explained(a, &result);
  };
  const CaseGrade strain = of_rule({true, verify::Rule::Keeps::strain}),
                  force = of_rule({true, verify::Rule::Keeps::force});
  CHECK(strain.verdict == Verdict::another_rule);
  CHECK(names(strain.causes, "keeps its strain while the contact grows, too (LIGGGHTS"));
  CHECK(force.verdict == Verdict::another_rule);
  CHECK(names(force.causes, "keeps its force while the contact shrinks, too (Yade"));
  CHECK(strain.worst()->verdict == Verdict::elsewhere);
  // Together with something else it is no longer the rule alone.
  CHECK(explained_of("oblique-mixed", {.clips = false}).verdict == Verdict::elsewhere);
}

TEST_CASE("conformance: a rule that explains no worse than something else is another rule, too") {
  const Results liggghts = read_results(RICOCHET_SOURCE_DIR "/data/conformance/liggghts-3.8.0.csv", all_cases());
  const CaseGrade g = explained(answered_case("chung-ooi-8-nylon"), liggghts.find("chung-ooi-8-nylon"));
  REQUIRE(g.causes.size() == 2);
  CHECK(g.causes[0].what == "tangential spring half as stiff");
  CHECK_FALSE(g.causes[0].rule);
  CHECK(g.causes[1].rule);
  CHECK(g.verdict == Verdict::another_rule);
}

TEST_CASE("conformance: our own stepping of the case as asked needs no cause") {
  Verdict verdict = Verdict::not_run;
  CHECK(causes_of(
            "normal-linear-force", [](Case&) {}, &verdict)
            .empty());
  CHECK(verdict == Verdict::converges);
}

TEST_CASE("conformance: what changes nothing in a case is no cause of what it shows") {
  // No dashpot: however its contacts end they end at the same time, and its damping may be anything.
  const Answered a = answered_case("normal-elastic");
  Case stiffer = a.of;
  scale_law(stiffer.law, 1.01, 1);
  CaseResult result{a.of.name};
  for (const int n : stiffer.steps) result.runs.push_back(run_ricochet(stiffer, n));
  const CaseGrade g = grade(a, &result);
  REQUIRE(g.verdict == Verdict::elsewhere);
  for (const Cause& cause : causes(a, result, g)) {
    INFO(cause.what);
    CHECK(cause.what.find("end by overlap") == std::string::npos);
    CHECK(cause.what.find("damping") == std::string::npos);
  }
}

TEST_CASE("conformance: the velocity of half a step before is recognised to rounding") {
  const Answered a = answered_case("wall-linear-force");
  const std::vector<double> v = values(a.of.wall_law->law);
  const CaseResult right = half_steps(a, v[0], v[1], true);
  CaseGrade g = grade(a, &right);
  CHECK(g.verdict == Verdict::converges);
  std::vector<Cause> all = causes(a, right, g);
  REQUIRE(all.size() == 1);
  CHECK(all[0].repeated);
  CHECK(all[0].misfit < 1e-11);
  CHECK(names(all, "half a step before"));
  CHECK_FALSE(names(all, "contacts end"));

  const CaseResult unclipped = half_steps(a, v[0], v[1], false);
  g = grade(a, &unclipped);
  CHECK(g.verdict == Verdict::elsewhere);
  all = causes(a, unclipped, g);
  CHECK(
      names(all, "contacts end by overlap: attraction is not clipped; forces take the velocity of half a step before"));

  // From both sides of how closely runs must be met.
  for (const auto& [off, known] : {std::pair(0.5 * repeated_to, true), std::pair(2 * repeated_to, false)}) {
    CaseResult moved = right;
    moved.runs[3].bodies[0].velocity.x += off * 0.5;
    g = grade(a, &moved);
    CHECK(causes(a, moved, g).empty() != known);
  }
}

TEST_CASE("conformance: every misunderstanding of a normal law is found by its limit") {
  const auto scaled = [](double spring, double dashpot) { return [=](Case& c) { scale_law(c.law, spring, dashpot); }; };
  const auto flip = [](Case& c) { c.law->end = ContactEnd::overlap; };
  for (const char* name : {"normal-linear-force", "normal-tsuji-force"}) {
    INFO(name);
    CHECK(names(causes_of(name, flip), "contacts end by overlap"));
    CHECK(names(causes_of(name, scaled(1, 2)), "damping twice as great"));
    CHECK(names(causes_of(name, scaled(1, 0.5)), "damping half as great"));
    CHECK(names(causes_of(name, scaled(2, 2)), "spring and damping twice as great"));
    CHECK(names(causes_of(name, scaled(0.5, 0.5)), "spring and damping half as great"));
    CHECK(names(causes_of(name, scaled(1, std::sqrt(2.0))), "damping greater by √2"));
    CHECK(names(causes_of(name, scaled(1, std::sqrt(0.5))), "damping smaller by √2"));
    CHECK(names(causes_of(name, scaled(2, 1)), "spring twice as stiff"));
    CHECK(names(causes_of(name, scaled(0.5, 1)), "spring half as stiff"));
    CHECK(names(causes_of(name, scaled(1, 0)), "damping left out"));
  }
  CHECK(names(causes_of("normal-tsuji-overlap", [](Case& c) { c.law->end = ContactEnd::force; }),
              "attraction is clipped"));
  Verdict verdict = Verdict::not_run;
  CHECK(causes_of("normal-linear-force", scaled(1.3, 0.8), &verdict).empty());
  CHECK(verdict == Verdict::elsewhere);
}

TEST_CASE("conformance: misunderstandings of friction are found by their limits") {
  CHECK(names(causes_of("oblique-mixed", [](Case& c) { c.tangential->friction = Friction(); }), "friction left out"));
  CHECK(names(causes_of("oblique-mixed", [](Case& c) { c.tangential->law = RigidTangential{}; }), "without a spring"));
  const auto spring = [](double k, double c_t) {
    return [=](Case& c) {
      const std::vector<double> v = values(c.tangential->law);
      c.tangential->law = LinearTangential(k * v[0], c_t * v[1]);
    };
  };
  CHECK(names(causes_of("oblique-mixed", spring(2, 1)), "tangential spring twice as stiff"));
  CHECK(names(causes_of("oblique-mixed", spring(0.5, 1)), "tangential spring half as stiff"));
  CHECK(names(causes_of("oblique-damped", spring(1, 0)), "tangential dashpot left out"));
  CHECK(names(causes_of("torsion-spin-down", [](Case& c) { c.tangential->torsion = {}; }), "torsion left out"));
  CHECK(names(causes_of("rolling-resistance", [](Case& c) { c.tangential->rolling = {}; }),
              "rolling resistance left out"));
}

TEST_CASE("conformance: nothing is said of what was not run, and of what is exact") {
  const Answered a = answered_case("chung-ooi-7-copper");
  CaseResult result{a.of.name};
  CHECK(causes(a, result, grade(a, &result)).empty());
  for (const int n : a.of.steps) result.runs.push_back({n, a.solution.bodies});
  const CaseGrade g = grade(a, &result);
  CHECK(g.verdict == Verdict::exact);
  CHECK(causes(a, result, g).empty());
}

TEST_CASE("conformance: steps of what was asked converge to it, wherever a few coarse ones seem to go") {
  // Four runs that were engines' own: their errors are irregular, and of one sign.
  const Answered a = answered_case("dem01-fall");
  CaseResult runs{a.of.name};
  for (const int steps : {50, 100, 200, 400})
    runs.runs.push_back(half_step_run(a.of, steps, Velocities::at_steps).value());
  CHECK(grade(a, &runs).verdict == Verdict::elsewhere);
  const CaseGrade g = explained(a, &runs);
  CHECK(g.verdict == Verdict::converges);
  REQUIRE(g.causes.size() == 1);
  CHECK(g.causes[0].as_asked);
  CHECK(g.by_repetition);
  for (const Graded& one : g.answers) CHECK(std::abs(one.limit.value) <= one.limit.uncertainty + one.floor);
  // Enough of them tell by themselves.
  CaseResult all{a.of.name};
  for (const int steps : a.of.steps) all.runs.push_back(half_step_run(a.of, steps, Velocities::at_steps).value());
  const CaseGrade whole = explained(a, &all);
  CHECK(whole.verdict == Verdict::converges);
  CHECK_FALSE(whole.by_repetition);
  // Digits that leave more open than that are met by many steps.
  CaseResult printed = runs;
  for (Run& run : printed.runs) {
    run.rounded.bodies = std::vector<Body>(run.bodies.size());
    run.rounded.bodies[0].position.x = 1e-6 * a.answers[0].scale;
  }
  const CaseGrade open = explained(a, &printed);
  REQUIRE(open.causes.size() == 1);
  CHECK(open.causes[0].repeated);
  CHECK_FALSE(open.causes[0].as_asked);
  CHECK(open.verdict == Verdict::elsewhere);
  // A hundred-thousandth of the scale beside, nothing is repeated.
  for (Run& run : runs.runs) run.bodies[0].position.x += 1e-5 * a.answers[0].scale, run.bodies[0].velocity.x += 1e-5;
  CHECK(explained(a, &runs).verdict == Verdict::elsewhere);
}

TEST_CASE("conformance: of forces that feel no velocity none is told") {
  for (const auto& [name, feels] : {std::pair("normal-elastic", false),
                                    {"normal-linear-force", true},
                                    {"chain-five-beads", false},
                                    {"wall-elastic", false}}) {
    CAPTURE(name);
    const Answered a = answered_case(name);
    CaseResult runs{a.of.name};
    for (const int steps : a.of.steps) runs.runs.push_back(half_step_run(a.of, steps, Velocities::at_steps).value());
    const CaseGrade g = explained(a, &runs);
    REQUIRE(g.causes.size() == 1);
    CHECK((g.causes[0].what.find("velocity of half a step") != std::string::npos) == feels);
    CHECK(g.causes[0].what.find("every run repeated here") != std::string::npos);
  }
}

TEST_CASE("conformance: what slides on a floor is explained in numbers or not at all") {
  const Answered a = answered_case("dem04-sliding-to-rolling");
  for (const double by : {1e-4, 0.1, -0.1, 1.0}) {
    CAPTURE(by);
    CaseResult runs{a.of.name};
    for (const int steps : a.of.steps) {
      Run run{steps, a.solution.bodies};
      run.bodies[0].velocity.y += by * a.answers[0].scale;
      runs.runs.push_back(run);
    }
    const CaseGrade g = explained(a, &runs);
    CHECK(g.verdict == Verdict::elsewhere);
    for (const Cause& c : g.causes) CHECK(std::isfinite(c.misfit));
    CHECK(g.causes.empty());
  }
  // Without friction it slides on as it came.
  CaseResult smooth{a.of.name};
  for (const int steps : a.of.steps) {
    Run run{steps, a.of.bodies};
    Body& body = run.bodies[0];
    body.position += a.of.duration * body.velocity;
    smooth.runs.push_back(run);
  }
  const CaseGrade g = explained(a, &smooth);
  CHECK(g.verdict == Verdict::elsewhere);
  REQUIRE(g.causes.size() == 1);
  CHECK(g.causes[0].what == "friction left out");
}
