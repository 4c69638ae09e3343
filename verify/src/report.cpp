#include <verify/document.hpp>
#include <verify/report.hpp>

#include <console/output.hpp>

#include <fmt/format.h>

namespace ricochet::verify {

namespace {

using console::Json;

Json files_of(const Outcome& outcome) {
  Json files = Json::array({outcome.study->name() + ".json"});
  for (std::size_t i = 0; i < outcome.result->tables.size(); ++i) files.push_back(table_file(*outcome.study, i));
  for (std::size_t i = 0; i < outcome.pictures.size(); ++i) {
    const console::Figure& figure = outcome.result->figures[i];
    for (const char* ending : {".svg", ".png"}) files.push_back(figure.name + ending);
    for (const console::DataFile& data : figure.data) files.push_back(data.name);
  }
  return files;
}

}  // namespace

std::string table_file(const Study& study, std::size_t table) {
  return table ? fmt::format("{}-{}.csv", study.name(), table + 1) : study.name() + ".csv";
}

std::vector<std::string> write_study(const Study& study, const StudyResult& result, console::OutputFolder& folder) {
  folder.add(study.name() + ".json", console::document(study_json(study, result)));
  for (std::size_t i = 0; i < result.tables.size(); ++i) folder.add(table_file(study, i), result.tables[i].csv());
  std::vector<std::string> pictures;
  for (const console::Figure& figure : result.figures) pictures.push_back(console::draw(figure, folder));
  return pictures;
}

Json report_json(const std::vector<Outcome>& outcomes, const Facts& made_by) {
  Json json{{"schema", "ricochet/report/1"},
            {"made_by", Json::object()},
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
