#pragma once

#include <verify/gate.hpp>

#include <console/json.hpp>
#include <console/output.hpp>
#include <console/plot.hpp>
#include <console/table.hpp>

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ricochet::verify {

struct RunOptions {
  bool thorough = false;  ///< also what takes longer than a test run may: finer meshes, more cases
};

/// A place where the paper's print and this run's numbers differ, or where the print cannot be read.
struct Remark {
  std::string about;  ///< "Eq. (57)", "Table I"
  std::string text;   ///< what stands there and what was computed, in sentences made from the numbers of this run
};

struct StudyResult {
  std::vector<Gate> gates;
  std::vector<console::Table> tables;             ///< shown in this order; CSV files of a report, unless there is:
  std::optional<console::Table> data = {};        ///< all in one long table, for CSV
  console::Json rows = nullptr;                   ///< "rows" of the JSON; null: the rows of the first table
  console::Json extra = console::Json::object();  ///< further members of the JSON's top level
  std::vector<console::Figure> figures;
  std::vector<Remark> remarks;
  std::vector<std::string> skipped = {};  ///< what could not be tried here; neither passed nor failed
  std::string verdict;                    ///< what was found, in one sentence, made from the numbers of this run
  std::optional<std::string> text = {};   ///< printed in place of all that, whatever the format: a file for others
};

/// One thing that is verified: a claim, the measurement, and the gates. A study has no physics of its own: it calls
/// the library. To add one, write verify/studies/<name>/study.cpp with `std::unique_ptr<Study> <name>_study()` and
/// name it in verify/studies.inc.
class Study {
 public:
  virtual ~Study() = default;

  /// The word on the command line and in the schema "ricochet/<name>/1".
  virtual std::string name() const = 0;
  /// What a section about it is called.
  virtual std::string title() const { return name(); }
  /// What is claimed and by whom (equation, figure or table of the paper), in one sentence.
  virtual std::string claim() const = 0;
  /// Adds the study's own options to its subcommand; they keep their defaults in `verify all`.
  virtual void add_options(CLI::App&) {}
  /// What it reads besides its own data, as the options name it.
  virtual std::vector<console::NamedFile> inputs() const { return {}; }
  virtual StudyResult run(const RunOptions& options) = 0;
  /// What its options let it write, besides its figures and its answer.
  virtual std::vector<console::NamedFile> outputs() const { return {}; }
  /// After run(): puts those outputs among the files that take their places with the answer.
  virtual void write(console::Together&) const {}
};

/// Folder of the data files: beside the sources when run from the build tree, share/ricochet/data when installed.
std::string data_folder();

}  // namespace ricochet::verify
