#pragma once

#include <verify/document.hpp>
#include <verify/study.hpp>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ricochet::console {
class OutputFolder;
}

namespace ricochet::verify {

/// Adds a study to the folder: <name>.json, <name>-gates.csv, its long table or each table in a file, and its figures
/// with their data; returns what a page shows of the figures. Throws as console::OutputFolder and console::draw do.
std::vector<console::Pictures> write_study(const Study& study, const StudyResult& result,
                                           console::OutputFolder& folder);

/// Names of a study's CSV files: "orders.csv" for its long table, else "tcol.csv", "tcol-2.csv", … for each table.
std::vector<std::string> table_files(const Study& study, const StudyResult& result);

/// One study of a run, or why there is none.
struct Outcome {
  const Study* study;
  std::optional<StudyResult> result = {};
  std::string error = {};                        ///< empty unless the study, or writing it, broke down
  std::vector<console::Pictures> pictures = {};  ///< one a figure
  double seconds = 0;
};

/// Of all studies that came to an end.
Counts counts_of(const std::vector<Outcome>& outcomes);

/// What a run was made by: names and values such as {"compiler", "g++ 12.2.0"}.
using Facts = std::vector<std::pair<std::string, std::string>>;

/// Version, time, options, compiler, libraries and gnuplot of this run.
Facts facts(bool thorough);

/// The page of all studies, which loads nothing and links the files beside it.
std::string report_page(const std::vector<Outcome>& outcomes, const Facts& made_by);

/// "ricochet/report/1": the facts, every gate, and each study as study_json gives it, with its error and files.
console::Json report_json(const std::vector<Outcome>& outcomes, const Facts& made_by);

}  // namespace ricochet::verify
