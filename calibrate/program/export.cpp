#include "report.hpp"

#include <calibrate/export.hpp>
#include <console/exit.hpp>
#include <console/json.hpp>

#include <fmt/format.h>

namespace ricochet::calibration {
namespace {

using console::Json;

std::vector<Snippet> snippets_of(const Report& report, Engine engine) {
  const Job& job = report.job;
  std::vector<Snippet> snippets;
  for (const Calibration& found : report.results)
    snippets.push_back(export_law(engine, {.law = found.law,
                                           .end = found.end,
                                           .tcol = found.request.target.tcol,
                                           .en = found.request.target.en,
                                           .impact = found.request.target.impact,
                                           .radius_eff = job.radius_eff,
                                           .density = job.density}));
  return snippets;
}

Json json_of(const Snippet& snippet) {
  Json json{{"law", name(snippet.law)}, {"end", text(snippet.end)}, {"fidelity", text(snippet.fidelity)}};
  if (snippet.gives.separated())
    json["gives"] = {{"tcol", snippet.gives.tcol}, {"en", snippet.gives.en}};
  else
    json["gives"] = nullptr;
  json["remarks"] = snippet.remarks;
  json["text"] = snippet.text;
  return json;
}

std::string document_of(const std::vector<Snippet>& snippets, Engine engine) {
  Json json{{"schema", "ricochet/export/1"},
            {"engine", text(engine)},
            {"version", version(engine)},
            {"snippets", Json::array()}};
  for (const Snippet& snippet : snippets) json["snippets"].push_back(json_of(snippet));
  return console::document(json);
}

}  // namespace

std::string exported(const Report& report, const std::string& name_of_engine, console::Format format) {
  if (format != console::Format::table && format != console::Format::json)
    throw console::BadInput("--format", format == console::Format::csv ? "csv" : "markdown",
                            "table (the engine's own language) or json with --export");
  const Engine engine = engine_named(name_of_engine).value();
  const auto snippets = snippets_of(report, engine);
  if (format == console::Format::json) return document_of(snippets, engine);
  std::string all = combine(snippets);
  for (const Infeasible& missed : report.infeasible)
    all += "\n" + comment(engine, fmt::format("Ricochet: the {} law ended by {} can't reach the target.",
                                              missed.law.name(), text(missed.end)));
  for (const Failure& failure : report.failed)
    all += "\n" + comment(engine, fmt::format("Ricochet: failed: {}.", failure.reason));
  return all;
}

}  // namespace ricochet::calibration
