#include "causes.hpp"

#include "half_step.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>

namespace ricochet::verify::conformance {

namespace {

/// Another case that an engine may have understood; nothing where it is the same.
struct Misunderstanding {
  std::string what;
  std::function<std::optional<Case>(const Case&)> of;
};

using Values = std::function<std::vector<double>(std::vector<double>)>;

/// The normal laws with other parameters.
std::optional<Case> with_laws(Case c, const Values& other) {
  bool changed = false;
  for (std::optional<Meeting>* meeting : {&c.law, &c.wall_law}) {
    if (!*meeting) continue;
    const std::vector<double> old = values((*meeting)->law), now = other(old);
    changed = changed || now != old;
    (*meeting)->law = LawKind::of((*meeting)->law).with(now);
  }
  return changed ? std::optional(c) : std::nullopt;
}

bool has_dashpot(const AnyLaw& law) {
  return std::visit(
      [](const auto& l) {
        return requires {
          l.c();
          l.mean_force(0.0, 0.0, 0.0);
        };
      },
      law);
}

/// Spring and dashpot by their own factors, of the laws that are made of both.
std::function<std::optional<Case>(const Case&)> scaled(double spring, double dashpot) {
  return [=](const Case& c) -> std::optional<Case> {
    for (const auto& meeting : {c.law, c.wall_law})
      if (meeting && !has_dashpot(meeting->law)) return std::nullopt;
    return with_laws(c, [=](std::vector<double> v) { return std::vector<double>{spring * v[0], dashpot * v[1]}; });
  };
}

std::optional<Case> other_end(Case c) {
  for (std::optional<Meeting>* meeting : {&c.law, &c.wall_law}) {
    if (!*meeting) continue;
    const ContactEnd other = (*meeting)->end == ContactEnd::force ? ContactEnd::overlap : ContactEnd::force;
    if (!LawKind::of((*meeting)->law).ends().offer(other)) return std::nullopt;
    (*meeting)->end = other;
  }
  return c;
}

std::function<std::optional<Case>(const Case&)> with_contact(const std::function<bool(TangentialContact&)>& change) {
  return [change](const Case& of) -> std::optional<Case> {
    Case c = of;
    if (!c.tangential || !change(*c.tangential)) return std::nullopt;
    return c;
  };
}

/// Another spring and dashpot of the same tangential law.
std::function<std::optional<Case>(const Case&)> with_spring(double spring, double dashpot) {
  return with_contact([=](TangentialContact& t) {
    std::vector<double> v = values(t.law);
    if (v.size() != 2 || (spring == 1 && v[1] == 0)) return false;
    v[0] *= spring, v[1] *= dashpot;
    t.law = tangential_law(name(t.law), v).value();
    return true;
  });
}

std::vector<Misunderstanding> misunderstandings(ContactEnd asked) {
  const bool force = asked == ContactEnd::force;
  const auto no_torsion = [](TangentialContact& t) {
    const bool had = t.torsion.limit != Torsion::Limit::none;
    t.torsion = {};
    return had;
  };
  const auto no_rolling = [](TangentialContact& t) {
    const bool had = t.rolling.mu > 0;
    t.rolling = {};
    return had;
  };
  return {
      {force ? "contacts end by overlap: attraction is not clipped" : "contacts end by force: attraction is clipped",
       other_end},
      {"damping twice as great, as by coefficients per mass with twice the effective mass", scaled(1, 2)},
      {"damping half as great, as by twice the effective mass", scaled(1, 0.5)},
      {"spring and damping twice as great, as by coefficients per mass with twice the effective mass", scaled(2, 2)},
      {"spring and damping half as great, as by coefficients per mass with half the mass", scaled(0.5, 0.5)},
      {"damping greater by √2", scaled(1, std::sqrt(2.0))},
      {"damping smaller by √2", scaled(1, std::sqrt(0.5))},
      {"spring twice as stiff", scaled(2, 1)},
      {"spring half as stiff", scaled(0.5, 1)},
      {"damping left out", scaled(1, 0)},
      // Before friction as a whole, which in a case of one mechanism alone is the same.
      {"torsion left out", with_contact(no_torsion)},
      {"rolling resistance left out", with_contact(no_rolling)},
      {"friction left out", with_contact([](TangentialContact& t) { return t = {}, true; })},
      {"friction without a spring", with_contact([](TangentialContact& t) { return t.law = RigidTangential{}, true; })},
      {"tangential spring twice as stiff", with_spring(2, 1)},
      {"tangential spring half as stiff", with_spring(0.5, 1)},
      {"tangential dashpot left out", with_spring(1, 0)}};
}

struct RuleOfEngines {
  const char* what = "";
  Rule rule = {};
};
const RuleOfEngines rules[] = {
    {"a contact that slides keeps a dashpot of the whole slip, its spring is set so that both make the limit", {}},
    {"the sliding limit holds for the tangential spring alone, and a contact that slides has no dashpot",
     {true, Rule::Keeps::asked}},
    {"the tangential spring keeps its strain while the contact grows and shrinks", {true, Rule::Keeps::strain}},
    {"the tangential spring keeps its force while the contact grows and shrinks", {true, Rule::Keeps::force}},
    {"the tangential spring keeps its strain while the contact grows and shrinks, and its limit is the dashpot's, too",
     {false, Rule::Keeps::strain}},
    {"the tangential spring keeps its force while the contact grows and shrinks, and its limit is the dashpot's, too",
     {false, Rule::Keeps::force}}};

/// Greatest difference of the engine's runs from those stepped here; nothing where they can't be.
std::optional<double> misfit_of_steps(const Case& as, Velocities velocities, const CaseResult& result,
                                      const CaseGrade& grade) {
  double worst = 0;
  for (std::size_t i = 0; i < result.runs.size() && worst <= repeated_to; ++i) {
    const std::optional<Run> run = half_step_run(as, result.runs[i].steps, velocities);
    if (!run) return std::nullopt;
    for (const Graded& g : grade.answers) {
      if (!g.answer.required) continue;
      const double here = (measured(as, *run, g.answer) - g.answer.value) / g.answer.scale;
      worst = std::max(worst, std::abs(here - g.error[i]));
    }
  }
  return worst;
}

/// The stepping that repeats every run, of the two.
std::optional<Cause> repeated_by(const Case& as, const std::string& what, const CaseResult& result,
                                 const CaseGrade& grade) {
  for (const Velocities velocities : {Velocities::at_steps, Velocities::behind}) {
    const auto misfit = misfit_of_steps(as, velocities, result, grade);
    if (misfit && *misfit <= repeated_to)
      return Cause{what + "forces take the velocity of half a step before: every run repeated here to rounding", true,
                   *misfit};
  }
  return std::nullopt;
}

/// That of another case's answers which is to the same question.
const Answer& answer_like(const Graded& g, const std::vector<Answer>& other) {
  return *std::find_if(other.begin(), other.end(),
                       [&](const Answer& a) { return a.quantity == g.answer.quantity && a.body == g.answer.body; });
}

/// Greatest difference of the engine's limits from another case's answers; nothing where one is farther than it may be.
std::optional<double> misfit_of_limits(const std::vector<Answer>& other, const CaseGrade& grade) {
  double worst = 0;
  for (const Graded& g : grade.answers) {
    if (!g.answer.required) continue;
    const Answer& same = answer_like(g, other);
    const double there = (same.value - g.answer.value) / g.answer.scale;
    const double off = std::abs(there - g.limit.value);
    if (!(off <= g.limit.uncertainty + g.floor + same.error / g.answer.scale)) return std::nullopt;
    worst = std::max(worst, off);
  }
  return worst;
}

/// The answers of a case that may have none: bodies that no longer part.
std::vector<Answer> answers_or_none(const Case& c) {
  try {
    return answers(c);
  } catch (const std::logic_error&) {
    return {};
  }
}

/// Whether these are the case's own answers: a misunderstanding that changes nothing in it explains nothing.
bool is_same(const std::vector<Answer>& other, const CaseGrade& grade) {
  if (other.empty()) return false;
  return std::all_of(grade.answers.begin(), grade.answers.end(), [&](const Graded& g) {
    const double off = answer_like(g, other).value - g.answer.value;
    return !g.answer.required || std::abs(off) <= rounding * g.answer.scale;
  });
}

ContactEnd end_of(const Case& c) { return (c.law ? c.law : c.wall_law).value().end; }

/// The rule, at the place in the overlap where it fits best.
std::optional<Cause> explained_by(const RuleOfEngines& of, const Case& as, const CaseGrade& grade) {
  std::optional<Cause> best;
  for (const double place : {0.0, 0.5, 1.0}) {
    const auto solution = by_rule(as, of.rule, place);
    if (!solution) continue;
    std::vector<Answer> there;
    for (const Asked& asked : as.asked)
      there.push_back({asked, number(*solution, asked), solution->error * asked.scale});
    const auto off = misfit_of_limits(there, grade);
    if (off && (!best || *off < best->misfit)) best = Cause{of.what, false, *off};
  }
  return best;
}

}  // namespace

std::vector<Cause> causes(const Answered& answered, const CaseResult& result, const CaseGrade& grade) {
  std::vector<Cause> repeated, limits;
  if (grade.verdict == Verdict::exact || grade.verdict == Verdict::not_run) return {};
  if (const auto cause = repeated_by(answered.of, "", result, grade)) repeated.push_back(*cause);
  if (grade.verdict == Verdict::converges) return repeated;
  for (const Misunderstanding& m : misunderstandings(end_of(answered.of))) {
    const std::optional<Case> other = m.of(answered.of);
    if (!other) continue;
    const std::vector<Answer> there = answers_or_none(*other);
    if (is_same(there, grade)) continue;
    if (const auto cause = repeated_by(*other, m.what + "; ", result, grade)) repeated.push_back(*cause);
    if (grade.verdict != Verdict::elsewhere) continue;
    const auto off = there.empty() ? std::nullopt : misfit_of_limits(there, grade);
    if (off) limits.push_back({m.what, false, *off});
  }
  for (const RuleOfEngines& r : rules)
    if (const auto cause = grade.verdict == Verdict::elsewhere ? explained_by(r, answered.of, grade) : std::nullopt)
      limits.push_back(*cause);
  std::stable_sort(limits.begin(), limits.end(), [](const Cause& a, const Cause& b) { return a.misfit < b.misfit; });
  if (!repeated.empty()) return repeated;
  return limits;
}

}  // namespace ricochet::verify::conformance
