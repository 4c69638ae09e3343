#include "page_input.hpp"

#include <calibrate/advice.hpp>
#include <console/html.hpp>

#include <fmt/format.h>

namespace ricochet::calibration {
namespace {

using console::escaped;

/// A law found, for an engine: its text's place in the page, and what is said of it.
struct Input {
  Engine engine;
  Snippet snippet;
  std::string id, law;
};

/// "liggghts-ricochet" where the law needs our driver, else the engine.
std::string runner(const Input& input) {
  const bool by_driver = is_located(input.snippet.law, input.snippet.end) && !driver(input.engine).empty();
  return std::string(by_driver ? driver(input.engine) : version(input.engine));
}

/// "by liggghts-ricochet", or nothing.
std::string by(const Input& input) {
  const std::string program = runner(input);
  return program == version(input.engine) ? "" : "by " + program;
}

std::string label(const Input& input) { return fmt::format("{} for {}", input.law, runner(input)); }

/// The laws in the order in which they were found, each in every engine.
std::vector<std::vector<Input>> inputs_of(const Report& report) {
  std::vector<std::vector<Input>> all;
  for (std::size_t result = 0; result < report.results.size(); ++result) {
    const Calibration& r = report.results[result];
    std::vector<Input> one;
    for (const Engine engine : engines())
      if (auto snippet = snippet_of(report, result, engine))
        one.push_back({engine, *std::move(snippet), fmt::format("{}-{}-{}", text(engine), name(r.law), text(r.end)),
                       fmt::format("{}, ended by {}", name(r.law), text(r.end))});
    if (!one.empty()) all.push_back(std::move(one));
  }
  return all;
}

std::string cell(const Input& input) {
  if (input.snippet.fidelity == Fidelity::absent) return "no";
  return fmt::format(R"(<a href="#{}">{}</a>{}<span class="unit">{}</span>)", input.id, text(input.snippet.fidelity),
                     console::html_copy(input.id, label(input)), by(input));
}

/// Who runs which law, and how it is copied.
std::string table_of(const std::vector<std::vector<Input>>& laws) {
  std::vector<console::Column> columns{{"law"}, {"end"}};
  for (const Engine engine : engines())
    columns.push_back({std::string(version(engine).substr(0, version(engine).find_first_of(" ,")))});
  console::Table table(columns, "Which engine runs which law");
  std::vector<std::vector<std::string>> cells;
  for (const auto& law : laws) {
    const Snippet& any = law.front().snippet;
    std::vector<std::string> raw{std::string(name(any.law)), std::string(text(any.end))};
    for (const Input& input : law) raw.push_back(cell(input));
    table.row(std::vector<console::Cell>(raw.size(), std::string()));
    cells.push_back(std::move(raw));
  }
  table.note("exact: the engine runs this very law; close: another one, whose comments say what comes out");
  return console::html_table(table, {.id = "inputs", .shown = 40, .raw = cells});
}

/// One engine's texts, folded, and what it has not.
std::string texts_of(const std::vector<std::vector<Input>>& laws, std::size_t engine) {
  std::string texts, missing;
  for (const auto& law : laws) {
    const Input& input = law[engine];
    if (input.snippet.fidelity == Fidelity::absent)
      missing += fmt::format("<p class=\"under\">{}: {}.</p>\n", escaped(input.law),
                             console::html_text(why_absent(input.snippet)));
    else
      texts += fmt::format("<details><summary>{}: {} {}</summary>\n{}</details>\n", escaped(input.law),
                           text(input.snippet.fidelity), by(input),
                           console::html_code(input.id, label(input), input.snippet.text));
  }
  return fmt::format("<h3>{}</h3>\n{}{}", escaped(version(laws.front()[engine].engine)), texts, missing);
}

}  // namespace

std::string input_section(const Report& report) {
  const auto laws = inputs_of(report);
  if (laws.empty()) return "";
  std::string html = table_of(laws);
  for (std::size_t engine = 0; engine < engines().size(); ++engine) html += texts_of(laws, engine);
  return html;
}

}  // namespace ricochet::calibration
