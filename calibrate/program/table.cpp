#include "real_sphere.hpp"
#include "report.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace ricochet::calibration {
namespace {

using console::Cell;
using console::Notation;
using console::Table;

constexpr Notation nine{Notation::Kind::significant, 9};
constexpr Notation rough{Notation::Kind::scientific, 0};

std::string law_of(const Calibration& r) { return std::string(name(r.law)); }
std::string end_of(const Calibration& r) { return std::string(text(r.end)); }

/// One line a parameter, since every law has its own units.
Table parameter_table(const Report& report) {
  const Impact& impact = report.job.known.impact;
  Table table(
      {{"law"}, {"end"}, {"parameter"}, {"value", "", nine}, {"unit"}},
      fmt::format("{}{} at {} m/s, effective mass {} kg{}", report.job.given ? "The law " : "Parameters for ",
                  asked_text(report.job), console::shortest(impact.velocity), console::significant(impact.mass_eff, 9),
                  report.job.load ? fmt::format(", under {} N", console::shortest(*report.job.load)) : ""));
  for (const auto& r : report.results)
    for (const auto& p : parameters(r.law)) table.row({law_of(r), end_of(r), p.name, p.value, p.unit});
  for (const auto& assumption : report.job.assumptions) table.note("assumed: " + assumption);
  return table;
}

void note_fractional(Table& table, const Calibration& r) {
  const auto* law = std::get_if<Fractional>(&r.law);
  if (!law) return;
  if (law->alpha() == 0)
    table.note("fractional: alpha = 0 is a spring and c has no effect; sqrt(k m) is shown for it");
  else
    table.note(
        fmt::format("fractional, ended by {}: only alpha and c^alpha k^(1-alpha) = {} kg s^(alpha-2) are identifiable; "
                    "k is held and c goes with it",
                    end_of(r), console::significant(law->coefficient(), 9)));
}

/// What was held of a law of real solids.
void note_held(Table& table, const Calibration& r) {
  const Request& request = r.request;
  const std::string which = fmt::format("{}, ended by {}", law_of(r), end_of(r)),
                    alpha = console::significant(request.held.alpha, 9);
  if (request.stiffness)
    table.note(fmt::format("{}: tcol, en and the k that is held leave alpha = {}", which, alpha));
  else if (request.law == kind_of<FractionalZener>)
    table.note(fmt::format("{}: alpha = {} and k1/k = {} are held; tcol and en tell k and tau", which, alpha,
                           console::shortest(request.held.stiffening)));
  else
    table.note(fmt::format("{}: alpha = {} is held; tcol and en tell k and c", which, alpha));
}

/// Where e_n stops being defined, and what its number does not say.
void note_load(Table& table, const Calibration& r) {
  const UnderLoad& u = *r.under_load;
  if (u.least_velocity > 0)
    table.note(fmt::format("{}: below {} m/s the load of {} N keeps the bodies together, and there is no en", law_of(r),
                           console::significant(u.least_velocity, 3), console::shortest(u.load)));
  if (!u.clears)
    table.note(fmt::format(
        "{}: it comes off, but so slowly that the load alone pushes it back before the overlap is gone", law_of(r)));
}

Table collision_table(const Report& report) {
  std::vector<console::Column> columns{{"law"},
                                       {"end"},
                                       {"tcol", "s", nine},
                                       {"en", "", nine},
                                       {"max overlap", "m"},
                                       {"overlap at end", "m"},
                                       {"max force", "N"},
                                       {"tcol by Eq. (57)", "s"}};
  if (report.job.radius) columns.push_back({"max overlap/radius", "%", {Notation::Kind::significant, 3}});
  Table table(columns, report.job.load    ? "What happens under the load"
                       : report.job.given ? "What it does"
                                          : "What they do, by an independent numerical collision");
  for (const auto& r : report.results) {
    std::vector<Cell> row{law_of(r),
                          end_of(r),
                          r.achieved.tcol,
                          r.achieved.en,
                          r.achieved.max_overlap,
                          r.achieved.overlap_end,
                          r.achieved.max_force,
                          r.tcol_estimate ? Cell(*r.tcol_estimate) : console::blank()};
    if (report.job.radius) row.push_back(100 * r.achieved.max_overlap / *report.job.radius);
    table.row(row);
  }
  for (const auto& r : report.results) note_fractional(table, r);
  for (const auto& r : report.results)
    if (!report.job.given && holds_degree(r.request.law)) note_held(table, r);
  for (const auto& r : report.results)
    if (r.under_load) note_load(table, r);
  for (const auto& r : report.results)
    if (const auto sphere = real_sphere(report.job, r))
      table.note(fmt::format("{}, ended by {}: {}", law_of(r), end_of(r), said(*sphere)));
  for (const auto& r : report.results)
    if (report.job.radius && r.achieved.max_overlap > *report.job.radius)
      table.note(fmt::format("{}, ended by {}: goes deeper than the radius, which no grain can; take it stiffer",
                             law_of(r), end_of(r)));
  return table;
}

Table check_table(const Report& report) {
  Table table({{"law"},
               {"end"},
               {"method"},
               {"algorithm"},
               {"collisions"},
               {"tcol error", "", rough},
               {"en error", "", rough},
               {"cross-check by"},
               {"difference", "", rough}},
              "How far from the target, and from the other method's parameters (relative)");
  for (const auto& r : report.results)
    table.row({law_of(r), end_of(r), std::string(text(r.method)), r.algorithm, static_cast<std::int64_t>(r.evaluations),
               std::abs(r.tcol_residual), std::abs(r.en_residual), std::string(text(r.cross_method)),
               r.cross_difference});
  for (const auto& r : report.results)
    for (const auto& remark : r.remarks) table.note(fmt::format("{}, ended by {}: {}", law_of(r), end_of(r), remark));
  return table;
}

/// "liggghts, lammps": the engines of one law, which step it alike; steps that keep e_n to the bound.
struct Advised {
  std::string engines;
  std::optional<double> step[std::size(step_bounds)];
};

std::vector<Advised> advised(const std::vector<EngineStep>& steps) {
  constexpr std::size_t bounds = std::size(step_bounds);
  std::vector<Advised> all;
  for (std::size_t i = 0; i + bounds <= steps.size(); i += bounds) {
    Advised one{steps[i].engine, {}};
    for (std::size_t j = 0; j < bounds; ++j) one.step[j] = steps[i + j].step;
    if (!all.empty() && std::equal(std::begin(one.step), std::end(one.step), std::begin(all.back().step)))
      all.back().engines += ", " + one.engines;
    else
      all.push_back(one);
  }
  return all;
}

Table step_table(const Report& report) {
  const Notation three{Notation::Kind::significant, 3};
  std::vector<console::Column> columns{{"law"}, {"end"}, {"in"}};
  for (const double bound : step_bounds) {
    columns.push_back({fmt::format("step, {} %", console::shortest(100 * bound)), "s", three});
    columns.push_back({"tcol/step"});
  }
  if (report.job.step) columns.push_back({"en off, asked", "%", {Notation::Kind::significant, 2}});
  columns.push_back({"Hertz time", "s", three});
  Table table(columns, "Time step that keeps en in the engines, wherever in a step the first touch falls");
  bool missed = false;
  StepAdvisor advisor;
  for (const Calibration& r : report.results) {
    const auto hertz = hertz_time_of(r.law, report.job.known.impact), asked = asked_step_error(report.job, r);
    for (const Advised& a : advised(steps_of(r, advisor))) {
      std::vector<Cell> row{law_of(r), end_of(r), a.engines};
      for (const auto& step : a.step) {
        missed = missed || !step;
        row.push_back(step ? Cell(*step) : console::blank());
        row.push_back(step ? Cell(std::int64_t{std::lround(r.request.target.tcol / *step)}) : console::blank());
      }
      if (report.job.step) row.push_back(asked ? Cell(100 * *asked) : console::blank());
      row.push_back(hertz ? Cell(*hertz) : console::blank());
      table.row(row);
    }
  }
  table.note(
      report.job.step
          ? fmt::format("--export writes the step that was asked for, {} s", console::shortest(*report.job.step))
          : fmt::format("--export writes the step for {} %{}",
                        console::shortest(100 * *std::min_element(std::begin(step_bounds), std::end(step_bounds))),
                        report.job.wall ? ", of two such grains where theirs is shorter" : ""));
  if (missed) table.note("-: more than 20000 steps a collision");
  if (const auto time = rayleigh_of(report.job))
    table.note(fmt::format("Rayleigh time of the smaller sphere: {} s", console::significant(*time, 3)));
  return table;
}

/// k_t and c_t with what a contact that sticks does by them.
Table tangential_table(const Report& report) {
  const auto all = parameters_of(report.tangential.front().found.law);
  std::vector<console::Column> columns{{"law"}, {"end"}};
  for (const Parameter& p : all) columns.push_back({std::string(p.name), p.unit(), nine});
  columns.insert(columns.end(),
                 {{"mu"}, {"beta0", "", {Notation::Kind::significant, 6}}, {"by"}, {"search", "", rough}});
  Table table(columns, fmt::format("In the tangent plane, {}: beta0 of a contact that sticks, by an oblique collision",
                                   text(report.tangential.front().found.form)));
  for (std::size_t i = 0; i < report.tangential.size(); ++i) {
    const TangentialCalibration& t = report.tangential[i].found;
    std::vector<Cell> row{law_of(report.results[i]), end_of(report.results[i])};
    for (const double value : values(t.law)) row.emplace_back(value);
    row.insert(row.end(), {t.mu ? Cell(*t.mu) : console::blank(), t.achieved, t.algorithm,
                           t.cross_difference ? Cell(*t.cross_difference) : console::blank()});
    table.row(row);
  }
  table.note("search: greatest relative difference to the parameters that NLopt finds over oblique collisions");
  for (std::size_t i = 0; i < report.tangential.size(); ++i)
    for (const auto& remark : report.tangential[i].found.remarks)
      table.note(fmt::format("{}, ended by {}: {}", law_of(report.results[i]), end_of(report.results[i]), remark));
  return table;
}

constexpr double degree = std::numbers::pi / 180;

/// One law: all that is known of its rebounds.
Table rebound_table(const Report& report) {
  Table table({{"angle", "deg", {Notation::Kind::significant, 3}},
               {"et", "", {Notation::Kind::fixed, 6}},
               {"beta", "", {Notation::Kind::fixed, 6}},
               {"rebound angle", "deg", {Notation::Kind::fixed, 4}},
               {"impulse ratio/mu", "", {Notation::Kind::fixed, 6}}},
              "Oblique impacts without spin, angles from the normal: et of the centre, beta of the contact point");
  const Tangential& t = report.tangential.front();
  for (const ObliqueRebound& r : t.rebounds)
    table.row({r.angle / degree, r.et, r.beta, r.rebound_angle / degree,
               *t.found.mu > 0 ? Cell(r.impulse_ratio / *t.found.mu) : console::blank()});
  if (std::any_of(t.rebounds.begin(), t.rebounds.end(),
                  [&](const ObliqueRebound& r) { return r.impulse_ratio > *t.found.mu * (1 + 1e-6); }))
    table.note(
        "above 1: friction goes by the repulsion, the normal impulse has the attraction before the end taken off");
  return table;
}

/// Several laws: e_t of each.
Table rebounds_table(const Report& report) {
  std::vector<console::Column> columns{{"angle", "deg", {Notation::Kind::significant, 3}}};
  for (const Calibration& r : report.results)
    columns.push_back({fmt::format("{}, {}", law_of(r), end_of(r)), "", {Notation::Kind::fixed, 6}});
  Table table(columns, "Oblique impacts without spin, angles from the normal: et of the centre");
  const auto angles = usual_angles();
  for (std::size_t i = 0; i < angles.size(); ++i) {
    std::vector<Cell> row{angles[i] / degree};
    for (const Tangential& t : report.tangential)
      row.push_back(t.rebounds.empty() ? console::blank() : Cell(t.rebounds[i].et));
    table.row(row);
  }
  return table;
}

Table infeasible_table(const Report& report) {
  Table table({{"law"}, {"end"}, {"why"}}, "Out of reach");
  for (const auto& missed : report.infeasible)
    table.row({std::string(missed.law.name()), std::string(text(missed.end)), explained(missed, Spelling::flags)});
  return table;
}

Table failure_table(const Report& report) {
  Table table({{"law"}, {"end"}, {"why"}}, "Failed");
  for (const auto& failure : report.failed)
    table.row({std::string(failure.law.name()), std::string(text(failure.end)), failure.reason});
  return table;
}

bool has_rebounds(const Report& report) {
  return std::any_of(report.tangential.begin(), report.tangential.end(),
                     [](const Tangential& t) { return !t.rebounds.empty(); });
}

}  // namespace

std::vector<Table> law_tables(const Report& report) {
  if (report.results.empty()) return {};
  return {parameter_table(report), collision_table(report)};
}

std::vector<Table> tables_of(const Report& report) {
  std::vector<Table> tables = law_tables(report);
  if (!report.tangential.empty()) {
    tables.push_back(tangential_table(report));
    if (has_rebounds(report))
      tables.push_back(report.tangential.size() == 1 ? rebound_table(report) : rebounds_table(report));
  }
  if (!report.results.empty() && !report.job.given) tables.push_back(check_table(report));
  if (const Table steps = step_table(report); !steps.rows().empty()) tables.push_back(steps);
  if (!report.infeasible.empty()) tables.push_back(infeasible_table(report));
  if (!report.failed.empty()) tables.push_back(failure_table(report));
  return tables;
}

}  // namespace ricochet::calibration
