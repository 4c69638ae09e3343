#include "engine_run.hpp"

#include <verify/registry.hpp>

#include <calibrate/calibration.hpp>
#include <console/number.hpp>
#include <console/progress.hpp>
#include <ricochet/collision/peer_damping.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::verify {

namespace {

using calibration::Engine;
using console::Json;
using console::Notation;
using console::shortest;
using console::Table;

// Two spheres of Table II: r = 1.5 mm, 1000 kg/m³.
constexpr double tcol = 1e-4;
constexpr Encounter pair{.radius = 1.5e-3, .density = 1000, .velocity = 0.5, .duration = 1.7 * tcol};

constexpr int resolutions[] = {25, 50, 100, 200, 400};  // steps in tcol
constexpr std::size_t at_200 = 3, finest = 4;

/// One contact in one engine: what it is given and what shall come out when the step goes to zero.
struct Case {
  Engine engine;
  std::string contact;  ///< "tsuji, force" or the engine's own input
  std::string snippet;
  ContactEnd end;  ///< which zero is timed
  double en_asked;
  double en, tcol;            ///< in the limit; tcol 0: not known
  std::optional<AnyLaw> law;  ///< what the engine runs, where its stepping can be repeated with it
  bool fractional = false;
};

struct Measured {
  double en, tcol;
};

struct Outcome {
  Case what;
  std::vector<Measured> at;             ///< over resolutions
  Measured limit{};                     ///< extrapolated from the two finest steps, for errors of first order
  std::optional<double> repeated = {};  ///< greatest relative difference of en from the engine's stepping repeated
  double error(std::size_t i) const { return std::abs(at[i].en / what.en - 1); }
};

/// Time of the first zero after the touch at `begin`: of the overlap between two instants; of the force beyond the last
/// two that repel, because clipped forces have no sign to bracket.
double end_of_contact(const Trajectory& path, double begin, ContactEnd end) {
  for (std::size_t i = 1; i + 1 < path.size(); ++i) {
    const Instant &a = path[i - 1], &b = path[i], &c = path[i + 1];
    if (b.time <= begin) continue;
    if (end == ContactEnd::overlap && b.overlap > 0 && c.overlap <= 0)
      return b.time + (c.time - b.time) * b.overlap / (b.overlap - c.overlap);
    if (end == ContactEnd::force && a.force > 0 && b.force > 0 && c.force <= 0)
      return b.time + (b.time - a.time) * b.force / (a.force - b.force);
  }
  return begin;
}

Measured measure(const Trajectory& path, double step, ContactEnd end) {
  const double begin = steps_before_touch * step;
  return {-path.back().rate / pair.velocity, end_of_contact(path, begin, end) - begin};
}

/// What all three engines do: leapfrog, with the force at the new position and the velocity of half a step before. The
/// lag makes damping, and so the restitution, first order in the step.
template <class Law>
Trajectory repeat_stepping(const Law& law, ContactEnd end, double step) {
  Trajectory path;
  double overlap = -steps_before_touch * step * pair.velocity, rate = pair.velocity;
  for (long n = 0; n <= std::lround(pair.duration / step); ++n) {
    double force = overlap > 0 ? law.force({overlap, rate}, {}) : 0;
    if (end == ContactEnd::force) force = std::max(0.0, force);
    path.push_back({static_cast<double>(n) * step, overlap, rate, force});
    rate -= force / pair.mass_eff() * step;
    overlap += rate * step;
  }
  return path;
}

std::optional<Trajectory> repeat_stepping(const AnyLaw& law, ContactEnd end, double step) {
  if (const auto* l = std::get_if<Linear>(&law)) return repeat_stepping(*l, end, step);
  if (const auto* l = std::get_if<KuwabaraKono>(&law)) return repeat_stepping(*l, end, step);
  if (const auto* l = std::get_if<Tsuji>(&law)) return repeat_stepping(*l, end, step);
  return std::nullopt;
}

AnyLaw calibrated(calibration::LawName law, ContactEnd end, double en) {
  const calibration::Request request{law, end, {tcol, en, {pair.velocity, pair.mass_eff()}}};
  return std::get<calibration::Calibration>(calibration::calibrate(request, {.method = calibration::Method::direct}))
      .law;
}

/// Every law that the engine can be given, as `calibrate --export` writes it.
void add_exports(std::vector<Case>& cases, Engine engine) {
  using calibration::LawName;
  for (const double en : {0.5, 0.9})
    for (const auto law :
         {LawName::linear, LawName::kuwabara_kono, LawName::tsuji, LawName::hysteretic, LawName::fractional})
      for (const auto end : {ContactEnd::overlap, ContactEnd::force}) {
        if (!offers(law, end)) continue;
        const calibration::ExportCase what{.law = calibrated(law, end, en),
                                           .end = end,
                                           .tcol = tcol,
                                           .en = en,
                                           .impact = {pair.velocity, pair.mass_eff()},
                                           .radius_eff = pair.radius_eff(),
                                           .density = pair.density};
        const auto snippet = calibration::export_law(engine, what);
        if (snippet.fidelity == calibration::Fidelity::absent) continue;
        const bool exact = snippet.fidelity == calibration::Fidelity::exact;
        // A close snippet promises what it says it gives: another end of contact, or another law that meets the target.
        const bool other_end = snippet.gives.status == CollisionStatus::ended_by_force && end == ContactEnd::overlap;
        const ContactEnd runs = other_end ? ContactEnd::force : end;
        const bool repeatable = exact || other_end;
        cases.push_back({engine,
                         "exported " + std::string(calibration::text(law)) + ", " + std::string(calibration::text(end)),
                         snippet.text, runs, en, snippet.gives.en, snippet.gives.tcol,
                         repeatable ? std::optional(what.law) : std::nullopt, law == LawName::fractional});
      }
}

const PeerDamping& peer(std::string_view id) {
  const auto all = peer_dampings();
  return *std::find_if(all.begin(), all.end(), [id](const PeerDamping& p) { return p.id == id; });
}

/// The engine's own way to ask for a restitution, against what `verify peers` says it gives.
void add_own_formulas(std::vector<Case>& cases, Engine engine) {
  constexpr double asked = 0.5, nu = 0.3, m_young = 1e8;
  const double m = pair.mass_eff(), root = std::sqrt(pair.radius_eff());
  const double k = 4.0 / 3.0 * m_young / (2 * (1 - nu * nu)) * root;  // of E = 1e8 Pa
  const auto add = [&](const char* id, const std::string& snippet) {
    const PeerDamping& p = peer(id);
    const double beta = p.damping_ratio(asked), loss = -std::log(asked);
    const AnyLaw law = p.law == PeerLaw::tsuji
                           ? AnyLaw(Tsuji(k, beta * std::sqrt(5 * m * k)))
                           : AnyLaw(Linear(m * (std::numbers::pi * std::numbers::pi + loss * loss) / (tcol * tcol),
                                           2 * m * loss / tcol));
    cases.push_back(
        {engine, "own: " + std::string(id), snippet, p.end, asked, restitution_of_damping(beta, p.end), 0, law});
  };
  const std::string material =
      "fix young all property/global youngsModulus peratomtype 1e8\n"
      "fix nu all property/global poissonsRatio peratomtype 0.3\n"
      "fix en all property/global coefficientRestitution peratomtypepair 1 0.5\n"
      "pair_style gran model hertz tangential off limitForce ";
  const std::string mindlin =
      "material = FrictMat(young=1e8, poisson=0.3, frictionAngle=0)\n"
      "law2 = Law2_ScGeom_MindlinPhys_Mindlin()\n"
      "ip2 = Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5, es=0.5)\n";
  if (engine == Engine::lammps)
    add("lammps tsuji 2021", "pair_style granular\npair_coeff * * hertz " + shortest(k / root) +
                                 " 0.5 damping tsuji tangential linear_nohistory 0.0 0.0\n");
  if (engine == Engine::liggghts) {
    add("liggghts hertz", material + "off\npair_coeff * *\n");
    add("liggghts hertz, limited", material + "on\npair_coeff * *\n");
  }
  if (engine == Engine::yade) {
    add("yade tc-en",
        "material = ViscElMat(tc=1e-4, en=0.5, et=1, frictionAngle=0)\n"
        "ip2 = Ip2_ViscElMat_ViscElMat_ViscElPhys()\nlaw2 = Law2_ScGeom_ViscElPhys_Basic()\n");
    add("yade mindlin 2023", mindlin);
  }
}

Outcome run_case(const EngineProgram& program, const Case& what) {
  std::vector<double> steps;
  for (const int n : resolutions) steps.push_back(tcol / n);
  Outcome outcome{.what = what, .at = {}};
  const auto paths = program.run(what.snippet, pair, steps);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    if (paths[i].size() < 3) throw std::runtime_error("no trajectory came back of " + what.contact);
    outcome.at.push_back(measure(paths[i], steps[i], what.end));
    if (!what.law) continue;
    if (const auto path = repeat_stepping(*what.law, what.end, steps[i]))
      outcome.repeated = std::max(outcome.repeated.value_or(0),
                                  std::abs(outcome.at[i].en / measure(*path, steps[i], what.end).en - 1));
  }
  const Measured &coarse = outcome.at[at_200], &fine = outcome.at[finest];
  outcome.limit = {2 * fine.en - coarse.en, 2 * fine.tcol - coarse.tcol};
  return outcome;
}

std::string label(const Case& what) {
  return std::string(text(what.engine)) + ": " + what.contact + ", en " + shortest(what.en_asked);
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
              "Restitution of two spheres in the engines, tcol = 1e-4 s");
  for (const Outcome& o : outcomes) {
    std::vector<console::Cell> cells{std::string(text(o.what.engine)), o.what.contact, o.what.en_asked, o.what.en};
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
      "limit: extrapolated to step 0 from the two finest. repeated to: the engine's stepping done here with the "
      "law, greatest relative difference over all steps.");
  return table;
}

Table deficiencies(const std::vector<Outcome>& outcomes) {
  Table table({{"engine"}, {"contact"}, {"known deficiency"}}, "What the engines get wrong by themselves");
  for (const Outcome& o : outcomes) {
    const auto add = [&](const std::string& text_) {
      table.row({std::string(text(o.what.engine)), o.what.contact, text_});
    };
    if (std::abs(o.what.en - o.what.en_asked) > 1e-3)
      add("en asked " + shortest(o.what.en_asked) + ", obtained " + console::fixed(o.limit.en, 4));
    if (o.error(at_200) > 1e-3)
      add("first order in the step: en off by " + console::significant(100 * o.error(at_200), 2) + " % at tcol/200, " +
          console::significant(100 * o.error(finest), 2) +
          " % at tcol/400 (damping from the velocity half a step before)");
  }
  return table;
}

void add_gates(std::vector<Gate>& gates, const Outcome& o) {
  const std::string name = label(o.what) + ": ";
  gates.push_back(at_most(name + "en in the limit, relative error", std::abs(o.limit.en / o.what.en - 1), 1e-3));
  if (o.what.tcol > 0)
    gates.push_back(
        at_most(name + "tcol in the limit, relative error", std::abs(o.limit.tcol / o.what.tcol - 1), 1e-3));
  // A factor of 8 to 16 for an error of first order; the coarser two together, because one alone may cross zero.
  gates.push_back(at_most(name + "en error at tcol/400 over that at tcol/25 and tcol/50",
                          o.error(finest) / std::max({o.error(0), o.error(1), 4e-5}), 0.25));
  // Above 1e-3 at tcol/200 only where we can show that it is the engine's own stepping.
  if (o.repeated)
    gates.push_back(at_most(name + "en against its stepping repeated", *o.repeated, 1e-8));
  else
    gates.push_back(at_most(name + "en error at tcol/200", o.error(at_200), 1e-3));
}

Json row(const Outcome& o) {
  Json en = Json::array(), times = Json::array(), steps = Json::array();
  for (std::size_t i = 0; i < o.at.size(); ++i) {
    steps.push_back(tcol / resolutions[i]);
    en.push_back(o.at[i].en);
    times.push_back(o.at[i].tcol);
  }
  return {{"engine", text(o.what.engine)},
          {"contact", o.what.contact},
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

class Engines : public Study {
 public:
  std::string name() const override { return "engines"; }
  std::string claim() const override {
    return "What calibrate --export writes makes the engines that are installed here collide as asked";
  }
  void add_options(CLI::App& command) override {
    command
        .add_option("--require", required_,
                    "fail unless these engines are installed: liggghts, lammps, yade, "
                    "liggghts-ricochet")
        ->check(CLI::IsMember({"liggghts", "lammps", "yade", "liggghts-ricochet"}));
  }
  StudyResult run(const RunOptions&) override;

 private:
  std::vector<std::string> required_;
};

std::string program_name(Engine engine, bool fractional) {
  return fractional ? "liggghts-ricochet" : std::string(text(engine));
}

StudyResult Engines::run(const RunOptions&) {
  std::vector<Case> cases;
  for (const Engine engine : {Engine::liggghts, Engine::lammps, Engine::yade}) {
    add_exports(cases, engine);
    add_own_formulas(cases, engine);
  }
  std::vector<Outcome> outcomes;
  std::vector<std::string> missing;
  console::Progress progress("verify engines", cases.size());
  for (const Case& what : cases) {
    if (const auto program = EngineProgram::find(what.engine, what.fractional)) {
      outcomes.push_back(run_case(*program, what));
    } else if (const auto who = program_name(what.engine, what.fractional);
               std::find(missing.begin(), missing.end(), who) == missing.end()) {
      missing.push_back(who);
    }
    progress.advance();
  }
  StudyResult result;
  result.tables = {results(outcomes), deficiencies(outcomes)};
  result.rows = Json::array();
  for (const Outcome& o : outcomes) {
    add_gates(result.gates, o);
    result.rows.push_back(row(o));
  }
  for (const std::string& who : required_)
    result.gates.push_back(
        holds(who + " is installed", std::find(missing.begin(), missing.end(), who) == missing.end()));
  result.extra["skipped"] = missing;
  result.verdict = std::to_string(outcomes.size()) + " contacts run";
  for (const std::string& who : missing) result.verdict += "; SKIPPED " + who + ": not installed here";
  result.verdict += ".";
  return result;
}

}  // namespace

std::unique_ptr<Study> engines_study() { return std::make_unique<Engines>(); }

}  // namespace ricochet::verify
