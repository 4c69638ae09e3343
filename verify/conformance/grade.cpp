#include "grade.hpp"

#include <ricochet/verify/order.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace ricochet::verify::conformance {

namespace {

/// Of body 1 and the other, or the wall, at the end of a run.
Approach approach(const Case& of, const Run& run) {
  const Body& a = run.bodies.front();
  if (!of.walls.empty()) {
    const Plane& wall = of.walls.front();
    return {a.radius - dot(a.position - wall.point, wall.normal), -dot(a.velocity, wall.normal)};
  }
  const Body& b = run.bodies.at(1);
  const Vec3 branch = b.position - a.position;
  return {a.radius + b.radius - norm(branch), dot(a.velocity - b.velocity, branch / norm(branch))};
}

/// Bodies that do not part never come apart.
bool part(Approach a) { return a.rate < 0 && std::abs(a.overlap) < 1e100 * -a.rate; }

/// By the straight flight after the contact: when the overlap was 0. The end of the run stands for never, far from any
/// answer.
double separation(const Case& of, const Run& run) {
  const double time = of.end_of_run(run.steps);
  const Approach a = approach(of, run);
  return part(a) ? time - a.overlap / a.rate : time;
}

double separation_to(const Case& of, const Run& run) {
  const Approach a = approach(of, run);
  if (!part(a)) return 0;
  double place = 0, speed = 0;
  for (const Body& b : run.rounded.bodies) place += norm(b.position), speed += norm(b.velocity);
  return (place + std::abs(a.overlap / a.rate) * speed) / -a.rate;
}

/// Slope of the errors, by all steps whose error stands above the floor.
void observe(Graded& g) {
  std::vector<double> h, error;
  const double from = g.verdict == Verdict::elsewhere ? g.limit.value : 0;
  for (std::size_t i = 0; i < g.error.size(); ++i) {
    h.push_back(1 / g.steps_in_scale[i]), error.push_back(g.error[i] - from);
    // The finest is used up by its own limit.
    if (g.verdict == Verdict::elsewhere && i + 2 == g.error.size()) break;
  }
  // Both usual orders are admitted; what is judged here is how even they are.
  const ObservedOrder o = observe_order(h, error, {.stated = 1.5, .allowed = 0.5, .rounding = 10 * g.floor});
  g.order = o.order, g.order_uncertainty = o.uncertainty;
}

Verdict verdict_of(const Graded& g) {
  const bool known = std::max(g.limit.uncertainty, g.digits) <= least_known;
  const bool exact = std::all_of(g.error.begin(), g.error.end(), [&](double d) { return std::abs(d) <= g.floor; });
  if (exact && g.digits <= least_known) return Verdict::exact;
  if (!g.limit.settles && !known) return Verdict::does_not_converge;
  if (std::abs(g.limit.value) > g.limit.uncertainty + g.floor) return Verdict::elsewhere;
  return known ? Verdict::converges : Verdict::too_coarse;
}

std::vector<double> steps_of(const Case& of, const CaseResult& result) {
  std::vector<double> h;
  h.reserve(result.runs.size());
  for (const Run& run : result.runs) h.push_back(of.step(run.steps) / of.time_scale);
  return h;
}

Graded graded(const Case& of, const Answer& answer, const CaseResult& result) {
  Graded g{.answer = answer};
  for (const Run& run : result.runs) {
    g.steps_in_scale.push_back(run.steps);
    g.error.push_back((measured(of, run, answer) - answer.value) / answer.scale);
    g.digits = std::max(g.digits, measured_to(of, run, answer) / answer.scale);
  }
  g.floor = answer.error / answer.scale + rounding + g.digits;
  g.limit = limit_of(steps_of(of, result), g.error, g.floor, g.digits + rounding);
  g.verdict = verdict_of(g);
  if (g.verdict != Verdict::exact) observe(g);
  return g;
}

/// Whether every run has the number.
bool reported(const CaseResult& result, Quantity quantity) {
  return std::all_of(result.runs.begin(), result.runs.end(), [&](const Run& run) {
    if (quantity == Quantity::contact_time) return run.contact_time.has_value();
    return quantity != Quantity::max_overlap || run.max_overlap.has_value();
  });
}

/// Why these runs, by their steps, cannot be graded; empty where they can.
std::string too_little(const std::vector<Run>& runs) {
  if (runs.size() < fewest_runs)
    return fmt::format("{} runs: {} are needed to tell where they go", runs.size(), fewest_runs);
  for (std::size_t i = 1; i < runs.size(); ++i)
    if (runs[i].steps < least_refinement * runs[i - 1].steps)
      return fmt::format("runs of {} and {} steps: must be {} times as many or more to tell where they go",
                         runs[i - 1].steps, runs[i].steps, least_refinement);
  return {};
}

EnergyBalance balance(const Answered& answered, const CaseResult& result, const std::vector<Graded>& answers) {
  const Case& of = answered.of;
  const double start = energy(of.bodies, {});
  std::vector<double> ratios;
  ratios.reserve(result.runs.size());
  for (const Run& run : result.runs) ratios.push_back(energy(run.bodies, {}) / start);
  double known = rounding, digits = 0;
  for (const Graded& g : answers)
    if (g.answer.required) known = std::max(known, 2 * g.floor), digits = std::max(digits, 2 * g.digits);
  const Limit limit = limit_of(steps_of(of, result), ratios, known, digits + rounding);
  return {energy(answered.solution.bodies, {}) / start, limit.value, limit.uncertainty + known, ratios.front(),
          ratios.back()};
}

}  // namespace

std::string_view text(Verdict verdict) noexcept {
  constexpr std::array<std::string_view, 7> words{"exact",        "converges to it",     "steps too coarse",
                                                  "another rule", "converges elsewhere", "does not converge",
                                                  "not run"};
  return words[static_cast<std::size_t>(verdict)];
}

double measured(const Case& of, const Run& run, const Asked& asked) {
  switch (asked.quantity) {
    case Quantity::separation: return separation(of, run);
    case Quantity::contact_time: return run.contact_time.value();
    case Quantity::max_overlap: return run.max_overlap.value();
    default: return component(run.bodies.at(asked.body - 1), asked.quantity);
  }
}

double measured_to(const Case& of, const Run& run, const Asked& asked) {
  if (run.rounded.bodies.empty()) return 0;
  switch (asked.quantity) {
    case Quantity::separation: return separation_to(of, run);
    case Quantity::contact_time: return run.rounded.contact_time;
    case Quantity::max_overlap: return run.rounded.max_overlap;
    default: return component(run.rounded.bodies.at(asked.body - 1), asked.quantity);
  }
}

void note_that_it_converges(CaseGrade& grade) {
  for (Graded& g : grade.answers) {
    if (g.verdict <= Verdict::converges) continue;
    g.limit.uncertainty = std::max(g.limit.uncertainty, std::abs(g.limit.value));
    g.order = g.order_uncertainty = std::numeric_limits<double>::quiet_NaN();  // was that of another limit
    g.verdict = Verdict::converges;
  }
  grade.by_repetition = grade.verdict > Verdict::converges;
  grade.verdict = std::min(grade.verdict, Verdict::converges);
}

const Graded* CaseGrade::worst() const {
  const Graded* worst = nullptr;
  const auto weight = [](const Graded& g) {
    return std::pair(g.verdict, std::abs(g.verdict == Verdict::elsewhere ? g.limit.value : g.error.back()));
  };
  for (const Graded& g : answers)
    if (g.answer.required && (!worst || weight(g) > weight(*worst))) worst = &g;
  return worst;
}

double CaseGrade::error_at(std::size_t run) const {
  double most = 0;
  for (const Graded& g : answers)
    if (g.answer.required) most = std::max(most, std::abs(g.error.at(run)));
  return most;
}

std::vector<Answered> answered(const std::vector<Case>& cases) {
  std::vector<Answered> all;
  all.reserve(cases.size());
  for (const Case& c : cases) all.push_back({c, c.solver(c, ContactArm::radius), answers(c)});
  return all;
}

CaseGrade grade(const Answered& answered, const CaseResult* result) {
  CaseGrade grade{.of = &answered.of};
  grade.note = result ? result->note : "not in the file";
  if (!result || result->runs.empty()) return grade;
  if (const std::string why = too_little(result->runs); !why.empty()) {
    grade.note += (grade.note.empty() ? "" : "; ") + why;
    return grade;
  }
  grade.verdict = Verdict::exact;
  for (const Answer& answer : answered.answers) {
    if (!reported(*result, answer.quantity)) continue;
    grade.answers.push_back(graded(answered.of, answer, *result));
    if (answer.required) grade.verdict = std::max(grade.verdict, grade.answers.back().verdict);
  }
  if (norm(answered.of.gravity) == 0) grade.energy = balance(answered, *result, grade.answers);
  return grade;
}

std::size_t EngineGrade::count(Verdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(cases.begin(), cases.end(), [&](const CaseGrade& c) { return c.verdict == verdict; }));
}

}  // namespace ricochet::verify::conformance
