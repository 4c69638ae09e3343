#pragma once

#include "job.hpp"

#include <calibrate/advice.hpp>
#include <calibrate/export.hpp>
#include <console/json.hpp>
#include <console/table.hpp>

#include <string>
#include <vector>

namespace ricochet::calibration {

/// A law whose computation failed.
struct Failure {
  LawKind law;
  ContactEnd end;
  std::string reason;
};

/// A tangential law beside a normal one, and what both do to oblique impacts, where the friction is known.
struct Tangential {
  TangentialCalibration found;
  std::vector<ObliqueRebound> rebounds = {};
};

/// Everything that the program has to tell about one job.
struct Report {
  Job job;
  std::vector<Calibration> results;
  std::vector<Infeasible> infeasible;
  std::vector<Failure> failed = {};
  std::vector<Tangential> tangential = {};  ///< one a result, where the job asks for it
};

/// One law's failure leaves the others' results as they are.
Report run(const Job& job, const Settings& settings);

/// Rayleigh's time of the smaller sphere [s], where its moduli, density and radius are known.
std::optional<double> rayleigh_of(const Job& job);

/// "--en = 0.01: must be in [0.2, 1]<under>: <why>"
std::string explained(const Infeasible& missed, Spelling spelling, const std::string& under = {});

/// One law found in the language of `engine`; nothing where the contact of two grains, which engines want to know too,
/// reaches no such law.
std::optional<Snippet> snippet_of(const Report& report, std::size_t result, Engine engine);
/// Why the engine is not given the law of a snippet that is absent: "MFiX has no plastic loading and unloading".
std::string why_absent(const Snippet& snippet);
/// Snippets as one file or as JSON. Throws console::BadInput for another format, console::Unreachable where the engine
/// can be given none of them.
std::string exported(const std::vector<Snippet>& snippets, Engine engine, console::Format format);
/// Those of a report, which also says what it did not find. Throws as above.
std::string exported(const Report& report, const std::string& engine, console::Format format);

/// The engines' time steps for it; none for a contact that gains energy (α < 0), which no engine runs.
std::vector<EngineStep> steps_of(const Calibration& calibration, StepAdvisor& advisor);

/// How far off e_n is with the time step that the job asks for, relative; nothing where it asks for none or the contact
/// then does not end.
std::optional<double> asked_step_error(const Job& job, const Calibration& calibration);

/// For people: parameters and collisions.
std::vector<console::Table> law_tables(const Report& report);
/// The same with checks, time steps and what was out of reach.
std::vector<console::Table> tables_of(const Report& report);
/// For spreadsheets: one row a law and end.
console::Table csv_of(const Report& report);
/// The same of one of many.
console::Table csv_of(const Report& report, StepAdvisor& advisor);
/// "ricochet/calibration/1".
console::Json document_of(const Report& report);
/// The same of one of many.
console::Json document_of(const Report& report, StepAdvisor& advisor);
std::string json_of(const Report& report);

/// What a page begins with.
struct PageStart {
  std::string command;       ///< that makes it
  std::string heading = {};  ///< without: by what was asked for
  std::string figure = {};   ///< HTML; without: the collision
  std::string section = {};  ///< HTML ahead of the parameters
};

/// The same and more as one page that loads nothing: the collision, the engines' input, sensitivity, time steps.
std::string page_of(const Report& report, const PageStart& start);

std::string render(const Report& report, console::Format format);

}  // namespace ricochet::calibration
