#include "job.hpp"

#include <console/quantity.hpp>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
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

/// One number goes to its place; a list becomes the one curve that a command draws.
void take_values(Options& o, const Field& field, std::optional<double> Asked::*member, const std::string& flag,
                 const std::vector<double>& values) {
  if (values.size() == 1) {
    o.asked.*member = values.front();
    return;
  }
  if (!field.curve) throw std::invalid_argument("one number");
  if (o.curve) throw std::invalid_argument(fmt::format("one number with a list in {}", o.curve->flag));
  o.curve = Curve{flag, &field, member, values};
}

/// The numbers of one flag to their place.
void read_field(Options& o, const Field& field, const std::string& flag, const std::string& text) {
  if (field.member == &Asked::stiffness) {
    const auto [values, spring] = parse_stiffnesses(text);
    o.asked.spring = spring;
    take_values(o, field, field.member, flag, values);
    return;
  }
  const bool share = field.member == &Asked::max_overlap && text.ends_with('%');
  take_values(o, field, share ? &Asked::overlap_share : field.member, flag,
              console::parse_quantities(text, share ? "" : field.read_in()));
}

void add_field(CLI::App& app, Options& o, const Field& field) {
  const std::string flag = spelled(Spelling::flags, field.name);
  const auto read = [&o, &field, flag](const std::string& text) {
    try {
      read_field(o, field, flag, text);
    } catch (const std::invalid_argument& error) {
      throw CLI::ValidationError(fmt::format("{} = {}: must be {}", flag, text, error.what()));
    }
  };
  const bool own = field.unit.empty() || field.member == &Asked::stiffness;
  const std::string unit = own ? "" : fmt::format(" [{}]", field.unit);
  const std::string names = field.member == &Asked::beta0 ? flag + ",--et" : flag;
  app.add_option_function<std::string>(names, read, fmt::format("{}{}", field.meaning, unit))
      ->type_name(field.curve ? "NUMBER(S)" : "NUMBER");
}

void add_match(CLI::App& app, Options& o) {
  const auto read = [&o](const std::string& value) {
    if (value != "time" && value != "overlap")
      throw CLI::ValidationError(fmt::format("--match = {}: must be time or overlap", value));
    o.asked.match = value == "time" ? LinearMatch::time : LinearMatch::overlap;
  };
  app.add_option_function<std::string>(
         "--match", read, "what a linear spring shares with Hertz's of --young, undamped: time (default), overlap")
      ->type_name("NAME");
}

void add_tangential(CLI::App& app, Options& o) {
  const auto read = [&o](const std::string& value) {
    o.asked.form = tangential_form(value);
    if (!o.asked.form)
      throw CLI::ValidationError(fmt::format("--tangential = {}: must be linear, linear-undamped or mindlin", value));
  };
  app.add_option_function<std::string>(
         "--tangential", read,
         "spring in the tangent plane: linear (default, with a dashpot), linear-undamped, "
         "mindlin (k_t by --young and --poisson, else by --beta0)")
      ->type_name("NAME");
}

void add_load(CLI::App& app, Options& o) {
  const auto read = [&o](const std::string& value) {
    o.load = console::parse_quantity(value, "N");
    if (!o.load || !(*o.load > 0 && *o.load >= least_scale && *o.load <= greatest_scale))
      throw CLI::ValidationError(fmt::format("--load = {}: must be a force [N], {}", value, range_of_scales));
  };
  app.add_option_function<std::string>("--load", read,
                                       "constant load that presses the bodies together, such as a weight [N]; with "
                                       "--tcol and --en, or --with")
      ->type_name("NUMBER");
}

/// The headings of --help, in its order.
void group_options(CLI::App& app) {
  const auto of_topic = [&](Topic topic, const char* heading) {
    for (const Field& f : fields)
      if (f.topic == topic) app.get_option(spelled(Spelling::flags, f.name))->group(heading);
  };
  of_topic(Topic::scale, "Scale, one of: --tcol, --stiffness, --young, --max-overlap, --timestep");
  app.get_option("--match")->group("Scale, one of: --tcol, --stiffness, --young, --max-overlap, --timestep");
  of_topic(Topic::loss, "Loss, one of");
  of_topic(Topic::held, "Loss, one of");
  of_topic(Topic::impact, "Impact");
  of_topic(Topic::tangential, "Tangential");
  const std::pair<const char*, std::vector<const char*>> groups[] = {
      {"Law", {"--law", "--end", "--with"}},
      {"Tangential", {"--tangential"}},
      {"Impact", {"--wall", "--load"}},
      {"Method", {"--method", "--algorithm", "--tolerance"}},
      {"Many targets and measured data",
       {"--targets", "--threads", "--fit", "--alpha-of-speed", "--figures", "--materials"}},
      {"Output", {"--export", "--report", "--format", "--output"}}};
  for (const auto& [heading, flags] : groups)
    for (const char* flag : flags) app.get_option(flag)->group(heading);
}

void add_files(CLI::App& app, Options& o) {
  app.add_option("--targets", o.targets,
                 "calibrate every row of a CSV file instead: columns named as the flags above, tcol, en, max_overlap, "
                 "…, and law, end; directly, on all cores; - is standard input")
      ->type_name("FILE");
  console::add_count(app, "--threads", o.threads, 1024, "threads of --targets (default: all cores)");
  app.add_option(
         "--fit", o.fit,
         "fit the laws to a CSV file of measurements instead: columns velocity or drop_height, en or "
         "rebound_height, or a bouncing ball's flight_time, and any of en_sigma, tcol, tcol_sigma, mass, radius, "
         "diameter; with collision times or a scale the laws come out whole")
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
}

}  // namespace

void add_options(CLI::App& app, Options& o) {
  for (const Field& field : fields) add_field(app, o, field);
  add_match(app, o);
  add_tangential(app, o);
  add_load(app, o);
  std::vector<std::string> laws{"all"};
  laws.insert(laws.end(), Laws::names.begin(), Laws::names.end());
  add_choice(app, "--law", o.law, laws, "law to calibrate (default all)");
  add_choice(app, "--end", o.end, {"overlap", "force", "both"},
             "what ends the contact (default both for linear, force for the others)");
  app.add_option("--with", o.with,
                 "the other way round: what --law does with these parameters, in its own units; no scale and no loss")
      ->type_name("NAME=VALUE,…");
  app.add_flag("--wall", o.asked.wall, "the sphere hits a wall instead of another sphere");
  add_choice(app, "--method", o.method, {"nlopt", "direct"},
             "method of the answer (default nlopt); the other one cross-checks it");
  add_choice(app, "--algorithm", o.settings.algorithm, algorithms(), "NLopt's algorithm (default LN_BOBYQA)");
  console::add_number(app, "--tolerance", o.settings.tolerance, "relative, in tcol and en (default 1e-10)");
  add_files(app, o);
  add_choice(app, "--export", o.engine, {"liggghts", "lammps", "yade", "mercurydpm", "mfix"},
             "write the laws in an engine's own language instead");
  app.add_option("--report", o.page, "also write a page with curves, sensitivities, time steps and export snippets")
      ->type_name("FILE.html");
  console::add_output_options(app, o.output);
  group_options(app);
}

}  // namespace ricochet::calibration
