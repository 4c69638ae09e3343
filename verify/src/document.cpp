#include <verify/document.hpp>

#include <fmt/format.h>

#include <cstdint>

namespace ricochet::verify {

using console::Format;
using console::Json;

Counts counts_of(const StudyResult& result) {
  Counts counts{.skipped = result.skipped.size()};
  for (const Gate& gate : result.gates) ++(gate.pass ? counts.passed : counts.failed);
  return counts;
}

Json to_json(const Counts& counts) {
  return {{"passed", counts.passed}, {"failed", counts.failed}, {"skipped", counts.skipped}};
}

Json study_json(const Study& study, const StudyResult& result) {
  Json json{
      {"schema", fmt::format("ricochet/{}/1", study.name())}, {"claim", study.claim()}, {"verdict", result.verdict}};
  json.update(result.extra);
  json["counts"] = to_json(counts_of(result));
  json["skipped"] = result.skipped;
  json["gates"] = Json::array();
  for (const Gate& gate : result.gates) json["gates"].push_back(to_json(gate));
  if (!result.remarks.empty()) json["remarks"] = Json::array();
  for (const Remark& remark : result.remarks)
    json["remarks"].push_back({{"about", remark.about}, {"text", remark.text}});
  if (!result.rows.is_null()) {
    json["rows"] = result.rows;
    return json;
  }
  json["units"] = result.tables.empty() ? Json::object() : console::units_of(result.tables[0]);
  json["rows"] = result.tables.empty() ? Json::array() : console::rows_of(result.tables[0]);
  return json;
}

console::Table cell_table() { return console::Table({{"study"}, {"table"}, {"row"}, {"column"}, {"unit"}, {"value"}}); }

void add_cells(console::Table& cells, const std::string& study, const StudyResult& result) {
  for (const console::Table& table : result.tables)
    for (std::size_t row = 0; row < table.rows().size(); ++row)
      for (std::size_t i = 0; i < table.columns().size(); ++i) {
        const console::Column& column = table.columns()[i];
        cells.row({study, table.caption(), static_cast<std::int64_t>(row + 1), column.name, column.unit,
                   table.rows()[row][i]});
      }
}

namespace {

std::string study_csv(const Study& study, const StudyResult& result) {
  if (result.data) return result.data->csv();
  if (result.tables.size() == 1) return result.tables[0].csv();
  console::Table cells = cell_table();
  add_cells(cells, study.name(), result);
  return cells.csv();
}

}  // namespace

std::string study_text(const Study& study, const StudyResult& result, Format format) {
  if (format == Format::json) return console::document(study_json(study, result));
  if (format == Format::csv) return study_csv(study, result);
  if (format == Format::junit) return junit_document(junit_suite(study.name(), result));
  auto tables = result.tables;
  if (!result.gates.empty()) tables.push_back(gate_table(result.gates));
  std::string text = console::render_all(tables, format);
  if (format == Format::table && !result.verdict.empty())
    text += fmt::format("\n{}\n", fmt::join(console::wrapped(result.verdict), "\n"));
  else if (format != Format::latex && !result.verdict.empty())
    text += "\n" + result.verdict + "\n";
  return text;
}

}  // namespace ricochet::verify
