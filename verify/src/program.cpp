#include <verify/document.hpp>
#include <verify/program.hpp>
#include <verify/report.hpp>

#include <console/number.hpp>
#include <console/output.hpp>
#include <console/program.hpp>
#include <console/progress.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace ricochet::verify {

namespace {

using console::Exit;
using console::Format;
using console::Json;

struct Options {
  console::OutputOptions output;
  RunOptions run;
  std::string folder;  // figures of one study, report of all
};

Exit judged(const Study& study, const StudyResult& result) {
  if (result.gates.empty() && !result.text)
    console::complain("verify", fmt::format("{}: no gates: nothing is claimed of what was run", study.name()));
  for (const Gate& gate : result.gates)
    if (!gate.pass)
      console::complain("verify", fmt::format("{}: gate failed: {} = {}: must be {}", study.name(), gate.name,
                                              std::isfinite(gate.value) ? console::shortest(gate.value) : "not finite",
                                              bound_text(gate)));
  return all_pass(result.gates) ? Exit::done : Exit::gate_failed;
}

/// The folder of --figures or --report, if one is asked for; made before anything is computed, so that one that cannot
/// be written is told at once.
console::OutputFolder* folder_of(const Options& options, console::Together& files) {
  return options.folder.empty() ? nullptr : &files.folder(options.folder);
}

/// Of what comes into that folder, names that are known before anything is computed.
void add_known(std::vector<console::NamedFile>& outputs, const char* flag, const std::string& folder,
               const std::string& stem, std::initializer_list<const char*> endings) {
  if (folder.empty()) return;
  for (const char* const ending : endings) outputs.push_back({flag, fmt::format("{}/{}{}", folder, stem, ending)});
}

Exit run_one(Study& study, const Options& options) {
  std::vector<console::NamedFile> outputs = study.outputs();
  add_known(outputs, "--figures", options.folder, study.name(), {".json", ".csv", "-gates.csv"});
  outputs.push_back({"-o", options.output.file});
  console::require_apart(study.inputs(), outputs);
  console::Together files;
  console::OutputFolder* const folder = folder_of(options, files);
  console::Output& output = files.output(options.output.file);
  const StudyResult result = study.run(options.run);
  if (folder) write_study(study, result, *folder);
  study.write(files);
  output.write(result.text ? *result.text : study_text(study, result, options.output.format));
  files.commit();
  return judged(study, result);
}

/// Runs one study and, where there is a folder, writes it. What breaks down is told and kept in the outcome; a folder
/// that cannot be written ends all.
Outcome run_guarded(Study& study, const Options& options, console::OutputFolder* folder, Exit& worst) {
  Outcome outcome{.study = &study};
  const auto start = std::chrono::steady_clock::now();
  try {
    outcome.result = study.run(options.run);
    if (folder) outcome.pictures = write_study(study, *outcome.result, *folder);
    worst = std::max(worst, judged(study, *outcome.result));
  } catch (const console::CannotWrite&) {
    throw;
  } catch (const std::exception& error) {
    outcome.error = error.what();
    console::complain("verify", fmt::format("{}: {}", study.name(), error.what()));
    worst = std::max(worst, console::exit_code(error));
  }
  outcome.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return outcome;
}

/// "ricochet/all/1".
Json json_of_all(const std::vector<Outcome>& outcomes) {
  Json all{{"schema", "ricochet/all/1"},
           {"counts", to_json(counts_of(outcomes))},
           {"gates", Json::array()},
           {"studies", Json::array()}};
  for (const Outcome& outcome : outcomes) {
    if (!outcome.result) continue;
    for (Gate gate : outcome.result->gates) {
      gate.name = fmt::format("{}: {}", outcome.study->name(), gate.name);
      all["gates"].push_back(to_json(gate));
    }
    all["studies"].push_back(study_json(*outcome.study, *outcome.result));
  }
  return all;
}

/// "ricochet/all/1", one CSV of all cells, one JUnit document, or every study's tables one after the other.
std::string shown_all(const std::vector<Outcome>& outcomes, Format format) {
  if (format == Format::json) return console::document(json_of_all(outcomes));
  std::string text;
  console::Table cells = cell_table();
  for (const Outcome& outcome : outcomes) {
    if (!outcome.result) continue;
    const std::string name = outcome.study->name();
    if (format == Format::csv)
      add_cells(cells, name, *outcome.result);
    else if (format == Format::junit)
      text += junit_suite(name, *outcome.result);
    else
      text += (text.empty() ? "" : "\n") + study_text(*outcome.study, *outcome.result, format);
  }
  if (format == Format::csv) return cells.csv();
  return format == Format::junit ? junit_document(text) : text;
}

Exit run_all(const Studies& studies, const Options& options) {
  Exit worst = Exit::done;
  std::vector<console::NamedFile> outputs;
  add_known(outputs, "--report", options.folder, "", {"index.html", "report.json"});
  for (const auto& study : studies)
    add_known(outputs, "--report", options.folder, study->name(), {".json", ".csv", "-gates.csv"});
  outputs.push_back({"-o", options.output.file});
  console::require_apart({}, outputs);
  console::Together files;
  console::OutputFolder* const folder = folder_of(options, files);
  console::Output& output = files.output(options.output.file);
  std::vector<Outcome> outcomes;
  {
    console::Progress progress("verify", studies.size());
    for (const auto& study : studies) {
      outcomes.push_back(run_guarded(*study, options, folder, worst));
      progress.advance();
    }
  }
  if (folder) {
    const Facts made_by = facts(options.run.thorough);
    folder->add("report.json", console::document(report_json(outcomes, made_by)));
    folder->add("index.html", report_page(outcomes, made_by));
  }
  output.write(shown_all(outcomes, options.output.format));
  files.commit();
  return worst;
}

void add_common(CLI::App& app, Options& options, const std::string& folder_flag, const std::string& folder_help) {
  console::add_output_options(app, options.output, true);
  app.add_option(folder_flag, options.folder, folder_help)->type_name("DIR");
}

}  // namespace

int run_verify(const Studies& studies, const Studies& checks, int argc, const char* const* argv) {
  CLI::App app("Checks the laws, the numerics and the paper's figures against what they claim", "verify");
  console::add_version(app);
  app.require_subcommand(1);
  app.footer(
      "Every study takes --format table|json|csv|markdown|latex|junit and -o FILE; `verify STUDY --help` lists the "
      "rest.\n"
      "Exit code 0: every gate passed; 1: a gate failed; 2: bad input; 4: a study broke down.");
  Options options;
  const auto thorough = [&options](CLI::App& command) {
    command.add_flag("--thorough", options.run.thorough, "also what takes longer than a test run may");
  };
  for (const auto& study : studies) {
    CLI::App* command = app.add_subcommand(study->name(), study->claim());
    add_common(*command, options, "--figures", "also write the study with its figures into this folder");
    thorough(*command);
    study->add_options(*command);
  }
  for (const auto& check : checks) {
    CLI::App* command = app.add_subcommand(check->name(), check->claim());
    console::add_output_options(*command, options.output, true);
    check->add_options(*command);
  }
  CLI::App* all = app.add_subcommand("all", "every study, thoroughly");
  add_common(*all, options, "--report",
             "also write the report into this folder: index.html, figures, CSV and JSON files");
  bool quick = false;
  all->add_flag("--quick", quick, "leave out what takes longer than a test run may");
  return console::run_program(app, argc, argv, [&] {
    if (all->parsed()) {
      options.run.thorough = !quick;
      return run_all(studies, options);
    }
    for (const Studies* commands : {&studies, &checks})
      for (const auto& study : *commands)
        if (app.got_subcommand(study->name())) return run_one(*study, options);
    throw std::logic_error("no study chosen");
  });
}

}  // namespace ricochet::verify
