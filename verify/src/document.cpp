#include <verify/document.hpp>

#include <fmt/format.h>

namespace ricochet::verify {

using console::Format;
using console::Json;

Json study_json(const Study& study, const StudyResult& result) {
  Json json{
      {"schema", fmt::format("ricochet/{}/1", study.name())}, {"claim", study.claim()}, {"verdict", result.verdict}};
  json.update(result.extra);
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

std::string study_text(const Study& study, const StudyResult& result, Format format) {
  if (format == Format::json) return console::document(study_json(study, result));
  auto tables = result.tables;
  // CSV is for the data; whoever wants the gates in a machine's hands takes the JSON.
  if (format != Format::csv) tables.push_back(gate_table(result.gates));
  std::string text = console::render_all(tables, format);
  if (format != Format::csv && !result.verdict.empty()) text += "\n" + result.verdict + "\n";
  return text;
}

}  // namespace ricochet::verify
