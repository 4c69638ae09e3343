#include "body.hpp"

#include <calibrate/advice.hpp>
#include <calibrate/materials.hpp>
#include <ricochet/collision/damping_ratio.hpp>
#include <ricochet/support/require.hpp>
#include <run_watch.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

namespace ricochet::calibration {

namespace {

struct Language {
  Engine engine;
  std::string_view name, version, comment;
  Body (*write)(const ContactSet&);
  std::string_view step_before, step_behind;  ///< what sets the time step, around its number
  std::string_view driver = {};               ///< our program that adds laws with a memory, where there is one
};

constexpr std::array<Language, 5> languages{{
    {Engine::liggghts, "liggghts", "LIGGGHTS 3.8.0", "# ", write_liggghts, "timestep ", "", "liggghts-ricochet"},
    {Engine::lammps, "lammps", "LAMMPS 29 Sep 2021 and 4 Feb 2025", "# ", write_lammps, "timestep ", "",
     "lammps-ricochet"},
    {Engine::yade, "yade", "Yade 2023.02a", "# ", write_yade, "O.dt = ", ""},
    {Engine::mercurydpm, "mercurydpm", "MercuryDPM, revision of July 2024", "// ", write_mercurydpm, "setTimeStep(",
     ");"},
    {Engine::mfix, "mfix", "MFiX 25.2.1", "! ", write_mfix, "DTSOLID_FACTOR = ", ""},
}};

const Language& language(Engine engine) { return languages[std::size_t(engine)]; }

void check(const PairCase& pair) {
  support::require_positive("tcol", pair.tcol);
  support::require(pair.en > 0 && pair.en <= 1, "en", pair.en, "in (0, 1]");
  support::require_positive("velocity", pair.impact.velocity);
  support::require_positive("mass_eff", pair.impact.mass_eff);
  if (pair.radius_eff) support::require_positive("radius_eff", *pair.radius_eff);
  if (pair.tangential) support::require(pair.tangential->mu >= 0, "mu", pair.tangential->mu, ">= 0");
}

/// One kind of tangential law, or none.
bool alike(const std::optional<TangentialPart>& a, const std::optional<TangentialPart>& b) {
  return a.has_value() == b.has_value() && (!a || a->law.index() == b->law.index());
}

void check(const ContactSet& set) {
  if (set.pairs.empty()) throw std::invalid_argument("a set of contacts needs at least one");
  for (const BodyKind& kind : set.kinds)
    if (kind.density) support::require_positive("density", *kind.density);
  for (const PairCase& pair : set.pairs) {
    check(pair);
    if (pair.law.index() != set.pairs.front().law.index())
      throw std::invalid_argument("the contacts of a set must have laws of one kind");
    if (!alike(pair.tangential, set.pairs.front().tangential))
      throw std::invalid_argument("the contacts of a set must have tangential laws of one kind, or none");
    if (std::max(pair.a, pair.b) >= set.kinds.size() || set.kinds[pair.a].wall)
      throw std::invalid_argument("a contact must be of a grain with a grain or wall of the set");
  }
}

ContactSet of_one_pair(const ExportCase& what) {
  return {what.end,
          {{.name = "grain", .density = what.density}},
          {{0, 0, what.law, what.tcol, what.en, what.impact, what.radius_eff, what.tangential}}};
}

/// "k = 7316 kg/s^2, c = 0.098 kg/s"
std::string in_words(const AnyLaw& law) {
  std::vector<std::string> words;
  for (const NamedValue& p : parameters(law))
    words.push_back(fmt::format("{} = {}{}{}", p.name, shortest(p.value), p.unit.empty() ? "" : " ", p.unit));
  return fmt::format("{}", fmt::join(words, ", "));
}

/// "Tangential: linear, k_t = 2500 kg/s^2, c_t = 0 kg/s, mu = 0.3"
std::string in_words(const TangentialPart& part) {
  std::string words = fmt::format("Tangential: {}", name(part.law));
  const std::vector<double> all = values(part.law);
  std::size_t i = 0;
  for (const Parameter& p : parameters_of(part.law))
    words += fmt::format(", {} = {} {}", p.name, shortest(all[i++]), p.unit());
  return words + fmt::format(", mu = {}", shortest(part.mu));
}

/// Whether any contact that ends by overlap attracts before it does, as every dashpot along the normal makes it.
bool attracts(const ContactSet& set) {
  return std::any_of(set.pairs.begin(), set.pairs.end(), [](const PairCase& p) { return p.en < 1; });
}

/// All five engines limit friction by mu times the size of the normal force; Yade's clip the attraction before.
std::string rubs_under_attraction(std::string_view engine) {
  return fmt::format(
      "{} limits friction by mu |F_n| also where the normal force attracts, before the overlap ends; the law asked for "
      "has no friction there. Rebounds of oblique impacts differ, e_t by about 0.01 at a restitution of 0.3. A contact "
      "ended by force has no such part.",
      engine);
}

/// What the engine makes of the contacts.
Body written(const Language& in, const ContactSet& set) {
  if (frictional(set) && !compliant(set.pairs.front().tangential->law))
    return absent(
        fmt::format("NOT WRITTEN: {} has no friction without a spring, which the rigid law is; give a "
                    "tangential law that has one.",
                    in.version));
  if (is_mindlin(set) && !knows_radii(set)) return needs_radius();
  Body body = in.write(set);
  const bool by_overlap = body.other_end.value_or(set.end) == ContactEnd::overlap;
  if (body.fidelity != Fidelity::absent && frictional(set) && by_overlap && attracts(set)) {
    body.fidelity = Fidelity::close;
    body.remarks.push_back(rubs_under_attraction(in.version));
  }
  return body;
}

/// "4.3e-05 s (-14 %)": a value beside the one asked for.
std::string beside(double value, double asked, std::string_view unit = "") {
  const double percent = 100 * (value / asked - 1);
  return fmt::format("{}{} ({}{} %)", rounded(value), unit, percent < 0 ? "" : "+", support::significant(percent, 2));
}

/// Breaks a sentence into comment lines of at most 100 columns.
void append_comment(std::string& text, std::string_view mark, std::string_view sentence) {
  constexpr std::size_t width = 100;
  while (!sentence.empty()) {
    std::size_t cut = sentence.size();
    if (mark.size() + cut > width) {
      cut = sentence.rfind(' ', width - mark.size());
      if (cut == std::string_view::npos) cut = std::min(sentence.find(' '), sentence.size());
    }
    text += fmt::format("{}{}\n", mark, sentence.substr(0, cut));
    sentence.remove_prefix(std::min(cut + 1, sentence.size()));
  }
}

/// "Target" of the only pair, "Grain, wall" of one among several.
std::string title_of(const ContactSet& set, const PairCase& pair) {
  return set.kinds.size() == 1 ? "Target" : fmt::format("{}, {}", set.kinds[pair.a].name, set.kinds[pair.b].name);
}

std::string heading(const Language& in, const ContactSet& set) {
  std::string lines;
  append_comment(lines, in.comment,
                 fmt::format("Ricochet: {} law, contact ended by {}, for {}, SI units", name(set.pairs.front().law),
                             text(set.end), in.version));
  for (const PairCase& pair : set.pairs) {
    std::string target = fmt::format("{}: collision time {} s, restitution {} at {} m/s, effective mass {} kg",
                                     title_of(set, pair), shortest(pair.tcol), shortest(pair.en),
                                     shortest(pair.impact.velocity), shortest(pair.impact.mass_eff));
    if (pair.radius_eff) target += fmt::format(", effective radius {} m", shortest(*pair.radius_eff));
    append_comment(lines, in.comment, target);
    append_comment(lines, in.comment, fmt::format("Law: {}", in_words(pair.law)));
    if (pair.tangential) append_comment(lines, in.comment, in_words(*pair.tangential));
  }
  for (const std::string& note : set.notes) append_comment(lines, in.comment, note);
  return lines;
}

std::string what_it_gives(const Collision& gives, const PairCase& pair) {
  if (!gives.separated()) return "GIVES INSTEAD: a contact that never separates";
  return fmt::format("GIVES INSTEAD: collision time {}, restitution {}", beside(gives.tcol, pair.tcol, " s"),
                     beside(gives.en, pair.en));
}

/// See Snippet::off.
double off(const Collision& gives, const PairCase& pair) {
  if (!gives.separated()) return 1;
  return std::max(std::abs(gives.tcol / pair.tcol - 1), std::abs(gives.en - pair.en));
}

/// What comes out where the engine ends contacts otherwise; a contact that then never separates is not written.
void tell_other_end(const Language& in, const ContactSet& set, Body& body, Snippet& snippet) {
  for (std::size_t i = 0; i < set.pairs.size(); ++i) {
    const std::string who = set.kinds.size() == 1 ? "" : title_of(set, set.pairs[i]) + " ";
    append_comment(snippet.text, in.comment, who + what_it_gives(snippet.gives[i], set.pairs[i]));
    if (snippet.gives[i].separated()) continue;
    snippet.fidelity = Fidelity::absent;
    body.input.clear();
  }
}

/// Steps of one pair: the time that they divide, and the error of e_n that each number of them leaves.
struct PairSteps {
  double tcol = 0;
  Stepping stepping = Stepping::half_step;
  std::vector<StepError> errors = {};
  double asked = 0;  ///< the error that the step asked for leaves
};

/// As the engine steps the pair, towards what its law gives.
PairSteps steps_of(const ContactSet& set, const PairCase& pair, const Collision& gives) {
  const ContactEnd end = gives.status == CollisionStatus::ended_by_force ? ContactEnd::force : ContactEnd::overlap;
  const Target target{gives.tcol, gives.en, pair.impact};
  PairSteps steps{end == set.end ? pair.tcol : gives.tcol, stepping_of(pair.law, end)};
  steps.errors = step_errors(pair.law, end, target, steps.stepping);
  if (set.step) steps.asked = step_error(pair.law, end, target, steps.tcol / *set.step, steps.stepping);
  return steps;
}

/// The longest step that keeps the e_n of every pair to `bound`; nullopt where there is none.
std::optional<double> step_for(const std::vector<PairSteps>& pairs, double bound) {
  std::optional<double> least;
  for (const PairSteps& pair : pairs) {
    const auto steps = steps_for(pair.errors, bound, pair.stepping);
    if (!steps) return std::nullopt;
    least = std::min(least.value_or(pair.tcol), pair.tcol / *steps);
  }
  return least;
}

/// The number by which an engine divides a time of its own, at least 10, as MFiX wants it.
double divisor(double time, double step) { return std::max(10.0, std::ceil(time / step * (1 - 1e-9))); }

/// How the engine ends contacts, whatever was asked for.
ContactEnd end_in(const ContactSet& set, const Body& body) { return body.other_end.value_or(set.end); }

/// Where the law keeps e_n at every size, " lammps and yade write numbers that keep the restitution …"; else nothing.
std::string who_keeps(LawKind law) {
  std::vector<std::string> engines;
  for (const SizeChoice& choice : size_choices(law))
    if (choice.written) engines.push_back(choice.engine);
  return engines.empty() ? ""
                         : fmt::format(" Numbers that keep the restitution at every size are written for: {}.",
                                       fmt::join(engines, ", "));
}

/// Grains of other sizes that stay together under the numbers of the file, a sentence each.
std::vector<std::string> never_parting(const ContactSet& set, ContactEnd end) {
  std::vector<std::string> sentences;
  for (const PairCase& other : set.other_sizes) {
    if (collide(other.law, other.impact, {.end = end}).separated()) continue;
    sentences.push_back(
        fmt::format("NEVER PART: {} and {} of effective mass {} kg: under the numbers of this file, which are the same "
                    "for every size, their contact does not end.",
                    set.kinds[other.a].name, set.kinds[other.b].name, rounded(other.impact.mass_eff)));
  }
  if (!sentences.empty()) sentences.back() += who_keeps(LawKind::of(set.pairs.front().law));
  return sentences;
}

/// How the engine steps every pair and other size.
std::vector<PairSteps> all_steps(const ContactSet& set, const Body& body, const Snippet& snippet) {
  std::vector<PairSteps> all;
  for (std::size_t i = 0; i < set.pairs.size(); ++i) all.push_back(steps_of(set, set.pairs[i], snippet.gives[i]));
  for (const PairCase& other : set.other_sizes) {
    const Collision gives = collide(other.law, other.impact, {.end = end_in(set, body)});
    if (gives.separated()) all.push_back(steps_of(set, other, gives));
  }
  return all;
}

/// "1e-06 s (tcol/100)": as a share of the collision time where there is only one.
std::string in_words(const std::vector<PairSteps>& pairs, double step) {
  const double tcol = pairs.front().tcol;
  const bool one = std::all_of(pairs.begin(), pairs.end(), [&](const PairSteps& p) { return p.tcol == tcol; });
  return one ? fmt::format("{} s (tcol/{})", shortest(step), rounded(tcol / step)) : shortest(step) + " s";
}

/// What the step that was asked for does to the pair that it suits least.
std::string asked_in_words(const Language& in, const std::vector<PairSteps>& pairs, double step) {
  const auto worst = std::max_element(pairs.begin(), pairs.end(),
                                      [](const PairSteps& a, const PairSteps& b) { return a.asked < b.asked; });
  const std::string off = std::isfinite(worst->asked)
                              ? fmt::format("is up to {} % off", support::significant(100 * worst->asked, 2))
                              : "is lost, the contact does not end";
  std::string text = fmt::format("{}, as asked: the restitution {}", in_words(pairs, step), off);
  using half_step::RunWatch;
  if (worst->stepping == Stepping::located && worst->tcol / step * (1 + RunWatch::known_to) < RunWatch::advised_steps)
    text += fmt::format(" ({} warns of fewer than {} steps in a collision and refuses fewer than {})", in.driver,
                        RunWatch::advised_steps, RunWatch::least_steps);
  return text;
}

/// The time step as comment and command: the one that was asked for, else the one for the least of step_bounds.
void append_step(const Language& in, const ContactSet& set, const Body& body, Snippet& snippet) {
  const std::vector<PairSteps> pairs = all_steps(set, body, snippet);
  std::string told;
  std::optional<double> finest;
  for (const double bound : step_bounds)
    if (const auto step = step_for(pairs, bound)) {
      told += fmt::format("{}{}{} to {} %", finest ? ", " : "", in_words(pairs, *step),
                          finest     ? ""
                          : set.step ? " keeps it"
                                     : " keeps the restitution",
                          shortest(100 * bound));
      finest = step;
    }
  if (!finest && !set.step) return;
  if (finest) told += ", wherever in a step the first touch falls";
  if (set.step) told = asked_in_words(in, pairs, *set.step) + (finest ? "; " : "") + told;
  append_comment(snippet.text, in.comment, fmt::format("Time step: {}.", told));
  if (body.divided_time)
    append_comment(snippet.text, in.comment,
                   fmt::format("That is by its default, DES_INTG_METHOD = 'EULER', which was read, not run. The engine "
                               "divides what it takes for the collision time, {} s, by the factor; versions without "
                               "that keyword always divide by 50.",
                               rounded(*body.divided_time)));
  const double step = set.step ? *set.step : *finest;
  snippet.text += fmt::format("{}{}{}\n", in.step_before,
                              shortest(body.divided_time ? divisor(*body.divided_time, step) : step), in.step_behind);
}

/// The close one among them that is least off; the end where there is none.
std::vector<Snippet>::const_iterator least_off(const std::vector<Snippet>& snippets) {
  constexpr double alike = 1e-3;
  auto least = snippets.end();
  for (auto it = snippets.begin(); it != snippets.end(); ++it)
    if (it->fidelity == Fidelity::close && (least == snippets.end() || it->off < least->off - alike)) least = it;
  return least;
}

}  // namespace

bool runs(Engine engine, const ExportCase& what) {
  const Body body = written(language(engine), of_one_pair(what));
  return body.fidelity != Fidelity::absent && !body.other_end;
}

std::span<const Engine> engines() noexcept {
  static constexpr std::array all{Engine::liggghts, Engine::lammps, Engine::yade, Engine::mercurydpm, Engine::mfix};
  return all;
}

std::string_view text(Engine engine) noexcept { return language(engine).name; }
std::string_view version(Engine engine) noexcept { return language(engine).version; }
std::string_view driver(Engine engine) noexcept { return language(engine).driver; }

std::optional<Engine> engine_named(std::string_view word) noexcept {
  for (const Language& l : languages)
    if (l.name == word) return l.engine;
  return std::nullopt;
}

std::optional<Engine> engine_run_by(std::string_view program) noexcept {
  for (const Language& l : languages)
    if (!program.empty() && l.driver == program) return l.engine;
  return engine_named(program);
}

std::string_view text(Fidelity fidelity) noexcept {
  constexpr std::string_view words[] = {"exact", "close", "absent"};
  return words[std::size_t(fidelity)];
}

Snippet export_contacts(Engine engine, const ContactSet& set) {
  check(set);
  const Language& in = language(engine);
  Body body = written(in, set);
  Snippet snippet{engine, set.pairs.front().law, set.end, body.fidelity, {}, body.remarks, heading(in, set)};
  const ContactEnd end = end_in(set, body);
  if (body.fidelity != Fidelity::absent) {
    for (const PairCase& pair : set.pairs) {
      snippet.gives.push_back(collide(pair.law, pair.impact, {.end = end}));
      snippet.off = std::max(snippet.off, off(snippet.gives.back(), pair));
    }
    for (const std::string& sentence : never_parting(set, end)) {
      body.remarks.push_back(sentence);
      snippet.remarks.push_back(sentence);
    }
  }
  if (body.other_end) tell_other_end(in, set, body, snippet);
  for (const std::string& remark : body.remarks) append_comment(snippet.text, in.comment, remark);
  snippet.text += body.input;
  if (snippet.fidelity != Fidelity::absent) append_step(in, set, body, snippet);
  return snippet;
}

Snippet export_law(Engine engine, const ExportCase& what) { return export_contacts(engine, of_one_pair(what)); }

std::string comment(Engine engine, std::string_view sentence) {
  std::string text;
  append_comment(text, language(engine).comment, sentence);
  return text;
}

std::string combine(const std::vector<Snippet>& snippets) {
  const auto has = [](Fidelity f) { return [f](const Snippet& s) { return s.fidelity == f; }; };
  auto active = std::find_if(snippets.begin(), snippets.end(), has(Fidelity::exact));
  if (active == snippets.end()) active = least_off(snippets);
  std::string all;
  for (auto it = snippets.begin(); it != snippets.end(); ++it) {
    if (it != snippets.begin()) all += "\n";
    const std::string mark(language(it->engine).comment);
    std::size_t from = 0;
    while (from < it->text.size()) {
      const std::size_t to = it->text.find('\n', from) + 1;
      const std::string line = it->text.substr(from, to - from);
      all += (it == active || line.starts_with(mark) ? "" : mark) + line;
      from = to;
    }
  }
  return all;
}

}  // namespace ricochet::calibration
