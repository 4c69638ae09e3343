#include "conformance_cases.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace ricochet;
using namespace ricochet::verify::conformance;

namespace {

const std::vector<double> halved{0.04, 0.02, 0.01, 0.005, 0.0025, 0.00125};
const std::vector<int> usual{25, 50, 100, 200, 400, 800};

template <class F>
Limit limit_of_function(const F& f, double noise = 0) {
  std::vector<double> values;
  for (const double h : halved) values.push_back(f(h));
  return limit_of(halved, values, noise);
}

template <class F>
CaseGrade graded(const std::string& name, const F& error, const std::vector<int>& steps = usual) {
  const Answered a = answered_case(name);
  const CaseResult result = off_by(a, steps, error);
  CaseGrade g = grade(a, &result);
  g.of = nullptr;  // of this scope
  return g;
}

}  // namespace

TEST_CASE("conformance: step sizes that are too few or too close are not graded") {
  const Answered a = answered_case("normal-linear-force");
  const auto graded_with = [&](const std::vector<int>& steps) {
    const CaseResult result = off_by(a, steps, [](int n) { return 0.1 / n; });
    return grade(a, &result);
  };
  CHECK(graded_with({100, 140, 196, 275}).verdict == Verdict::converges);
  CHECK(graded_with({100, 140, 196, 274}).verdict == Verdict::not_run);
  CHECK(graded_with({100, 139, 200, 400}).note ==
        "runs of 100 and 139 steps: must be 1.4 times as many or more to tell where they go");
  CHECK(graded_with({100, 200, 400}).note == "3 runs: 4 are needed to tell where they go");
}

TEST_CASE("conformance: limits of smooth values are extrapolated, and known to more than they are off by") {
  for (const double order : {1.0, 1.5, 2.0, 3.0}) {
    INFO(order);
    // What is left of a pure power but for the first is less than what the last two extrapolations differ by, twice.
    const Limit l = limit_of_function([&](double h) { return 3 + std::pow(h, order); });
    CHECK(l.settles);
    CHECK(std::abs(l.value - 3) <= l.uncertainty + 1e-14);
  }
  const Limit l = limit_of_function([](double h) { return 3 + h + h * h; });
  // 2 d(h) − d(2h) leaves −2 h² at the finest h; the differences before it are 6, 24, 96 h².
  const double h = halved.back();
  CHECK(l.value - 3 == Approx(-2 * h * h).epsilon(1e-6));
  CHECK(l.uncertainty == Approx(2 * 0.35 * 0.35 * 96 * h * h).epsilon(1e-6));
}

TEST_CASE("conformance: a last difference that is small by chance does not make a limit certain") {
  // Extrapolations 3 + e of which the last two are off by the same.
  const std::vector<double> off{1e-2, 3e-3, 9e-4, 3e-4, 3e-4};
  std::vector<double> values{1};
  for (std::size_t i = 1; i < halved.size(); ++i) values.push_back(0.5 * (values.back() + 3 + off[i - 1]));
  const Limit l = limit_of(halved, values, 0);
  REQUIRE(l.smooth);
  CHECK(l.value - 3 == Approx(3e-4));
  // 0.35² of the difference of the second and the third, 2.1e-3; 0.35 of the next is less.
  CHECK(l.uncertainty == Approx(2 * 0.35 * 0.35 * 2.1e-3).epsilon(1e-9));
  CHECK(l.uncertainty > 3e-4);
}

TEST_CASE("conformance: steps of another ratio have another fall and the same bound") {
  const auto of_ratio = [](double ratio, double order) {
    std::vector<double> h{0.04}, values;
    while (h.size() < 6) h.push_back(h.back() / ratio);
    for (const double s : h) values.push_back(3 + s + std::pow(s, order));
    return limit_of(h, values, 0);
  };
  for (const double ratio : {1.4, 2.0, 4.0, 10.0}) {
    INFO(ratio);
    // 0.35 is what an order of 1.515 leaves of an error as the step is halved.
    CHECK(of_ratio(ratio, 1.54).smooth);
    CHECK_FALSE(of_ratio(ratio, 1.49).smooth);
    const Limit l = of_ratio(ratio, 2);
    CHECK(std::abs(l.value - 3) < l.uncertainty / 3);
  }
}

TEST_CASE("conformance: forward Euler is not said to go elsewhere, where it is off by chance") {
  // Its last two extrapolations are off by 9e-5 and 1.1e-4: they differ by far less than either is off by.
  const Answered a = answered_case("re-contact-linear");
  const std::vector<double> law = values(a.of.wall_law->law);
  CaseResult result{a.of.name};
  for (const int n : usual) {
    const double h = a.of.step(n), m = a.of.bodies[0].mass, r = a.of.bodies[0].radius;
    double x = a.of.start(n)[0].position.x, v = a.of.bodies[0].velocity.x;
    for (long i = 0; i < a.of.steps_of_run(n); ++i) {
      double force = 0;
      for (const Plane& wall : a.of.walls) {
        const double side = wall.normal.x, overlap = r - side * (x - wall.point.x);
        if (overlap > 0) force += side * std::max(0.0, law[0] * overlap - law[1] * side * v);
      }
      x += h * v, v += h * force / m;
    }
    Run run{n, a.of.bodies};
    run.bodies[0].position.x = x, run.bodies[0].velocity.x = v;
    result.runs.push_back(run);
  }
  const CaseGrade g = grade(a, &result);
  const Limit& limit = g.answers[0].limit;
  const std::vector<double>& d = g.answers[0].error;
  REQUIRE(limit.smooth);
  CHECK(std::abs(limit.value) == Approx(1.1e-4).epsilon(0.05));
  const double last = std::abs((2 * d[5] - d[4]) - (2 * d[4] - d[3]));
  CHECK(std::abs(limit.value) > 2 * last);
  // At 50 steps it still flies away: how far it is off at 800 is known to no better than finer steps would tell.
  CHECK(g.verdict == Verdict::too_coarse);
}

TEST_CASE("conformance: rounding is raised by the extrapolation") {
  std::vector<double> values;
  for (const double h : halved) values.push_back(3 + h);
  for (const double digits : {1e-4, 1e-6}) {
    // (h₁ + h₂)/(h₁ − h₂) = 3.
    CHECK(limit_of(halved, values, 0, digits).uncertainty == Approx(3 * digits).epsilon(1e-6));
    // A change that rounding can make need not fall: 6 digits of two extrapolations.
    auto moved = [&](double by) {
      std::vector<double> all = values;
      all[5] += by / 2;
      return limit_of(halved, all, 0, digits);
    };
    CHECK(moved(5.9 * digits).smooth);
    CHECK_FALSE(moved(6.1 * digits).smooth);
  }
}

TEST_CASE("conformance: irregular errors of first order are not extrapolated") {
  const std::array<double, 6> irregular{0.9, -0.3, 0.7, -0.8, 0.2, -0.6};
  std::vector<double> values;
  double bound = 0;
  for (std::size_t i = 0; i < halved.size(); ++i) values.push_back(irregular[i] * halved[i]);
  const Limit l = limit_of(halved, values, 0);
  CHECK(l.settles);
  CHECK_FALSE(l.smooth);
  CHECK(l.value == values.back());
  for (std::size_t i = 0; i + 1 < halved.size(); ++i)
    bound = std::max(bound, std::abs(values[i] - values.back()) / halved[i]);
  CHECK(l.uncertainty == Approx(2 * bound * halved.back()));
  CHECK(std::abs(l.value) < l.uncertainty);
}

TEST_CASE("conformance: errors that fall like an order below 1 are not said to go elsewhere") {
  const std::vector<double> h{1. / 25, 1. / 50, 1. / 100, 1. / 200, 1. / 400, 1. / 800};
  for (const double order : {0.4, 0.5, 0.6, 0.7, 0.8, 0.9}) {
    CAPTURE(order);
    std::vector<double> values;
    for (const double one : h) values.push_back(0.1 * std::pow(one, order));
    const Limit limit = limit_of(h, values, 1e-12);
    CHECK(limit.settles);
    CHECK(std::abs(limit.value) <= limit.uncertainty);
    CHECK(limit.uncertainty <= 2.1 * values.back());  // and are not known to less than that
  }
}

TEST_CASE("conformance: how fast extrapolations must fall to be believed") {
  // a h + b h^q: their differences fall by 2^−q; 0.35 is q = 1.515.
  CHECK(limit_of_function([](double h) { return h + std::pow(h, 1.53); }).smooth);
  CHECK_FALSE(limit_of_function([](double h) { return h + std::pow(h, 1.50); }).smooth);
  // Below the noise nothing has to fall.
  const auto rough = [](double h) { return h + (h < 0.003 ? 1e-9 * std::sin(1e7 * h) : 0); };
  CHECK_FALSE(limit_of_function(rough).smooth);
  CHECK(limit_of_function(rough, 1e-8).smooth);
}

TEST_CASE("conformance: values that do not settle are known to how they wander") {
  // Over two halvings the greatest change per h grows by 4^(1−p): 2.5 at p = 0.339.
  const auto power = [](double p) { return limit_of_function([=](double h) { return std::pow(h, p); }); };
  CHECK(power(0.36).settles);
  CHECK_FALSE(power(0.30).settles);
  const Limit l = limit_of(halved, {0, 1, 0, 1, 0, 1}, 0);
  CHECK_FALSE(l.settles);
  CHECK(l.value == 1);
  CHECK(l.uncertainty == 2);
  // What is below the noise does not wander.
  CHECK(limit_of(halved, {0, 1e-9, 0, 1e-9, 0, 1e-9}, 1e-8).settles);
}

TEST_CASE("conformance: every verdict, from both sides of what decides it") {
  const std::string name = "normal-linear-force";
  const double floor = answered_case(name).answers[0].error / 0.5 + rounding;
  CHECK(graded(name, [&](int) { return 0.9 * floor; }).verdict == Verdict::exact);
  CHECK(graded(name, [&](int n) { return (n == 25 ? 1.2 : 0.9) * floor; }).verdict == Verdict::converges);
  // Three times the rounding is what an extrapolation makes of it.
  CHECK(graded(name, [&](int) { return 3 * floor; }).verdict == Verdict::converges);
  CHECK(graded(name, [&](int) { return 5 * floor; }).verdict == Verdict::elsewhere);

  // a h + b h² is known to 2 · 0.35² · 96 b h².
  const double h = 1.0 / 800, known = 2 * 0.35 * 0.35 * 96 * h * h;
  const auto to = [&](double limit) { return [=](int n) { return limit + 1.0 / n + 1.0 / n / n; }; };
  CHECK(graded(name, to(0)).verdict == Verdict::converges);
  CHECK(graded(name, to(0.9 * known)).verdict == Verdict::converges);
  CHECK(graded(name, to(-0.7 * known)).verdict == Verdict::converges);
  CHECK(graded(name, to(1.3 * known)).verdict == Verdict::elsewhere);
  CHECK(graded(name, to(-1.0 * known)).verdict == Verdict::elsewhere);
  CHECK(graded(name, to(0.3)).verdict == Verdict::elsewhere);

  // Values that jump by d are known to 2 d.
  const auto jumps = [](double d) { return [=](int n) { return n == 25 || n == 100 || n == 400 ? d : 0; }; };
  CHECK(graded(name, jumps(0.6 * least_known)).verdict == Verdict::does_not_converge);
  CHECK(graded(name, jumps(0.4 * least_known)).verdict == Verdict::converges);
  CHECK(graded(name, [&](int n) { return 0.5 + jumps(0.4 * least_known)(n); }).verdict == Verdict::elsewhere);

  // Known to 1 % at h = 1/800: b = 272. What is off by more than that is elsewhere all the same.
  const auto coarse = [&](double limit, double b) { return [=](int n) { return limit + b / n / n; }; };
  const double b_known = least_known / known;
  CHECK(graded(name, coarse(0, 0.95 * b_known)).verdict == Verdict::converges);
  CHECK(graded(name, coarse(0, 1.05 * b_known)).verdict == Verdict::too_coarse);
  CHECK(graded(name, coarse(0.1, 1.05 * b_known)).verdict == Verdict::elsewhere);

  CHECK(graded(name, to(0), {25, 50, 100}).verdict == Verdict::not_run);
  CHECK(graded(name, to(0), {25, 50, 100, 200}).verdict == Verdict::converges);
  CHECK(grade(answered_case(name), nullptr).verdict == Verdict::not_run);
  CHECK(grade(answered_case(name), nullptr).note == "not in the file");
  const CaseResult noted{name, {}, "no such law"};
  CHECK(grade(answered_case(name), &noted).note == "no such law");
}

TEST_CASE("conformance: the order of the errors is observed") {
  for (const double order : {1.0, 2.0}) {
    const CaseGrade g = graded("wall-elastic", [&](int n) { return std::pow(n, -order); });
    REQUIRE(g.worst());
    CHECK(g.worst()->order == Approx(order).margin(0.02));
  }
  // From the limit where that is elsewhere.
  const CaseGrade g = graded("wall-elastic", [](int n) { return 0.3 + 2.0 / n; });
  CHECK(g.verdict == Verdict::elsewhere);
  CHECK(g.worst()->order == Approx(1).margin(0.02));
  CHECK(g.worst()->limit.value == Approx(0.3).epsilon(1e-9));
}

TEST_CASE("conformance: the worst required answer decides, what engines need not report does not") {
  const Answered a = answered_case("normal-linear-force");
  CaseResult result = off_by(a, usual, [](int) { return 0.0; });
  CHECK(grade(a, &result).verdict == Verdict::exact);
  CHECK(grade(a, &result).answers.size() == 3);
  for (Run& run : result.runs) run.max_overlap = 1, run.contact_time = a.solution.contact_time;
  CHECK(grade(a, &result).verdict == Verdict::exact);
  CHECK(grade(a, &result).answers.size() == 5);
  result.runs[2].contact_time.reset();
  CHECK(grade(a, &result).answers.size() == 4);
  // The second body alone is wrong; that the bodies are then elsewhere moves their separation, too.
  for (Run& run : result.runs) run.bodies[1].velocity.x += 0.05;
  const CaseGrade g = grade(a, &result);
  CHECK(g.verdict == Verdict::elsewhere);
  CHECK(g.answers[0].verdict == Verdict::exact);
  CHECK(g.error_at(0) == Approx(0.1));
}

TEST_CASE("conformance: energy that is made or lost in the limit") {
  // 34 % more energy is √1.34 of the speed: walls that gained it.
  const double too_fast = std::sqrt(1.34) - 1;
  const CaseGrade more = graded("wall-elastic", [&](int) { return too_fast; });
  REQUIRE(more.energy);
  CHECK(more.energy->limit == Approx(1.34).epsilon(1e-12));
  CHECK(more.energy->exact == Approx(1).epsilon(1e-10));
  CHECK(more.energy->made());
  CHECK_FALSE(more.energy->lost());
  const CaseGrade less = graded("wall-elastic", [&](int) { return -0.1; });
  CHECK(less.energy->lost());
  CHECK_FALSE(less.energy->made());
  const CaseGrade right = graded("wall-elastic", [&](int n) { return 1.0 / n; });
  CHECK_FALSE(right.energy->made());
  CHECK_FALSE(right.energy->lost());
  const Answered falling = answered_case("dem01-fall");
  CaseResult result{"dem01-fall"};
  for (const int n : usual) result.runs.push_back({n, falling.solution.bodies});
  CHECK_FALSE(grade(falling, &result).energy);
}

TEST_CASE("conformance: separation is read from the straight flight after the contact") {
  for (const char* name : {"normal-linear-force", "wall-linear-overlap", "unequal-radii"}) {
    const Answered a = answered_case(name);
    const CaseResult result = off_by(a, {100}, [](int) { return 0.0; });
    const Asked asked{Quantity::separation, 1, 1};
    CHECK(measured(a.of, result.runs[0], asked) == Approx(a.solution.separation).epsilon(1e-9));
  }
  // Bodies that never part.
  const Answered a = answered_case("wall-elastic");
  Run run{100, a.of.bodies};
  run.bodies[0].velocity.x = -1;
  CHECK(measured(a.of, run, {Quantity::separation, 1, 1}) == a.of.end_of_run(100));
}
