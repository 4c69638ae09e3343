#include "report.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::calibration {
namespace {

using console::Cell;
using console::Column;

/// Every parameter of every law under its own name and unit, so that a column never mixes units.
const std::vector<Column>& parameter_columns() {
  static const std::vector<Column> columns = [] {
    std::vector<Column> all;
    for (const LawKind kind : LawKind::all())
      for (const Parameter& p : kind.parameters()) {
        const auto same = [&](const Column& c) { return c.name == p.name && c.unit == p.unit(); };
        if (std::none_of(all.begin(), all.end(), same)) all.push_back({std::string(p.name), p.unit()});
      }
    return all;
  }();
  return columns;
}

Cell parameter_cell(const AnyLaw& law, const Column& column) {
  for (const auto& p : parameters(law))
    if (p.name == column.name && p.unit == column.unit) return p.value;
  return console::blank();
}

/// "timestep_1% [s]", …: what keeps e_n in every engine that runs the law so, which all step it alike.
std::vector<Column> step_columns() {
  std::vector<Column> all;
  for (const double bound : step_bounds)
    all.push_back({fmt::format("timestep_{}%", console::shortest(100 * bound)), "s"});
  return all;
}

/// The least over the engines; nothing where one has none, or no engine runs the law.
std::vector<Cell> step_cells(const std::vector<EngineStep>& steps) {
  std::vector<Cell> cells;
  for (const double bound : step_bounds) {
    std::optional<double> least;
    bool all = true;
    for (const EngineStep& s : steps) {
      if (s.error_en != bound) continue;
      all = all && s.step;
      if (s.step) least = std::min(least.value_or(*s.step), *s.step);
    }
    cells.push_back(all && least ? Cell(*least) : console::blank());
  }
  return cells;
}

std::vector<Cell> row_of(const Calibration& r, bool given, StepAdvisor& advisor) {
  const std::string remarks = r.remarks.empty() ? "" : fmt::format("; {}", fmt::join(r.remarks, "; "));
  std::vector<Cell> row{std::string(name(r.law)), std::string(text(r.end)), (given ? "given" : "calibrated") + remarks};
  for (const auto& column : parameter_columns()) row.push_back(parameter_cell(r.law, column));
  const auto searched = [&](const Cell& cell) { return given ? console::blank() : cell; };
  row.insert(row.end(), {r.achieved.tcol, r.achieved.en, searched(r.tcol_residual), searched(r.en_residual),
                         r.achieved.max_overlap, r.achieved.max_force, r.achieved.overlap_end,
                         r.tcol_estimate ? Cell(*r.tcol_estimate) : console::blank(),
                         searched(static_cast<std::int64_t>(r.evaluations)), searched(std::string(text(r.method))),
                         searched(r.algorithm), searched(r.cross_difference)});
  for (const Cell& cell : step_cells(steps_of(r, advisor))) row.push_back(cell);
  return row;
}

/// Every parameter of the tangential law under its own name and unit, with β₀ and μ.
std::vector<Column> tangential_columns(const Job& job) {
  std::vector<Column> all;
  for (const Parameter& p : parameters_of(job.tangential->form)) all.push_back({std::string(p.name), p.unit()});
  all.insert(all.end(), {{"beta0"}, {"mu"}});
  return all;
}

std::vector<Cell> tangential_cells(const TangentialCalibration& t) {
  std::vector<Cell> cells;
  for (const double value : values(t.law)) cells.emplace_back(value);
  cells.insert(cells.end(), {t.beta0, t.mu ? Cell(*t.mu) : console::blank()});
  return cells;
}

}  // namespace

console::Table csv_of(const Report& report) {
  StepAdvisor advisor;
  return csv_of(report, advisor);
}

console::Table csv_of(const Report& report, StepAdvisor& advisor) {
  std::vector<Column> columns{{"law"}, {"end"}, {"status"}};
  columns.insert(columns.end(), parameter_columns().begin(), parameter_columns().end());
  columns.insert(columns.end(), {{"tcol", "s"},
                                 {"en"},
                                 {"tcol_residual"},
                                 {"en_residual"},
                                 {"max_overlap", "m"},
                                 {"max_force", "N"},
                                 {"overlap_end", "m"},
                                 {"tcol_estimate", "s"},
                                 {"evaluations"},
                                 {"method"},
                                 {"algorithm"},
                                 {"cross_check_difference"}});
  for (const Column& column : step_columns()) columns.push_back(column);
  if (report.job.tangential)
    for (const Column& column : tangential_columns(report.job)) columns.push_back(column);
  console::Table table(columns);
  for (std::size_t i = 0; i < report.results.size(); ++i) {
    auto row = row_of(report.results[i], report.job.given.has_value(), advisor);
    if (report.job.tangential)
      for (const Cell& cell : tangential_cells(report.tangential[i].found)) row.push_back(cell);
    table.row(row);
  }
  const auto without_result = [&](LawKind law, ContactEnd end, const std::string& status) {
    std::vector<Cell> row(columns.size(), console::blank());
    row[0] = std::string(law.name());
    row[1] = std::string(text(end));
    row[2] = status;
    table.row(row);
  };
  for (const auto& missed : report.infeasible)
    without_result(missed.law, missed.end, "infeasible: " + explained(missed, Spelling::flags));
  for (const auto& failure : report.failed) without_result(failure.law, failure.end, "failed: " + failure.reason);
  return table;
}

}  // namespace ricochet::calibration
