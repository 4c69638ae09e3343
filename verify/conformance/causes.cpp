#include "causes.hpp"

#include "half_step.hpp"

#include <fmt/format.h>

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
  bool is_end = false;  ///< of contacts, and nothing else
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

const char* words_of_other_end(ContactEnd asked_for) {
  return asked_for == ContactEnd::force ? "contacts end by overlap: attraction is not clipped"
                                        : "contacts end by force: attraction is clipped";
}

std::vector<Misunderstanding> misunderstandings(ContactEnd asked_for) {
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
      {words_of_other_end(asked_for), other_end, true},
      {"damping twice as great, as by coefficients per mass with twice the effective mass", scaled(1, 2)},
      {"damping half as great, as by twice the effective mass", scaled(1, 0.5)},
      {"spring and damping twice as great, as by coefficients per mass with twice the effective mass", scaled(2, 2)},
      {"spring and damping half as great, as by coefficients per mass with half the mass", scaled(0.5, 0.5)},
      {"damping greater by √2", scaled(1, std::sqrt(2.0))},
      {"damping smaller by √2", scaled(1, std::sqrt(0.5))},
      {"spring twice as stiff", scaled(2, 1)},
      {"spring half as stiff", scaled(0.5, 1)},
      {"damping left out", scaled(1, 0)},
      {"torsion left out", with_contact(no_torsion)},
      {"rolling resistance left out", with_contact(no_rolling)},
      {"friction left out", with_contact([](TangentialContact& t) { return t = {}, true; })},
      {"friction without a spring", with_contact([](TangentialContact& t) { return t.law = RigidTangential{}, true; })},
      {"tangential spring twice as stiff", with_spring(2, 1)},
      {"tangential spring half as stiff", with_spring(0.5, 1)},
      {"tangential dashpot left out", with_spring(1, 0)}};
}

/// What an engine may do with a tangential spring and dashpot in place of what is asked, by the words of
/// docs/engines.md, "Tangential conventions".
struct RuleOfEngines {
  const char* what = "";
  Rule rule = {};
};
constexpr Rule::Keeps asked = Rule::Keeps::asked, strain = Rule::Keeps::strain, kept = Rule::Keeps::force;
const RuleOfEngines dashpot_rules[] = {
    {"the dashpot feels the whole slip: a contact that slides keeps it, and its spring is set so that both make the "
     "limit (LAMMPS, MercuryDPM)",
     {false, asked}},
    {"the spring's force alone is limited, and a contact that slides has no dashpot (LIGGGHTS, Yade, MFiX)",
     {true, asked}}};
const RuleOfEngines mindlin_rules[] = {
    {"Mindlin's spring keeps its strain while the contact grows, too (LIGGGHTS, MFiX, LAMMPS mindlin)",
     {false, strain}},
    {"Mindlin's spring keeps its force while the contact shrinks, too (Yade, LAMMPS mindlin/force)", {false, kept}}};

/// The rules that are another thing for this law, and the case's own where it can be stepped by `by_rule`: without a
/// dashpot.
std::vector<RuleOfEngines> rules_for(const TangentialLaw& law) {
  const bool damped = spring(law, 1).damping > 0, grows = std::holds_alternative<MindlinTangential>(law);
  std::vector<RuleOfEngines> all;
  if (!damped) all.push_back({});
  if (damped) all.insert(all.end(), std::begin(dashpot_rules), std::end(dashpot_rules));
  if (grows) all.insert(all.end(), std::begin(mindlin_rules), std::end(mindlin_rules));
  if (damped && grows)
    for (const RuleOfEngines& m : mindlin_rules) all.push_back({m.what, {true, m.rule.keeps}});
  return all;
}

/// What limits friction, beside the asked.
struct Limited {
  const char* what = "";
  Rubs rubs = Rubs::repulsion;
};
const Limited limits_of_friction[] = {
    {},
    {"friction is limited by μ|F|, under attraction too", Rubs::size},
    {"friction is limited by μ|F| of the normal force before attraction is clipped", Rubs::unclipped},
    {"friction is limited by μ times the force of the normal spring alone", Rubs::spring}};

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
      worst = std::max(worst, std::abs(here - g.error[i]) - g.digits);
    }
  }
  return worst;
}

/// Without dashpots and memories no force tells what velocity it takes.
bool feels_velocities(const Case& c) {
  const auto feels = [](const std::optional<Meeting>& m) { return m && has_dashpot(m->law) && values(m->law)[1] != 0; };
  return c.tangential || feels(c.law) || feels(c.wall_law);
}

/// The stepping that repeats every run, of the two.
std::optional<Cause> repeated_by(const Case& as, const std::string& what, const CaseResult& result,
                                 const CaseGrade& grade) {
  for (const Velocities velocities : {Velocities::at_steps, Velocities::behind}) {
    const auto misfit = misfit_of_steps(as, velocities, result, grade);
    if (!misfit || *misfit > repeated_to) continue;
    return Cause{.what = fmt::format("{}{}: every run repeated here to rounding", what,
                                     feels_velocities(as) ? half_a_step_before : "velocity Verlet"),
                 .repeated = true,
                 .misfit = *misfit};
  }
  return std::nullopt;
}

/// What another case, or another way to make its contact, gives: required answers as shares of scale from the asked
/// ones, the forces acting at a radius from the centres, and what it changes if they act, or slip is taken, a whole
/// overlap nearer.
struct Prediction {
  std::vector<double> at_radius = {};
  std::vector<std::vector<double>> moved = {};  ///< one, or force and slip apart
  double error = 0;
};

std::vector<double> required(const CaseGrade& grade, const Solution& of) {
  std::vector<double> all;
  for (const Graded& g : grade.answers)
    if (g.answer.required) all.push_back((number(of, g.answer) - g.answer.value) / g.answer.scale);
  return all;
}

bool is_finite(const Prediction& p) {
  return std::isfinite(p.error) &&
         std::all_of(p.at_radius.begin(), p.at_radius.end(), [](double off) { return std::isfinite(off); });
}

std::vector<double> change(const std::vector<double>& from, std::vector<double> to, double overlaps) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] = (to[i] - from[i]) / overlaps;
  return to;
}

using Moves = std::vector<std::vector<double>>;

/// Where the places change far less than the limits are known to, they change the same in every prediction.
bool is_little(const Moves& moves, const CaseGrade& grade) {
  double most = 0, least_uncertain = HUGE_VAL;
  for (const std::vector<double>& m : moves)
    for (const double by : m) most = std::max(most, std::abs(by));
  for (const Graded& g : grade.answers)
    if (g.answer.required) least_uncertain = std::min(least_uncertain, g.limit.uncertainty + g.digits);
  return most <= 0.1 * least_uncertain;
}

std::optional<Prediction> stepped(const Case& c, const CaseGrade& grade, Rule rule, Rubs rubs, const Moves* little) {
  const auto radius = by_rule(c, rule, {}, rubs);
  if (!radius) return std::nullopt;
  Prediction all{required(grade, *radius), {}, radius->error};
  if (little) return all.moved = *little, all;
  for (const Places places : {Places{1, 0}, Places{0, 1}})
    all.moved.push_back(change(all.at_radius, required(grade, by_rule(c, rule, places, rubs).value()), 1));
  return all;
}

/// By the case's own solver. Nothing of bodies that no longer part.
std::optional<Prediction> answered_anew(const Case& c, const CaseGrade& grade) {
  try {
    const Solution radius = c.solver(c, ContactArm::radius);
    Prediction all{required(grade, radius), {}, radius.error};
    if (!is_finite(all)) return std::nullopt;
    if (!c.tangential) return all;
    all.moved = {change(all.at_radius, required(grade, c.solver(c, ContactArm::contact_point)), 0.5)};
    const bool damped = spring(c.tangential->law, 1).damping > 0;
    if (damped || is_little(all.moved, grade)) return all;
    if (const auto there = stepped(c, grade, {}, Rubs::repulsion, nullptr)) all.moved = there->moved;
    return all;
  } catch (const std::logic_error&) {
    return std::nullopt;
  }
}

/// The least of a convex function of a number from 0 to 1.
template <class F>
double least(const F& f) {
  double low = 0, high = 1;
  for (int i = 0; i < 30; ++i) {
    const double a = low + (high - low) / 3, b = high - (high - low) / 3;
    if (f(a) < f(b))
      high = b;
    else
      low = a;
  }
  return f(0.5 * (low + high));
}

struct Misfit {
  double greatest = 0;  ///< share of scale
  bool fits = false;    ///< every answer within what the limit and the prediction are known to
};

/// From the engine's limits, forces and slip where they fit best.
Misfit misfit(const Prediction& of, const CaseGrade& grade) {
  std::vector<double> off, known;
  for (const Graded& g : grade.answers) {
    if (!g.answer.required) continue;
    off.push_back(of.at_radius[off.size()] - g.limit.value);
    known.push_back(g.limit.uncertainty + rounding + g.digits + of.error);
  }
  const auto greatest = [&](double force, double slip, double allowed) {
    double most = -HUGE_VAL;
    for (std::size_t i = 0; i < off.size(); ++i) {
      const double moved =
          (of.moved.empty() ? 0 : force * of.moved[0][i]) + (of.moved.size() < 2 ? 0 : slip * of.moved[1][i]);
      most = std::max(most, std::abs(off[i] + moved) - allowed * known[i]);
    }
    return most;
  };
  const auto at_best = [&](double allowed) {
    return least([&](double force) { return least([&](double slip) { return greatest(force, slip, allowed); }); });
  };
  return {at_best(0), at_best(1) <= 0};
}

/// A misunderstanding that changes nothing in a case explains nothing. Bodies that no longer part are a change.
bool changes(const Case& other, const CaseGrade& grade) {
  const auto there = answered_anew(other, grade);
  return !there || std::any_of(there->at_radius.begin(), there->at_radius.end(),
                               [](double off) { return std::abs(off) > rounding; });
}

ContactEnd end_of(const Case& c) { return (c.law ? c.law : c.wall_law).value().end; }

struct Candidate {
  std::vector<std::string> departures = {};  ///< from what is asked
  Prediction prediction = {};
  bool rule = false;
  double misfit = 0;

  bool contains(const Candidate& other) const {
    return departures.size() > other.departures.size() &&
           std::all_of(other.departures.begin(), other.departures.end(), [&](const std::string& d) {
             return std::find(departures.begin(), departures.end(), d) != departures.end();
           });
  }
};

bool alike(const Prediction& a, const Prediction& b) {
  constexpr double stepped_to = 5e-6;
  return std::equal(a.at_radius.begin(), a.at_radius.end(), b.at_radius.begin(),
                    [](double one, double other) { return std::abs(one - other) <= stepped_to; });
}

/// Oblique collisions as engines make them: every rule with every limit of friction and both ends, but for what makes
/// no difference to what is asked, or to one with fewer departures from it.
void add_rules(const Case& c, const CaseGrade& grade, const Prediction& as_asked, std::vector<Candidate>& all) {
  if (!c.tangential) return;
  std::vector<Prediction> seen{as_asked};
  const Moves* const little = is_little(as_asked.moved, grade) ? &as_asked.moved : nullptr;
  for (const RuleOfEngines& rule : rules_for(c.tangential->law))
    for (const bool turned : {false, true})
      for (const Limited& limited : limits_of_friction) {
        const std::optional<Case> other = turned ? other_end(c) : std::optional(c);
        // |F| is the force itself where it is clipped, and before it is where it is not.
        const Rubs no_other = other && end_of(*other) == ContactEnd::force ? Rubs::size : Rubs::unclipped;
        if (!other || limited.rubs == no_other) continue;
        auto there = stepped(*other, grade, rule.rule, limited.rubs, little);
        if (!there) return;
        const bool is_known =
            std::any_of(seen.begin(), seen.end(), [&](const Prediction& p) { return alike(p, *there); });
        seen.push_back(*there);
        if (is_known) continue;
        there->error += as_asked.error;
        Candidate& candidate = all.emplace_back();
        candidate.prediction = *there, candidate.rule = !turned && limited.rubs == Rubs::repulsion;
        for (const char* part : {turned ? words_of_other_end(end_of(c)) : "", limited.what, rule.what})
          if (*part != '\0') candidate.departures.emplace_back(part);
      }
}

/// Of those that fit: the best where it does so clearly better than what was asked, and those that do no worse,
/// clearly; but none with more departures where some of them do.
std::vector<Cause> told(std::vector<Candidate> all, const Prediction& as_asked, const CaseGrade& grade) {
  std::erase_if(all, [&](Candidate& c) {
    const Misfit m = misfit(c.prediction, grade);
    c.misfit = m.greatest;
    return !m.fits;
  });
  if (all.empty()) return {};
  std::stable_sort(all.begin(), all.end(), [](const Candidate& a, const Candidate& b) { return a.misfit < b.misfit; });
  const double known = clearly * (all.front().misfit + all.front().prediction.error + rounding);
  if (misfit(as_asked, grade).greatest < known) return {};
  std::erase_if(all, [&](const Candidate& c) { return c.misfit >= known; });
  std::vector<Cause> causes;
  for (const Candidate& c : all) {
    if (std::any_of(all.begin(), all.end(), [&](const Candidate& o) { return c.contains(o); })) continue;
    Cause& cause = causes.emplace_back();
    cause.what = fmt::format("{}", fmt::join(c.departures, "; ")), cause.misfit = c.misfit, cause.rule = c.rule;
  }
  return causes;
}

/// The engine's limits explained.
std::vector<Cause> by_limits(const Case& of, const CaseGrade& grade) {
  std::vector<Candidate> all;
  const Prediction as_asked = answered_anew(of, grade).value();
  add_rules(of, grade, as_asked, all);
  const bool ends_done = !all.empty() && spring(of.tangential->law, 1).damping == 0;
  for (const Misunderstanding& m : misunderstandings(end_of(of))) {
    const std::optional<Case> other = m.is_end && ends_done ? std::nullopt : m.of(of);
    const auto there = other ? answered_anew(*other, grade) : std::nullopt;
    if (!there) continue;
    Candidate& candidate = all.emplace_back();
    candidate.departures = {m.what}, candidate.prediction = *there;
  }
  return told(std::move(all), as_asked, grade);
}

}  // namespace

std::vector<Cause> causes(const Answered& answered, const CaseResult& result, const CaseGrade& grade) {
  if (grade.verdict == Verdict::exact || grade.verdict == Verdict::not_run) return {};
  std::vector<Cause> repeated;
  if (auto cause = repeated_by(answered.of, "", result, grade)) {
    // Few digits are met by much.
    cause->as_asked = std::all_of(grade.answers.begin(), grade.answers.end(),
                                  [](const Graded& g) { return !g.answer.required || g.digits <= repeated_to; });
    repeated.push_back(*cause);
  }
  if (grade.verdict == Verdict::converges || (!repeated.empty() && repeated.front().as_asked)) return repeated;
  for (const Misunderstanding& m : misunderstandings(end_of(answered.of))) {
    const std::optional<Case> other = m.of(answered.of);
    if (!other || !half_step_run(*other, result.runs.front().steps, Velocities::at_steps)) continue;
    if (!changes(*other, grade)) continue;
    if (const auto cause = repeated_by(*other, m.what + "; ", result, grade)) repeated.push_back(*cause);
  }
  if (!repeated.empty() || grade.verdict != Verdict::elsewhere) return repeated;
  return by_limits(answered.of, grade);
}

CaseGrade explained(const Answered& answered, const CaseResult* result) {
  CaseGrade all = grade(answered, result);
  if (result) all.causes = causes(answered, *result, all);
  const auto is_rule = [](const Cause& c) { return c.rule; };
  if (std::any_of(all.causes.begin(), all.causes.end(), is_rule)) all.verdict = Verdict::another_rule;
  if (!all.causes.empty() && all.causes.front().as_asked) note_that_it_converges(all);
  return all;
}

}  // namespace ricochet::verify::conformance
