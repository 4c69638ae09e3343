#include "conformance_cases.hpp"

#include "../../verify/conformance/causes.hpp"
#include "../../verify/conformance/ricochet_run.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <functional>

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

}  // namespace

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
