#include "fit_report.hpp"

#include "measurements.hpp"

#include <console/json.hpp>
#include <console/number.hpp>
#include <console/output.hpp>
#include <console/plot.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::calibration {
namespace {

using console::BadInput;
using console::Json;
using console::Table;

std::vector<FitRequest> requests_of(const Options& o, double mass_eff) {
  const auto end = o.end.empty() ? ContactEnd::force : end_named("--end", o.end);
  std::vector<LawName> laws{LawName::linear, LawName::kuwabara_kono, LawName::tsuji, LawName::hysteretic,
                            LawName::fractional};
  if (!o.law.empty() && o.law != "all") laws = {law_named("--law", o.law)};
  std::vector<FitRequest> all;
  for (const LawName law : laws) {
    const bool offered = end == ContactEnd::force || law == LawName::linear || law == LawName::tsuji;
    if (!offered && laws.size() == 1) throw BadInput("--end", o.end, "force with --fit and --law " + o.law);
    if (offered) all.push_back({law, end, mass_eff});
    if (offered && law == LawName::fractional && o.alpha_of_speed) all.push_back({law, end, mass_eff, true});
  }
  if (o.alpha_of_speed && !all.back().alpha_of_speed)
    throw BadInput("--alpha-of-speed: must be given with --law fractional or all, ended by force");
  return all;
}

Table parameter_table(const std::vector<Fit>& fits) {
  Table table({{"law"}, {"parameter"}, {"value"}, {"standard error", "", {.digits = 3}}, {"unit"}, {"correlations"}},
              "Parameters, as far as the data tell them");
  for (const Fit& fit : fits)
    for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
      const Estimate& p = fit.parameters[i];
      std::string row;
      for (std::size_t j = 0; j <= i && fit.parameters.size() > 1; ++j)
        row += (j ? " " : "") + console::fixed(fit.correlations[i][j], 3);
      table.row({fit_name(fit.request), p.name, p.value, p.error, p.unit, row});
    }
  return table;
}

Table goodness_table(const std::vector<Fit>& fits) {
  const auto best = std::min_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.aic < b.aic; });
  const bool known = fits.front().errors_known;
  Table table({{"law"}, {"end"}, {known ? "chi2" : "sum of squares"}, {"degrees of freedom"}, {known ? "chi2/dof" : "scatter"},
               {"probability", "", {.digits = 3}}, {"AIC over the best", "", {console::Notation::Kind::fixed, 1}}},
              "How well they fit");
  for (const Fit& fit : fits) {
    const double over = fit.chi2 / static_cast<double>(fit.freedom);
    table.row({fit_name(fit.request), std::string(text(fit.request.end)), fit.chi2, static_cast<std::int64_t>(fit.freedom),
               known ? over : std::sqrt(over), known ? console::Cell(fit.probability) : console::blank(), fit.aic - best->aic});
  }
  for (const Fit& fit : fits)
    for (const auto& finding : fit.findings) table.note(fit_name(fit.request) + ": " + finding);
  return table;
}

Table residual_table(const std::vector<Fit>& fits, const std::vector<Measurement>& data) {
  const bool times = data.front().tcol > 0, known = data.front().en_sigma > 0;
  std::vector<console::Column> columns{{"velocity", "m/s"}, {"en"}};
  if (known) columns.push_back({"en_sigma"});
  if (times) columns.insert(columns.end(), {{"tcol", "s"}, {"tcol_sigma", "s"}});
  for (const Fit& fit : fits) {
    columns.push_back({"en, " + fit_name(fit.request)});
    if (times) columns.push_back({"tcol, " + fit_name(fit.request), "s"});
  }
  Table table(columns, "Measured and fitted");
  for (std::size_t i = 0; i < data.size(); ++i) {
    std::vector<console::Cell> row{data[i].velocity, data[i].en};
    if (known) row.push_back(data[i].en_sigma);
    if (times) row.insert(row.end(), {data[i].tcol, data[i].tcol_sigma});
    for (const Fit& fit : fits) {
      row.push_back(fit.predictions[i].en);
      if (times) row.push_back(fit.predictions[i].tcol);
    }
    table.row(row);
  }
  return table;
}

Json json_of(const Fit& fit) {
  Json out{{"law", text(fit.request.law)}, {"alpha_of_speed", fit.request.alpha_of_speed}, {"end", text(fit.request.end)}};
  out["parameters"] = Json::array();
  for (const Estimate& p : fit.parameters)
    out["parameters"].push_back({{"name", p.name}, {"value", p.value}, {"standard_error", p.error}, {"unit", p.unit}});
  out["correlations"] = fit.correlations;
  out["chi2"] = fit.chi2;
  out["degrees_of_freedom"] = fit.freedom;
  out["errors_known"] = fit.errors_known;
  out["probability"] = fit.errors_known ? Json(fit.probability) : Json(nullptr);
  out["aic"] = fit.aic;
  out["findings"] = fit.findings;
  return out;
}

std::string rendered(const std::vector<Fit>& fits, const std::vector<Measurement>& data, const Options& o) {
  if (o.output.format == console::Format::csv)
    return console::render_all({parameter_table(fits), goodness_table(fits), residual_table(fits, data)}, o.output.format);
  if (o.output.format != console::Format::json)
    return console::render_all({parameter_table(fits), goodness_table(fits)}, o.output.format);
  Json out{{"schema", "ricochet/fit/1"}, {"mass_eff", fits.front().request.mass_eff}, {"measurements", data.size()}};
  out["results"] = Json::array();
  for (const Fit& fit : fits) out["results"].push_back(json_of(fit));
  const Table residuals = residual_table(fits, data);
  out["units"] = console::units_of(residuals);
  out["rows"] = console::rows_of(residuals);
  return console::document(out);
}

/// Measured restitution with every law's, and under it what is left over.
console::Figure figure_of(const std::vector<Fit>& fits, const std::vector<Measurement>& data) {
  const bool known = data.front().en_sigma > 0;
  const std::size_t first = 3 + (known ? 1 : 0) + (data.front().tcol > 0 ? 2 : 0), stride = data.front().tcol > 0 ? 2 : 1;
  std::string curves, leftovers;
  for (std::size_t i = 0; i < fits.size(); ++i) {
    const std::string column = std::to_string(first + i * stride), title = "title '" + fit_name(fits[i].request) + "'";
    curves += ", 'fit.csv' skip 1 using 1:" + column + " with linespoints pt 0 lw 2 " + title;
    leftovers += (i ? ", " : "plot ") + std::string("'fit.csv' skip 1 using 1:(") + (known ? "($2-$" + column + ")/$3" : "$2-$" + column) +
                 ") with linespoints pt 7 ps 0.4 notitle";
  }
  return {"fit", "Measured restitution against impact velocity with the fitted laws; below, what is left over.",
          "set logscale x\nset multiplot layout 2,1\nset grid\nset ylabel 'restitution'\nset key outside right\n"
          "plot 'fit.csv' skip 1 using 1:2" + std::string(known ? ":3 with yerrorbars" : " with points") +
              " pt 7 ps 0.6 lc rgb 'black' title 'measured'" + curves + "\nset xlabel 'impact velocity [m/s]'\nset ylabel '" +
              (known ? "residual over its error" : "residual") + "'\n" + leftovers + "\nunset multiplot\n",
          {{"fit.csv", residual_table(fits, data).csv()}}, 800, 640};
}

}  // namespace

console::Exit run_fit(const Options& options) {
  const auto refuse = [](const char* flag, bool given) {
    if (given) throw BadInput(std::string(flag) + ": must be left out with --fit");
  };
  refuse("--tcol", options.tcol.has_value());
  refuse("--en", options.en.has_value());
  refuse("--velocity", options.velocity.has_value());
  refuse("--stiffness", options.stiffness.has_value());
  refuse("--targets", !options.targets.empty());
  refuse("--export", !options.engine.empty());
  refuse("--method", !options.method.empty());
  refuse("--report", !options.page.empty());
  refuse("--threads", options.threads.has_value());
  Options spheres = options;
  spheres.law = spheres.end = "";
  const auto requests = requests_of(options, target_defaults(spheres).impact.mass_eff);
  const auto data = read_measurements(options.fit);
  std::vector<Fit> fits;
  for (const FitRequest& request : requests) {
    try {
      fits.push_back(fit_law(request, data));
    } catch (const NotConverged& failure) {
      if (requests.size() == 1) throw;
      console::complain("calibrate", failure.what());
    } catch (const std::invalid_argument& misuse) {
      throw BadInput(options.fit + ": " + misuse.what());
    }
  }
  if (fits.empty()) throw console::Failed("no law could be fitted");
  console::emit(options.output.file, rendered(fits, data, options));
  if (!options.figures.empty()) console::draw(figure_of(fits, data), options.figures);
  return console::Exit::done;
}

}  // namespace ricochet::calibration
