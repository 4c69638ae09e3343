#include "curve.hpp"
#include "fit_report.hpp"
#include "materials.hpp"
#include "oblique_fit_run.hpp"
#include "report.hpp"
#include "targets.hpp"

#include <console/exit.hpp>
#include <console/output.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

using namespace ricochet;
using namespace ricochet::calibration;

namespace {

std::string lone_failure(const Infeasible& missed) {
  const std::string law = fmt::format("--law {} --end {}", missed.law.name(), text(missed.end));
  return missed.quantity.empty() ? fmt::format("{}: {}", law, missed.reason)
                                 : explained(missed, Spelling::flags, " with " + law);
}

/// What no law reaches is an error; where other laws did reach it, that answers the question.
void require_results(const std::vector<Report>& reports) {
  if (std::any_of(reports.begin(), reports.end(), [](const Report& r) { return !r.results.empty(); })) return;
  const Report& first = reports.front();
  if (!first.failed.empty()) throw console::Failed(first.failed.front().reason);
  throw console::Unreachable(lone_failure(first.infeasible.front()));
}

console::Exit draw_curve(const Options& options) {
  for (const auto& [flag, text] : {std::pair("--export", options.engine), std::pair("--report", options.page)})
    if (!text.empty())
      throw console::BadInput(fmt::format("{}: must be left out with a list in {}", flag, options.curve->flag));
  const CurveReport report = run_curve(options);
  console::Output output(options.output.file);
  output.write(render(report, options.output.format));
  output.commit();
  require_results(report.reports);
  return console::Exit::done;
}

console::Exit work(Options& options) {
  console::require_apart(
      std::vector<console::NamedFile>{
          {"--targets", options.targets}, {"--fit", options.fit}, {"--materials", options.materials}},
      std::vector<console::NamedFile>{{"-o", options.output.file}, {"--report", options.page}});
  if (!options.materials.empty()) return run_materials(options);
  if (options.curve && !(options.fit.empty() && options.targets.empty()))
    throw console::BadInput(fmt::format("{}: must be one number with {}", options.curve->flag,
                                        options.fit.empty() ? "--targets" : "--fit"));
  if (options.fit == "-" && (options.asked.en || options.asked.form))
    throw console::BadInput("--fit", "-", "a file for oblique impacts, which --en and --tangential speak of");
  if (!options.fit.empty()) return is_oblique(options.fit) ? run_oblique_fit(options) : run_fit(options);
  if (options.alpha_of_speed || !options.figures.empty())
    throw console::BadInput("--alpha-of-speed and --figures: must be left out without --fit");
  if (!options.targets.empty()) return run_targets(options);
  if (options.threads)
    throw console::BadInput("--threads", fmt::format_int(*options.threads).str(), "left out without --targets");
  if (options.law.empty()) options.law = "all";
  options.settings.method = options.method == "direct" ? Method::direct : Method::nlopt;
  if (options.curve) return draw_curve(options);
  const Job job = job_of(options);
  if (job.tangential && !job.tangential->mu && !options.engine.empty())
    throw console::BadInput("--mu: missing: must be given, a coefficient of friction, with --export and --beta0");
  const Report report = run(job, options.settings);
  console::Together files;
  if (!options.page.empty()) files.file(options.page).write(page_of(report, {.command = options.command}));
  files.output(options.output.file)
      .write(options.engine.empty() ? render(report, options.output.format)
                                    : exported(report, options.engine, options.output.format));
  files.commit();
  require_results({report});
  return console::Exit::done;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Finds the parameters of contact laws from one scale and one loss, or what given parameters do",
               "calibrate");
  console::add_version(app);
  Options options;
  add_options(app, options);
  app.footer(
      "Exit code 0: done; 1: a row of --targets failed; 2: bad input; 3: the law cannot reach the target; 4: the "
      "computation, or writing its result, failed.");
  options.command = console::typed(app.get_name(), argc, argv);
  return console::run_program(app, argc, argv, [&] {
    for (const CLI::Option* option : app.get_options())
      if (option->count() > 0) options.given.push_back(option->get_name());
    return work(options);
  });
}
