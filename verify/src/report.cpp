#include <verify/program.hpp>
#include <verify/report.hpp>

#include <console/exit.hpp>
#include <console/output.hpp>

#include <filesystem>
#include <system_error>

namespace ricochet::verify {

void write_study(const Study& study, const StudyResult& result, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw console::BadInput(folder + ": cannot make the folder: " + error.message());
  const std::string stem = folder + "/" + study.name();
  console::write_atomically(stem + ".json", console::document(study_json(study, result)));
  for (std::size_t i = 0; i < result.tables.size(); ++i) {
    const std::string number = i ? "-" + std::to_string(i + 1) : "";
    console::write_atomically(stem + number + ".csv", result.tables[i].csv());
  }
  for (const console::Figure& figure : result.figures) console::draw(figure, folder);
}

}  // namespace ricochet::verify
