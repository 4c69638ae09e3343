#include "curve.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace ricochet::calibration {
namespace {

using console::Cell;
using console::Column;
using console::Notation;
using console::Table;

constexpr Notation nine{Notation::Kind::significant, 9};

std::string name_of(const Curve& curve) { return std::string(curve.field->name); }

/// A percentage of the radius is given as a share. A stiffness is in the unit of each law, `own`, or in one that was
/// stated.
Column column_of(const CurveReport& report, const std::string& own) {
  const Curve& curve = *report.curve;
  if (curve.member == &Asked::overlap_share) return {name_of(curve) + "/radius", "", nine};
  return {name_of(curve), curve.member == &Asked::stiffness ? own : std::string(curve.field->unit), nine};
}

/// The unit of stiffnesses that all laws share; "" where each has its own.
std::string shared_unit(const CurveReport& report) {
  const Job& job = report.reports.front().job;
  if (job.stiffness || job.spring == Spring::linear) return "kg/s^2";
  return job.spring == Spring::hertzian ? std::string(hertzian_unit) : "";
}

Column column_of(const CurveReport& report) { return column_of(report, shared_unit(report)); }
Column column_of(const CurveReport& report, LawKind law) {
  return column_of(report, report.reports.front().job.stiffness ? "kg/s^2" : law.parameters().front().unit());
}

/// A law and end whose rows stand together: under --with and a list of --alpha the same law, of other parameters.
struct Group {
  LawKind law;
  ContactEnd end;
};

std::vector<Group> groups_of(const CurveReport& report) {
  std::vector<Group> groups;
  const auto add = [&](LawKind law, ContactEnd end) {
    if (std::none_of(groups.begin(), groups.end(), [&](const Group& g) { return g.law == law && g.end == end; }))
      groups.push_back({law, end});
  };
  for (const Report& one : report.reports)
    for (const Wanted& w : one.job.wanted) add(w.law, w.end);
  return groups;
}

std::vector<Column> columns_of(const CurveReport& report, const Group& group) {
  std::vector<Column> columns{column_of(report, group.law), {"tcol", "s", nine}};
  if (columns.front().name == "tcol") columns.pop_back();
  if (columns.front().name != "en") columns.push_back({"en", "", nine});
  for (const Parameter& p : group.law.parameters())
    if (columns.front().name != p.name) columns.push_back({std::string(p.name), p.unit(), nine});
  if (const auto& wanted = report.reports.front().job.tangential)
    for (const Parameter& p : parameters_of(wanted->form)) columns.push_back({std::string(p.name), p.unit(), nine});
  columns.push_back({"max overlap", "m"});
  columns.push_back({"max force", "N"});
  return columns;
}

/// What a law does and what it is, by the column's name.
double value_in(const std::string& column, const Calibration& r, const Tangential* tangential) {
  if (column == "tcol") return r.achieved.tcol;
  if (column == "en") return r.achieved.en;
  if (column == "k_t") return values(tangential->found.law).front();
  if (column == "c_t") return values(tangential->found.law).back();
  const auto of_law = parameters(r.law);
  return std::find_if(of_law.begin(), of_law.end(), [&](const auto& p) { return p.name == column; })->value;
}

void add_row(Table& table, double value, const Calibration& r, const Tangential* tangential) {
  std::vector<Cell> row{value};
  for (std::size_t i = 1; i + 2 < table.columns().size(); ++i)
    row.emplace_back(value_in(table.columns()[i].name, r, tangential));
  row.insert(row.end(), {r.achieved.max_overlap, r.achieved.max_force});
  table.row(row);
}

Table table_of(const CurveReport& report, const Group& group) {
  const Known& known = report.reports.front().job.known;
  std::string caption = fmt::format("{}, ended by {}", group.law.name(), text(group.end));
  if (report.curve->field->member != &Asked::velocity)
    caption += fmt::format(", at {} m/s", console::shortest(known.impact.velocity));
  Table table(columns_of(report, group), caption);
  for (std::size_t i = 0; i < report.reports.size(); ++i) {
    const double value = report.curve->values[i];
    const Report& one = report.reports[i];
    const auto same = [&](const auto& r) { return LawKind::of(r.law) == group.law && r.end == group.end; };
    const auto found = std::find_if(one.results.begin(), one.results.end(), same);
    if (found != one.results.end()) {
      const auto place = static_cast<std::size_t>(found - one.results.begin());
      add_row(table, value, *found, one.tangential.empty() ? nullptr : &one.tangential[place]);
      continue;
    }
    std::vector<Cell> row(table.columns().size(), console::blank());
    row.front() = value;
    table.row(row);
    for (const Infeasible& missed : one.infeasible)
      if (missed.law == group.law && missed.end == group.end)
        table.note(fmt::format("{} = {}: {}", name_of(*report.curve), console::shortest(value),
                               explained(missed, Spelling::flags)));
    for (const Failure& failure : one.failed)
      if (failure.law == group.law && failure.end == group.end)
        table.note(fmt::format("{} = {}: {}", name_of(*report.curve), console::shortest(value), failure.reason));
  }
  return table;
}

std::vector<Table> tables_of(const CurveReport& report) {
  std::vector<Table> tables;
  for (const Group& group : groups_of(report)) tables.push_back(table_of(report, group));
  if (tables.empty()) return tables;
  for (const std::string& assumption : report.reports.front().job.assumptions)
    tables.front().note("assumed: " + assumption);
  return tables;
}

/// The rows of all values, each with its value before it.
std::string csv_of(const CurveReport& report) {
  std::vector<Column> columns{column_of(report)};
  if (columns.front().name != "max_overlap/radius") columns.front().name = "asked " + columns.front().name;
  StepAdvisor advisor;
  const Table first = csv_of(report.reports.front(), advisor);
  columns.insert(columns.end(), first.columns().begin(), first.columns().end());
  Table table(columns);
  for (std::size_t i = 0; i < report.reports.size(); ++i) {
    const Table rows = csv_of(report.reports[i], advisor);
    for (const auto& cells : rows.rows()) {
      std::vector<Cell> row{report.curve->values[i]};
      row.insert(row.end(), cells.begin(), cells.end());
      table.row(row);
    }
  }
  return table.csv();
}

std::string json_of(const CurveReport& report) {
  console::Json out{{"schema", "ricochet/calibrations/1"}, {"varied", column_of(report).name}};
  out["values"] = report.curve->values;
  out["units"] = console::Json::object();
  if (const auto unit = column_of(report).unit; !unit.empty()) out["units"][column_of(report).name] = unit;
  out["calibrations"] = console::Json::array();
  StepAdvisor advisor;
  for (const Report& one : report.reports) out["calibrations"].push_back(document_of(one, advisor));
  return console::document(out);
}

}  // namespace

CurveReport run_curve(const Options& options) {
  CurveReport report{&*options.curve, {}};
  Options one = options;
  for (const double value : options.curve->values) {
    one.asked.*options.curve->member = value;
    report.reports.push_back(run(job_of(one), options.settings));
  }
  return report;
}

std::string render(const CurveReport& report, console::Format format) {
  if (format == console::Format::json) return json_of(report);
  if (format == console::Format::csv) return csv_of(report);
  return console::render_all(tables_of(report), format);
}

}  // namespace ricochet::calibration
