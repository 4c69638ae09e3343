#include "fit_report.hpp"

#include "fit_figure.hpp"
#include "fit_run.hpp"
#include "measurements.hpp"

#include <console/html.hpp>
#include <console/json.hpp>
#include <console/number.hpp>
#include <console/output.hpp>
#include <console/plot.hpp>
#include <console/signals.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace ricochet::calibration {
namespace {

using console::BadInput;
using console::Json;
using console::Table;

/// A law that was asked for and has no fit.
struct LeftOut {
  FitRequest request;
  std::string reason;
};

struct FitReport {
  std::vector<Measurement> data;
  std::vector<Fit> fits;
  std::vector<LeftOut> left_out;
  std::vector<std::string> assumptions, notes;  ///< of the bodies; of the file
  std::optional<Report> run = {};               ///< the laws whole, where there is a scale
};

/// What is held of the laws of which the data tell less than they have; throws where none of these laws holds it.
Held held_of(const Options& o, const std::vector<LawKind>& laws) {
  const auto some_holds = [&](std::string_view name) {
    return std::any_of(laws.begin(), laws.end(), [&](LawKind law) {
      const auto values = held({.law = law});
      return std::any_of(values.begin(), values.end(), [&](const NamedValue& v) { return v.name == name; });
    });
  };
  Held kept;
  const auto take = [&](double& to, const char* flag, std::optional<double> value, std::string_view name, bool ok,
                        std::string_view accepted) {
    if (!value) return;
    if (!some_holds(name)) throw BadInput(fmt::format("{}: must be left out with --fit and --law {}", flag, o.law));
    if (!ok) throw BadInput(flag, console::shortest(*value), std::string(accepted));
    to = *value;
  };
  take(kept.alpha, "--alpha", o.asked.alpha, "alpha", domains::degree.contains(o.asked.alpha.value_or(0)),
       domains::degree.accepted);
  take(kept.stiffening, "--stiffening", o.asked.stiffening, "k1/k", o.asked.stiffening.value_or(1) > 0, "> 0");
  return kept;
}

/// The laws that are asked for; what does not offer the asked end is left out, or refused where it stands alone.
std::vector<FitRequest> requests_of(const Options& o, const Measurement& bodies, std::vector<LeftOut>& left_out) {
  const auto end = o.end.empty() ? ContactEnd::force : end_named("--end", o.end);
  const auto every = LawKind::all();
  std::vector<LawKind> laws(every.begin(), every.end());
  if (!o.law.empty() && o.law != "all") laws = {law_named("--law", o.law)};
  if (o.alpha_of_speed && laws.size() == 1 && laws.front() != kind_of<Fractional>)
    throw BadInput("--alpha-of-speed: must be given with --law fractional or all");
  const Held held = held_of(o, laws);
  std::vector<FitRequest> all;
  for (const LawKind law : laws) {
    if (law.ends().offer(end)) {
      all.push_back({law, end, bodies.mass_eff, false, bodies.radius_eff, held});
      continue;
    }
    if (laws.size() == 1) throw BadInput("--end", o.end, "force with --law " + o.law);
    left_out.push_back({{law, end, bodies.mass_eff}, "ends by force only"});
  }
  if (o.alpha_of_speed) all.push_back({kind_of<Fractional>, end, bodies.mass_eff, true, bodies.radius_eff});
  return all;
}

Table parameter_table(const FitReport& report) {
  Table table({{"law"}, {"parameter"}, {"value"}, {"standard error", "", {.digits = 3}}, {"unit"}, {"correlations"}},
              "Parameters, as far as the data tell them");
  for (const Fit& fit : report.fits)
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
      const Estimate& p = fit.parameters[i];
      std::vector<std::string> row;
      for (std::size_t j = 0; j <= i && fit.parameters.size() > 1; ++j)
        row.push_back(console::fixed(fit.correlations[i][j], 3));
      table.row({fit_name(fit.request), p.name, p.value, p.error, p.unit, fmt::format("{}", fmt::join(row, " "))});
    }
  if (report.data.front().tcol > 0 || report.run)  // without times and scale the mass has no part in what is told
    for (const auto& assumption : report.assumptions) table.note("assumed: " + assumption);
  for (const auto& note : report.notes) table.note(note);
  if (!report.run)
    table.note(
        "with a scale (--tcol, --stiffness, --young and --poisson, --max-overlap) the laws come out whole, for runs "
        "and --export");
  return table;
}

/// AICc over that of the law which the AIC prefers.
console::Cell aicc_over(const Fit& fit, const std::vector<Fit>& fits) {
  const Fit& best = fits[preferred(fits).best.front()];
  if (!fit.aicc || !best.aicc) return console::blank();
  return std::round(1e3 * (*fit.aicc - *best.aicc)) / 1e3;
}

Table goodness_table(const std::vector<Fit>& fits) {
  const double least = fits[preferred(fits).best.front()].aic;
  const bool known = fits.front().errors_known;
  Table table({{"law"},
               {"end"},
               {known ? "chi2" : "sum of squares"},
               {"degrees of freedom"},
               {known ? "chi2/dof" : "scatter"},
               {"probability", "", {.digits = 3}},
               {"AIC over the best", "", {.digits = 4}},
               {"AICc over it", "", {.digits = 4}}},
              "How well they fit");
  for (const Fit& fit : fits) {
    const double over = fit.chi2 / static_cast<double>(fit.freedom);
    table.row({fit_name(fit.request), std::string(text(fit.request.end)), fit.chi2,
               static_cast<std::int64_t>(fit.freedom), known ? over : std::sqrt(over),
               known ? console::Cell(fit.probability) : console::blank(), std::round(1e3 * (fit.aic - least)) / 1e3,
               aicc_over(fit, fits)});
  }
  if (const auto text = preference_text(fits); !text.empty()) table.note(text);
  return table;
}

/// Each finding once, with the laws that it is about.
Table findings_table(const FitReport& report) {
  std::vector<std::pair<std::string, std::string>> found;
  const auto add = [&](const std::string& finding, const FitRequest& request) {
    const auto known = std::find_if(found.begin(), found.end(), [&](const auto& f) { return f.first == finding; });
    if (known == found.end())
      found.emplace_back(finding, fit_name(request));
    else
      known->second += "; " + fit_name(request);
  };
  for (const Fit& fit : report.fits)
    for (const auto& finding : fit.findings) add(finding, fit.request);
  for (const LeftOut& missed : report.left_out) add("not fitted: " + missed.reason, missed.request);
  Table table({{"finding"}, {"laws"}}, "What the data do not tell, and what does not fit");
  for (const auto& [finding, laws] : found) table.row({finding, laws});
  return table;
}

/// The columns of the measurements, as the file has them.
Table measured_table(const std::vector<Measurement>& data) {
  const bool times = data.front().tcol > 0, known = data.front().en_sigma > 0;
  std::vector<console::Column> columns{{"velocity", "m/s"}, {"en"}};
  if (known) columns.push_back({"en_sigma"});
  if (times) columns.insert(columns.end(), {{"tcol", "s"}, {"tcol_sigma", "s"}});
  Table table(columns);
  for (const Measurement& m : data) {
    std::vector<console::Cell> row{m.velocity, m.en};
    if (known) row.push_back(m.en_sigma);
    if (times) row.insert(row.end(), {m.tcol, m.tcol_sigma});
    table.row(row);
  }
  return table;
}

/// Measured and fitted side by side.
Table comparison_table(const FitReport& report) {
  const Table measured = measured_table(report.data);
  const bool times = report.data.front().tcol > 0;
  auto columns = measured.columns();
  for (const Fit& fit : report.fits) {
    columns.push_back({"en, " + fit_name(fit.request)});
    if (times) columns.push_back({"tcol, " + fit_name(fit.request), "s"});
  }
  Table table(columns, "Measured and fitted");
  for (std::size_t i = 0; i < report.data.size(); ++i) {
    auto row = measured.rows()[i];
    for (const Fit& fit : report.fits) {
      row.push_back(fit.predictions[i].en);
      if (times) row.push_back(fit.predictions[i].tcol);
    }
    table.row(row);
  }
  return table;
}

Json json_of(const Fit& fit, bool times) {
  Json out{
      {"law", fit.request.law.name()}, {"alpha_of_speed", fit.request.alpha_of_speed}, {"end", text(fit.request.end)}};
  out["parameters"] = Json::array();
  for (const Estimate& p : fit.parameters)
    out["parameters"].push_back({{"name", p.name}, {"value", p.value}, {"standard_error", p.error}, {"unit", p.unit}});
  out["correlations"] = fit.correlations;
  out["chi2"] = fit.chi2;
  out["degrees_of_freedom"] = fit.freedom;
  out["errors_known"] = fit.errors_known;
  out["probability"] = fit.errors_known ? Json(fit.probability) : Json(nullptr);
  out["aic"] = fit.aic;
  out["aicc"] = fit.aicc ? Json(*fit.aicc) : Json(nullptr);
  out["fitted"] = Json::array();
  for (const Prediction& p : fit.predictions) {
    out["fitted"].push_back({{"en", p.en}});
    if (times) out["fitted"].back()["tcol"] = p.tcol;
  }
  out["held"] = Json::object();
  for (const NamedValue& value : held(fit.request)) out["held"][value.name] = value.value;
  out["findings"] = fit.findings;
  return out;
}

Json json_of(const Preference& found, const std::vector<Fit>& fits) {
  Json out{{"laws", Json::array()}, {"next", nullptr}, {"ahead", nullptr}};
  for (const std::size_t place : found.best) out["laws"].push_back(fit_name(fits[place].request));
  if (!found.next) return out;
  out["next"] = fit_name(fits[*found.next].request);
  out["ahead"] = found.ahead;
  return out;
}

std::string json_of(const FitReport& report) {
  const Table measured = measured_table(report.data);
  Json out{{"schema", "ricochet/fit/1"},
           {"mass_eff", report.fits.front().request.mass_eff},
           {"assumed", report.assumptions}};
  out["units"] = console::units_of(measured);
  out["units"]["mass_eff"] = "kg";
  out["measurements"] = console::rows_of(measured);
  out["results"] = Json::array();
  for (const Fit& fit : report.fits) out["results"].push_back(json_of(fit, report.data.front().tcol > 0));
  out["preferred"] = json_of(preferred(report.fits), report.fits);
  out["left_out"] = Json::array();
  for (const auto& [request, reason] : report.left_out)
    out["left_out"].push_back(
        {{"law", request.law.name()}, {"alpha_of_speed", request.alpha_of_speed}, {"reason", reason}});
  if (!report.notes.empty()) out["notes"] = report.notes;
  if (report.run) out["run"] = document_of(*report.run);
  return console::document(out);
}

/// The laws of the fits as a run takes them, and which of them none does.
std::vector<Table> run_tables(const FitReport& report) {
  if (!report.run) return {};
  std::vector<Table> tables = law_tables(*report.run);
  Table out({{"law"}, {"end"}, {"why"}}, "What no run takes");
  for (const Infeasible& missed : report.run->infeasible)
    out.row({std::string(missed.law.name()), std::string(text(missed.end)), explained(missed, Spelling::flags)});
  if (!out.rows().empty()) tables.push_back(out);
  return tables;
}

std::vector<Table> fit_tables(const FitReport& report) {
  std::vector<Table> tables{parameter_table(report), goodness_table(report.fits)};
  const Table found = findings_table(report);
  if (!found.rows().empty()) tables.push_back(found);
  return tables;
}

/// The page of the laws, with the fit before them.
std::string page_of(const FitReport& report, const std::string& command) {
  std::string html;
  const auto tables = fit_tables(report);
  for (std::size_t i = 0; i < tables.size(); ++i)
    html += console::html_table(tables[i], {.id = fmt::format("fit-{}", i + 1), .shown = 40});
  const auto figure = figure_of(report.fits, report.data);
  return page_of(*report.run, {.command = command,
                               .heading = "Contact laws by " + report.run->job.title,
                               .figure = console::html_figure(figure, console::pictures_of(figure), {}),
                               .section = html});
}

std::string rendered(const FitReport& report, console::Format format) {
  if (format == console::Format::json) return json_of(report);
  std::vector<Table> tables = fit_tables(report);
  if (format == console::Format::csv)
    tables.push_back(comparison_table(report));
  else
    for (const Table& table : run_tables(report)) tables.push_back(table);
  return console::render_all(tables, format);
}

/// Every law that these data allow; where they allow none, that is what is wrong with them.
void fit_all(FitReport& report, const std::vector<FitRequest>& requests, const std::string& file) {
  bool misuse = false;
  for (const FitRequest& request : requests) {
    try {
      report.fits.push_back(fit_law(request, report.data));
    } catch (const NotConverged& failure) {
      report.left_out.push_back({request, failure.what()});
    } catch (const std::invalid_argument& failure) {
      misuse = true;
      report.left_out.push_back({request, failure.what()});
    }
  }
  if (!report.fits.empty()) return;
  const std::string reason = fmt::format("{}: {}", file, report.left_out.back().reason);
  if (misuse) throw BadInput(reason);
  throw console::Failed(reason);
}

/// The bodies whose parameters are told: the first row's, where rows have theirs, else those of the flags.
Measurement bodies_of(const Options& options, FitReport& report) {
  const Measurement& first = report.data.front();
  if (first.mass_eff > 0) {
    for (const std::string flag : {"--mass-eff", "--radius", "--diameter", "--radius2", "--diameter2", "--density2"})
      if (was_given(options, flag))
        throw BadInput(fmt::format("{}: must be left out with a file whose rows have masses or radii", flag));
    report.notes.push_back(fmt::format("parameters are told for the bodies of line {}, effective mass {} kg",
                                       first.line, console::significant(first.mass_eff, 6)));
    if (!options.asked.wall) report.assumptions.emplace_back("two equal spheres meet, not one and a plate (--wall)");
    return first;
  }
  const Bodies bodies = calibration::bodies_of(options.asked, Spelling::flags, report.assumptions);
  return {.mass_eff = bodies.mass_eff, .radius_eff = bodies.radius_eff.value_or(0)};
}

/// Flags that nothing follows: refused where they ask for a whole law and there is none, else told.
void judge_idle_flags(const Options& options, FitReport& report) {
  if (report.run) {
    require_match_to_matter(options, report.run->job.known.scale);
    return;
  }
  for (const std::string flag : {"--match", "--velocity"})
    if (was_given(options, flag))
      throw BadInput(fmt::format("{}: must be left out without a scale, without which no law comes out whole", flag));
  std::vector<std::string> idle;
  for (const std::string& flag : flags_of({Topic::impact}, {"--wall"}))
    if (was_given(options, flag) && !(report.data.front().mass_eff > 0)) idle.push_back(flag);
  if (!idle.empty())
    report.notes.push_back(fmt::format("{}: no part in what these data tell without a scale", fmt::join(idle, ", ")));
}

/// Throws where laws that are not whole are asked for.
void require_run(const Options& options, const FitReport& report) {
  for (const auto& [flag, text] : {std::pair("--export", options.engine), std::pair("--report", options.page)})
    if (!text.empty() && !report.run)
      throw BadInput(
          fmt::format("{}: must be given with a scale, as these data have no collision times: --tcol, "
                      "--stiffness, --young with --poisson, --max-overlap or --timestep with --steps",
                      flag));
}

}  // namespace

console::Exit run_fit(const Options& options) {
  take_only(options, "--fit",
            flags_of({Topic::scale, Topic::held, Topic::impact},
                     {"--fit", "--law", "--alpha", "--end", "--match", "--wall", "--alpha-of-speed", "--figures",
                      "--export", "--report", "--format", "--output"}));
  FitReport report;
  Measured measured = read_measurements(options.fit, {options.asked.density, options.asked.wall});
  report.data = std::move(measured.data);
  report.notes = std::move(measured.notes);
  const Measurement bodies = bodies_of(options, report);
  const auto requests = requests_of(options, bodies, report.left_out);
  fit_all(report, requests, options.fit);
  report.run = run_of_fits(options, report.fits, report.data);
  require_run(options, report);
  judge_idle_flags(options, report);
  console::Together files;
  if (!options.figures.empty()) console::draw(figure_of(report.fits, report.data), files.folder(options.figures));
  if (!options.page.empty()) files.file(options.page).write(page_of(report, options.command));
  files.output(options.output.file)
      .write(options.engine.empty() ? rendered(report, options.output.format)
                                    : exported(*report.run, options.engine, options.output.format));
  files.commit();
  return console::Exit::done;
}

}  // namespace ricochet::calibration
