#include "oblique.hpp"
#include "outcome.hpp"

#include <verify/registry.hpp>

#include <console/number.hpp>
#include <console/progress.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet::verify {

namespace engines {

namespace {

using calibration::Engine;
using console::Json;
using console::Notation;
using console::Table;

std::string label(const Contact& what) {
  return fmt::format("{}: {}, en {}", text(what.engine), what.name, console::significant(what.en_asked, 6));
}

Table results(const std::vector<Outcome>& outcomes) {
  const Notation four{Notation::Kind::fixed, 4}, power{Notation::Kind::scientific, 1};
  Table table({{"engine"},
               {"contact"},
               {"en asked", "", {Notation::Kind::fixed, 2}},
               {"expected", "", four},
               {"tcol/25", "", four},
               {"tcol/50", "", four},
               {"tcol/100", "", four},
               {"tcol/200", "", four},
               {"tcol/400", "", four},
               {"limit", "", {Notation::Kind::fixed, 6}},
               {"error at tcol/200", "", power},
               {"tcol error, limit", "", power},
               {"repeated to", "", power}},
              "Restitution of pairs and walls in the engines, tcol at the two spheres of one size 1e-4 s");
  for (const Outcome& o : outcomes) {
    std::vector<console::Cell> cells{std::string(text(o.what.engine)), o.what.name, o.what.en_asked, o.what.en};
    for (const Measured& m : o.at) cells.push_back(m.en);
    cells.push_back(o.limit.en);
    cells.push_back(o.error(at_200));
    cells.push_back(o.what.tcol > 0 ? console::Cell(std::abs(o.limit.tcol / o.what.tcol - 1)) : console::blank());
    cells.push_back(o.repeated ? console::Cell(*o.repeated) : console::blank());
    table.row(cells);
  }
  table.note(
      "expected: the target; where the engine ends contacts otherwise, what the snippet says it gives; own: what "
      "verify peers says that the engine's formula gives.");
  table.note(
      "limit: extrapolated to step 0 from the two finest, at first order, in the drivers, which locate the ends of a "
      "contact, at second. repeated to: the engine's stepping done here with the "
      "law, greatest relative difference over all steps.");
  return table;
}

Table deficiencies(const std::vector<Outcome>& outcomes) {
  Table table({{"engine"}, {"contact"}, {"known deficiency"}}, "What the engines get wrong by themselves");
  for (const Outcome& o : outcomes) {
    const auto add = [&](const std::string& deficiency) {
      table.row({std::string(text(o.what.engine)), o.what.name, deficiency});
    };
    if (std::abs(o.what.en - o.what.en_asked) > 1e-3)
      add(fmt::format("en asked {}, obtained {:.4f}", o.what.en_asked, o.limit.en));
    if (o.error(at_200) > 1e-3)
      add(fmt::format(
          "first order in the step: en off by {} % at tcol/200, {} % at tcol/400 (damping from the velocity "
          "half a step before)",
          console::significant(100 * o.error(at_200), 2), console::significant(100 * o.error(finest), 2)));
  }
  return table;
}

}  // namespace

void add_gates(std::vector<Gate>& gates, const Outcome& o) {
  const std::string name = label(o.what) + ": ";
  gates.push_back(at_most(name + "en in the limit, relative error", std::abs(o.limit.en / o.what.en - 1), 1e-3));
  if (o.what.tcol > 0)
    gates.push_back(
        at_most(name + "tcol in the limit, relative error", std::abs(o.limit.tcol / o.what.tcol - 1), 1e-3));
  // A factor of 8 to 16 for an error of first order, of 64 to 256 for one of second; the coarser two together, because
  // one alone may cross zero.
  gates.push_back(at_most(name + "en error at tcol/400 over that at tcol/25 and tcol/50",
                          o.error(finest) / std::max({o.error(0), o.error(1), 4e-5}),
                          o.what.fractional ? 1.0 / 32 : 0.25));
  // Above 1e-3 at tcol/200 only where we can show that it is the engine's own stepping.
  if (o.repeated)
    gates.push_back(at_most(name + "en against its stepping repeated", *o.repeated, 1e-8));
  else
    gates.push_back(at_most(name + "en error at tcol/200", o.error(at_200), 1e-3));
}

namespace {

Json row(const Outcome& o) {
  Json en = Json::array(), times = Json::array(), steps = Json::array();
  for (std::size_t i = 0; i < o.at.size(); ++i) {
    steps.push_back(tcol / resolutions[i]);
    en.push_back(o.at[i].en);
    times.push_back(o.at[i].tcol);
  }
  return {{"engine", text(o.what.engine)},
          {"contact", o.what.name},
          {"en_asked", o.what.en_asked},
          {"en_expected", o.what.en},
          {"tcol_expected", o.what.tcol > 0 ? Json(o.what.tcol) : Json()},
          {"steps", steps},
          {"en", en},
          {"tcol", times},
          {"en_limit", o.limit.en},
          {"tcol_limit", o.limit.tcol},
          {"repeated_difference", o.repeated ? Json(*o.repeated) : Json()}};
}

std::string program_name(Engine engine, bool fractional) {
  return std::string(fractional ? calibration::driver(engine) : text(engine));
}

/// What was run, the programs that are not installed, and the laws that those which are have not got, with why.
struct Runs {
  std::vector<Outcome> outcomes = {};
  std::vector<ObliqueOutcome> oblique = {};
  std::vector<std::string> missing = {}, refused = {};
  bool misses(const std::string& who) const { return std::find(missing.begin(), missing.end(), who) != missing.end(); }
};

/// `outcomes` takes what comes of it.
template <class What, class Outcomes>
void run_one(const What& what, const Contact& contact, Outcomes& outcomes, Runs& runs) {
  const std::string who = program_name(contact.engine, contact.fractional);
  const auto program = EngineProgram::find(contact.engine, contact.fractional);
  if (!program && !runs.misses(who)) runs.missing.push_back(who);
  if (!program) return;
  try {
    outcomes.push_back(engines::run(*program, what));
  } catch (const Refused& why) {
    const std::string law(contact.law ? name(*contact.law) : contact.name);
    const std::string told = fmt::format("{} in {}: {}", law, who, why.what());
    if (std::find(runs.refused.begin(), runs.refused.end(), told) == runs.refused.end()) runs.refused.push_back(told);
  }
}

Runs run_all(const std::vector<Engine>& wanted) {
  std::vector<Contact> contacts;
  for (const Engine engine : wanted)
    for (Contact& contact : contacts_of(engine)) contacts.push_back(std::move(contact));
  Runs runs;
  console::Progress progress("verify engines", contacts.size());
  for (const Contact& what : contacts) {
    run_one(what, what, runs.outcomes, runs);
    progress.advance();
  }
  for (const Engine engine : wanted)
    for (const ObliqueContact& what : oblique_contacts(engine)) run_one(what, what.what, runs.oblique, runs);
  return runs;
}

class Engines : public Study {
 public:
  std::string name() const override { return "engines"; }
  std::string title() const override { return "The engines that are installed here, run with our exports"; }
  std::string claim() const override {
    return "What calibrate --export writes makes the engines that are installed here collide as asked";
  }
  void add_options(CLI::App& command) override {
    command
        .add_option("--require", required_,
                    "fail unless these engines are installed: liggghts, lammps, yade, "
                    "liggghts-ricochet, lammps-ricochet")
        ->check(CLI::IsMember({"liggghts", "lammps", "yade", "liggghts-ricochet", "lammps-ricochet"}));
    command.add_option("--engine", engines_, "run these engines alone: liggghts, lammps, yade")
        ->check(CLI::IsMember({"liggghts", "lammps", "yade"}));
  }
  StudyResult run(const RunOptions&) override;

 private:
  std::vector<std::string> required_, engines_;
};

StudyResult Engines::run(const RunOptions&) {
  std::vector<Engine> wanted;
  for (const Engine engine : {Engine::liggghts, Engine::lammps, Engine::yade})
    if (engines_.empty() || std::find(engines_.begin(), engines_.end(), text(engine)) != engines_.end())
      wanted.push_back(engine);
  const Runs runs = run_all(wanted);
  StudyResult result;
  result.tables = {results(runs.outcomes), deficiencies(runs.outcomes), oblique_table(runs.oblique)};
  result.rows = Json::array();
  for (const Outcome& o : runs.outcomes) {
    add_gates(result.gates, o);
    result.rows.push_back(row(o));
  }
  for (const std::string& who : required_) result.gates.push_back(holds(who + " is installed", !runs.misses(who)));
  for (const Gate& gate : oblique_gates(runs.oblique)) result.gates.push_back(gate);
  result.extra["oblique"] = oblique_rows(runs.oblique);
  result.skipped = runs.missing;
  result.skipped.insert(result.skipped.end(), runs.refused.begin(), runs.refused.end());
  result.verdict = fmt::format("{} contacts and {} oblique impacts run", runs.outcomes.size(), runs.oblique.size());
  for (const std::string& who : runs.missing) result.verdict += fmt::format("; SKIPPED {}: not installed here", who);
  for (const std::string& law : runs.refused) result.verdict += "; SKIPPED " + law;
  result.verdict += ".";
  return result;
}

}  // namespace

}  // namespace engines

std::unique_ptr<Study> engines_study() { return std::make_unique<engines::Engines>(); }

}  // namespace ricochet::verify
