#include "job.hpp"

#include <console/number.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace ricochet::calibration {
namespace {

/// An option that takes one of `names`; a message names flag, value and choices.
void add_choice(CLI::App& app, const std::string& flag, std::string& target, const std::vector<std::string>& names,
                const std::string& description) {
  const std::string list = fmt::format("{}", fmt::join(names, ", "));
  const auto read = [&target, flag, list, names](const std::string& value) {
    if (std::find(names.begin(), names.end(), value) == names.end())
      throw CLI::ValidationError(fmt::format("{} = {}: must be one of {}", flag, value, list));
    target = value;
  };
  app.add_option_function<std::string>(flag, read, fmt::format("{}: {}", description, list))->type_name("NAME");
}

/// The headings of --help, in its order.
void group_options(CLI::App& app) {
  const std::pair<const char*, std::vector<const char*>> groups[] = {
      {"Target", {"--tcol", "--en", "--law", "--end", "--stiffness"}},
      {"Impact", {"--velocity", "--mass-eff", "--radius", "--density", "--radius2", "--density2", "--wall"}},
      {"Method", {"--method", "--algorithm", "--tolerance"}},
      {"Many targets and measured data",
       {"--targets", "--threads", "--fit", "--alpha-of-speed", "--figures", "--materials"}},
      {"Output", {"--export", "--report", "--format", "--output"}}};
  for (const auto& [heading, flags] : groups)
    for (const char* flag : flags) app.get_option(flag)->group(heading);
}

}  // namespace

void add_options(CLI::App& app, Options& o) {
  using console::add_number;
  add_number(app, "--tcol", o.tcol, "collision time to reach [s]");
  add_number(app, "--en", o.en, "restitution to reach, in (0, 1]");
  std::vector<std::string> laws{"all"};
  laws.insert(laws.end(), Laws::names.begin(), Laws::names.end());
  add_choice(app, "--law", o.law, laws, "law to calibrate (default all)");
  add_choice(app, "--end", o.end, {"overlap", "force", "both"},
             "what ends the contact (default both for linear, force for the others)");
  add_number(app, "--velocity", o.velocity, "impact velocity [m/s] (default 0.5)");
  add_number(app, "--mass-eff", o.mass_eff, "effective mass m1 m2/(m1+m2) [kg] (default 7.06858e-6)");
  add_number(app, "--radius", o.radius, "radius of the sphere [m], with --density instead of --mass-eff");
  add_number(app, "--density", o.density, "density of the sphere [kg/m^3]");
  add_number(app, "--radius2", o.radius2, "radius of the other sphere [m] (default --radius)");
  add_number(app, "--density2", o.density2, "density of the other sphere [kg/m^3] (default --density)");
  app.add_flag("--wall", o.wall, "the sphere hits a wall instead of another sphere");
  add_number(app, "--stiffness", o.stiffness, "k that the fractional law holds [kg/s^2] (default linear's, by force)");
  add_choice(app, "--method", o.method, {"nlopt", "direct"},
             "method of the answer (default nlopt); the other one cross-checks it");
  add_choice(app, "--algorithm", o.settings.algorithm, algorithms(), "NLopt's algorithm (default LN_BOBYQA)");
  add_number(app, "--tolerance", o.settings.tolerance, "relative, in tcol and en (default 1e-10)");
  app.add_option("--targets", o.targets,
                 "calibrate every row of a CSV file instead: columns tcol, en and any of velocity, mass_eff, law, end, "
                 "stiffness; directly, on all cores; - is standard input")
      ->type_name("FILE");
  const auto read_threads = [&o](const std::string& value) {
    const auto number = console::parse_number(value);
    if (!number || *number < 1 || *number > 1024 || *number != std::floor(*number))
      throw CLI::ValidationError(fmt::format("--threads = {}: must be a whole number from 1 to 1024", value));
    o.threads = static_cast<unsigned>(*number);
  };
  app.add_option_function<std::string>("--threads", read_threads, "threads of --targets (default: all cores)")
      ->type_name("NUMBER");
  app.add_option("--fit", o.fit,
                 "fit the laws to a CSV file of measurements instead: columns velocity, en and any of en_sigma, tcol, "
                 "tcol_sigma")
      ->type_name("FILE");
  app.add_flag("--alpha-of-speed", o.alpha_of_speed,
               "with --fit: the fractional law also with an alpha that follows the speed");
  app.add_option("--figures", o.figures, "with --fit: also draw measurements, fits and residuals into this folder")
      ->type_name("DIR");
  app.add_option(
         "--materials", o.materials,
         "calibrate every pair of a JSON file of materials, grains and walls, instead; with --export an engine's "
         "whole contact block")
      ->type_name("FILE");
  add_choice(app, "--export", o.engine, {"liggghts", "lammps", "yade", "mercurydpm", "mfix"},
             "write the laws in an engine's own language instead");
  app.add_option("--report", o.page, "also write a page with curves, sensitivities, time steps and export snippets")
      ->type_name("FILE.html");
  console::add_output_options(app, o.output);
  group_options(app);
}

}  // namespace ricochet::calibration
