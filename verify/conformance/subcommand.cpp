#include "badge.hpp"
#include "case_json.hpp"
#include "causes.hpp"
#include "page.hpp"
#include "ricochet_run.hpp"
#include "show.hpp"

#include <verify/conformance.hpp>
#include <verify/report.hpp>

#include <console/exit.hpp>
#include <console/output.hpp>
#include <console/program.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

namespace ricochet::verify {

namespace {

using namespace conformance;
namespace fs = std::filesystem;
using console::Table;

/// The greatest error that an answer may have, as a share of its scale: what engines are off by at 100 steps is to be
/// told from it.
constexpr double well_known = 5e-3;

Table list_of(const std::vector<Case>& cases) {
  Table table({{"case"}, {"family"}, {"title"}, {"source"}}, "Cases of contact models");
  for (const Case& c : cases) table.row({c.name, c.family, c.title, c.source});
  return table;
}

Gate answers_are_known(const std::vector<Case>& cases) {
  double worst = 0;
  for (const Case& c : cases)
    for (const Answer& a : answers(c)) worst = std::max(worst, a.error / a.scale);
  return at_most("error of an answer, share of its scale", worst, well_known);
}

/// A file itself, or the CSV files of a folder, by name.
std::vector<std::string> files_of(const std::string& path) {
  if (!fs::is_directory(path)) return {path};
  std::vector<std::string> files;
  for (const auto& entry : fs::directory_iterator(path))
    if (entry.path().extension() == ".csv") files.push_back(entry.path().string());
  std::sort(files.begin(), files.end());
  if (files.empty()) throw console::BadInput("--results", path, "a results file or a folder with some");
  return files;
}

EngineGrade graded(const std::string& file, const std::vector<Answered>& all, const std::vector<Case>& cases) {
  EngineGrade engine{read_results(file, cases), {}};
  for (const Answered& one : all) engine.cases.push_back(explained(one, engine.results.find(one.of.name)));
  return engine;
}

/// The engine broke down, in some of the runs or in all.
bool tells_of_failure(std::string note) {
  std::transform(note.begin(), note.end(), note.begin(), [](unsigned char c) { return std::tolower(c); });
  return note.starts_with("failed");
}

/// Right is what converges to the answer or is exact; what was not run is neither.
void add_gates(StudyResult& result, const EngineGrade& engine) {
  result.gates.push_back(
      at_least(label(engine.results) + ": cases that could be graded", static_cast<double>(engine.run()), 1));
  for (const CaseGrade& c : engine.cases) {
    const std::string name = fmt::format("{}: {}", label(engine.results), c.of->name);
    const bool failed = tells_of_failure(c.note);
    if (failed) result.gates.push_back(holds(fmt::format("{}: runs ({})", name, c.note), false));
    if (c.verdict == Verdict::too_coarse)
      result.skipped.push_back(name + " (steps too coarse to tell)");
    else if (c.verdict == Verdict::not_run) {
      if (!failed) result.skipped.push_back(fmt::format("{} ({})", name, c.note));
    } else if (c.verdict == Verdict::does_not_converge)
      result.gates.push_back(holds(name + ": converges", false));
    else if (c.by_repetition)
      result.gates.push_back(at_most(name + ": off steps of what was asked, repeated here, share of scale",
                                     c.causes.front().misfit, repeated_to));
    else
      result.gates.push_back(at_most(name + ": |limit|, share of scale", std::abs(c.worst()->limit.value),
                                     c.worst()->limit.uncertainty + c.worst()->floor));
  }
}

class Conformance : public Study {
 public:
  std::string name() const override { return "conformance"; }
  std::string claim() const override {
    return "Engines give what the contact models give that they are asked for, in cases with exact answers";
  }
  std::vector<console::NamedFile> inputs() const override {
    std::vector<console::NamedFile> all;
    for (const std::string& path : results_)
      for (const std::string& file : files_of(path)) all.push_back({"--results", file});
    return all;
  }
  std::vector<console::NamedFile> outputs() const override { return {{"--report", page_}}; }
  void add_options(CLI::App& app) override {
    app.add_flag("--list", list_, "the cases");
    app.add_option("--cases", cases_folder_, "write each case as DIR/<case>.json, for engines to run")
        ->type_name("DIR");
    app.add_option("--results", results_,
                   "what engines gave: files or folders of them, each case a gate; without: those that we measured, "
                   "data/conformance, side by side")
        ->type_name("FILE.csv|DIR");
    app.add_option("--run", run_, "run all cases by this engine and print its results file")
        ->check(CLI::IsMember({"ricochet"}));
    app.add_option("--report", page_, "also write the page of all engines into this file")->type_name("FILE.html");
    app.add_option("--badge", badges_, "also write a badge of each engine into this folder")->type_name("DIR");
  }
  StudyResult run(const RunOptions&) override {
    check();
    const std::vector<Case> cases = all_cases();
    if (!run_.empty()) {
      StudyResult result;
      result.text = results_text(run_ricochet(cases));
      return result;
    }
    if (list_ || !cases_folder_.empty()) return listed(cases);
    return compared(cases);
  }
  void write(console::Together& files) const override {
    for (const auto& [path, made] : {std::pair(&cases_folder_, &case_files_), std::pair(&badges_, &badge_files_)}) {
      if (path->empty()) continue;
      console::OutputFolder& folder = files.folder(*path);
      for (const console::DataFile& file : *made) folder.add(file.name, file.bytes);
    }
    if (!page_.empty()) files.file(page_).write(page_text_);
  }

 private:
  /// Nothing that is asked for is passed over.
  void check() const {
    const bool lists = list_ || !cases_folder_.empty(),
               grades = !results_.empty() || !page_.empty() || !badges_.empty();
    if (!run_.empty() && (lists || grades)) throw console::BadInput("--run", run_, "given without other tasks");
    if (lists && grades)
      throw console::BadInput("--list, --cases: must be given without --results, --report and --badge");
  }

  StudyResult listed(const std::vector<Case>& cases) {
    StudyResult result;
    result.tables = {list_of(cases)};
    result.gates = {answers_are_known(cases)};
    result.verdict = fmt::format("{} cases.", cases.size());
    for (const Case& c : cases) case_files_.push_back({c.name + ".json", console::document(to_json(c))});
    return result;
  }

  StudyResult compared(const std::vector<Case>& cases) {
    const std::vector<Answered> all = answered(cases);
    const bool ours = results_.empty();
    std::vector<console::NamedFile> files;
    for (const std::string& path : ours ? std::vector{data_folder() + "/conformance"} : results_)
      for (const std::string& file : files_of(path)) files.push_back({"--results", file});
    console::require_apart(files, std::vector<console::NamedFile>{{"--report", page_}});
    std::vector<EngineGrade> engines;
    engines.reserve(files.size());
    for (const console::NamedFile& file : files) engines.push_back(graded(file.path, all, cases));
    StudyResult result;
    result.gates = {answers_are_known(cases)};
    result.rows = console::Json::array();
    std::size_t runs = 0, right = 0;
    for (const EngineGrade& e : engines) {
      // The engines of others are measured here, not judged.
      if (!ours) add_gates(result, e);
      result.rows.push_back(to_json(e));
      runs += e.run(), right += e.right();
    }
    result.tables = {engine_table(engines), side_by_side(engines), cause_table(engines)};
    result.data = grade_table(engines);
    result.verdict = fmt::format("{} engine{}, {} cases; {} of {} that were run converge to the answer.",
                                 engines.size(), engines.size() == 1 ? "" : "s", cases.size(), right, runs);
    if (!badges_.empty()) badge_files_ = badges_of(engines);
    if (!page_.empty()) page_text_ = conformance_page(engines, facts(true));
    return result;
  }

  static std::vector<console::DataFile> badges_of(const std::vector<EngineGrade>& engines) {
    std::vector<console::DataFile> files;
    std::set<std::string> names;
    for (const EngineGrade& e : engines) {
      const std::string stem = file_stem(e.results);
      if (stem.empty() || !names.insert(stem).second)
        throw console::BadInput("--badge", label(e.results),
                                "an engine and version whose letters and digits name it alone");
      files.push_back({stem + ".svg", badge(e)});
    }
    return files;
  }

  bool list_ = false;
  std::string cases_folder_, run_, page_, badges_;
  std::vector<std::string> results_;
  std::vector<console::DataFile> case_files_, badge_files_;
  std::string page_text_;
};

}  // namespace

std::unique_ptr<Study> conformance_check() { return std::make_unique<Conformance>(); }

}  // namespace ricochet::verify
