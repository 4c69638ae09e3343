#include <verify/document.hpp>
#include <verify/report.hpp>

#include <console/output.hpp>

#include <fmt/format.h>

namespace ricochet::verify {

namespace {

using console::Json;

std::string gate_file(const Study& study) { return study.name() + "-gates.csv"; }

/// The gates as data: an open side is empty.
console::Table gate_data(const std::vector<Gate>& gates) {
  console::Table table({{"gate"}, {"value"}, {"low"}, {"high"}, {"pass"}});
  for (const Gate& gate : gates)
    table.row({gate.name, console::number_or_blank(gate.value), console::number_or_blank(gate.low),
               console::number_or_blank(gate.high), gate.pass});
  return table;
}

Json files_of(const Outcome& outcome) {
  Json files = Json::array({outcome.study->name() + ".json"});
  files.push_back(gate_file(*outcome.study));
  for (const std::string& file : table_files(*outcome.study, *outcome.result)) files.push_back(file);
  for (std::size_t i = 0; i < outcome.pictures.size(); ++i) {
    const console::Figure& figure = outcome.result->figures[i];
    for (const char* ending : {".svg", ".png", ".pdf"}) files.push_back(figure.name + ending);
    for (const console::DataFile& data : figure.data) files.push_back(data.name);
  }
  return files;
}

}  // namespace

Counts counts_of(const std::vector<Outcome>& outcomes) {
  Counts all;
  for (const Outcome& outcome : outcomes)
    if (outcome.result) all += counts_of(*outcome.result);
  return all;
}

std::vector<std::string> table_files(const Study& study, const StudyResult& result) {
  std::vector<std::string> files{study.name() + ".csv"};
  if (result.data || result.tables.empty()) return files;
  for (std::size_t i = 1; i < result.tables.size(); ++i) files.push_back(fmt::format("{}-{}.csv", study.name(), i + 1));
  return files;
}

std::vector<console::Pictures> write_study(const Study& study, const StudyResult& result,
                                           console::OutputFolder& folder) {
  folder.add(study.name() + ".json", console::document(study_json(study, result)));
  folder.add(gate_file(study), gate_data(result.gates).csv());
  if (result.data)
    folder.add(study.name() + ".csv", result.data->csv());
  else
    for (std::size_t i = 0; i < result.tables.size(); ++i)
      folder.add(table_files(study, result)[i], result.tables[i].csv());
  std::vector<console::Pictures> pictures;
  for (const console::Figure& figure : result.figures) pictures.push_back(console::draw(figure, folder));
  return pictures;
}

Json report_json(const std::vector<Outcome>& outcomes, const Facts& made_by) {
  Json json{{"schema", "ricochet/report/1"},
            {"made_by", Json::object()},
            {"counts", to_json(counts_of(outcomes))},
            {"gates", Json::array()},
            {"studies", Json::array()}};
  for (const auto& [what, value] : made_by) json["made_by"][what] = value;
  for (const Outcome& outcome : outcomes) {
    Json study{{"name", outcome.study->name()}, {"seconds", outcome.seconds}};
    study["error"] = outcome.error.empty() ? Json(nullptr) : Json(outcome.error);
    if (outcome.result) {
      study["files"] = files_of(outcome);
      study.update(study_json(*outcome.study, *outcome.result));
      for (Gate gate : outcome.result->gates) {
        gate.name = fmt::format("{}: {}", outcome.study->name(), gate.name);
        json["gates"].push_back(to_json(gate));
      }
    }
    json["studies"].push_back(std::move(study));
  }
  return json;
}

}  // namespace ricochet::verify
