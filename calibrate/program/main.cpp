#include "fit_report.hpp"
#include "materials.hpp"
#include "report.hpp"
#include "targets.hpp"

#include <console/exit.hpp>
#include <console/output.hpp>
#include <console/signals.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <optional>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

std::string lone_failure(const Infeasible& missed) {
  return fmt::format("--law {} --end {}: {}", missed.law.name(), text(missed.end), explained(missed));
}

console::Exit work(Options& options) {
  if (!options.materials.empty()) return run_materials(options);
  if (!options.fit.empty()) return run_fit(options);
  if (options.alpha_of_speed || !options.figures.empty())
    throw console::BadInput("--alpha-of-speed and --figures: must be left out without --fit");
  if (!options.targets.empty()) return run_targets(options);
  if (options.threads)
    throw console::BadInput("--threads", fmt::format_int(*options.threads).str(), "left out without --targets");
  if (options.law.empty()) options.law = "all";
  options.settings.method = options.method == "direct" ? Method::direct : Method::nlopt;
  const Report report = run(job_of(options), options.settings);
  // Both are whole before either takes its place.
  std::optional<console::AtomicFile> page;
  if (!options.page.empty()) page.emplace(options.page).write(page_of(report));
  console::Output output(options.output.file);
  output.write(options.engine.empty() ? render(report, options.output.format)
                                      : exported(report, options.engine, options.output.format));
  const console::SignalsHeld held;
  if (page) page->commit();
  output.commit();
  // Other laws that did reach the target answer the question; only a lone law that cannot is an error.
  if (report.results.empty() && !report.failed.empty()) throw console::Failed(report.failed.front().reason);
  if (report.results.empty()) throw console::Unreachable(lone_failure(report.infeasible.front()));
  return console::Exit::done;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Finds the parameters of contact laws for a collision time and a restitution", "calibrate");
  console::add_version(app);
  Options options;
  add_options(app, options);
  app.footer(
      "Exit code 0: done; 1: a row of --targets failed; 2: bad input; 3: the law cannot reach the target; 4: the "
      "computation, or writing its result, failed.");
  return console::run_program(app, argc, argv, [&] {
    for (const CLI::Option* option : app.get_options())
      if (option->count() > 0) options.given.push_back(option->get_name());
    return work(options);
  });
}
