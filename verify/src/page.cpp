#include <verify/report.hpp>

#include <console/html.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace ricochet::verify {

namespace {

using console::Column;
using console::escaped;
using console::HtmlLink;
using console::Notation;
using console::Table;

bool passed(const Outcome& outcome) {
  return outcome.error.empty() && outcome.result && all_pass(outcome.result->gates);
}

std::size_t passed_gates(const StudyResult& result) {
  return static_cast<std::size_t>(
      std::count_if(result.gates.begin(), result.gates.end(), [](const Gate& gate) { return gate.pass; }));
}

struct Count {
  std::size_t gates = 0, failed = 0, broken = 0;
};

Count count(const std::vector<Outcome>& outcomes) {
  Count all;
  for (const Outcome& outcome : outcomes) {
    all.broken += !outcome.error.empty();
    if (!outcome.result) continue;
    all.gates += outcome.result->gates.size();
    all.failed += outcome.result->gates.size() - passed_gates(*outcome.result);
  }
  return all;
}

std::string summary(const Count& all) {
  std::string text = fmt::format("{} of {} gates passed", all.gates - all.failed, all.gates);
  if (all.failed) text += fmt::format(", {} failed", all.failed);
  if (all.broken) text += fmt::format("; {} {} broke down", all.broken, all.broken == 1 ? "study" : "studies");
  return text + ".";
}

std::string anchor(const Outcome& outcome) { return "study-" + outcome.study->name(); }

/// One line a study: the way into the page.
std::string overview(const std::vector<Outcome>& outcomes) {
  Table table({{"study"}, {"outcome"}, {"gates"}, {"what was found"}, {"time", "s", {Notation::Kind::fixed, 1}}},
              "The studies");
  std::vector<std::string> names;
  for (const Outcome& o : outcomes) {
    names.push_back(fmt::format("<a href=\"#{}\">{}</a>", anchor(o), escaped(o.study->name())));
    const std::string gates = o.result ? fmt::format("{} of {}", passed_gates(*o.result), o.result->gates.size()) : "-";
    table.row({o.study->name(),
               std::string(!o.error.empty() ? "broke down"
                           : passed(o)      ? "passed"
                                            : "failed"),
               gates, o.error.empty() ? o.result->verdict : o.error, o.seconds});
  }
  return console::html_table(table, {.id = "studies", .shown = 40, .raw_first = names});
}

struct Judged {
  const Outcome* outcome;
  const Gate* gate;
};

/// What failed, then what came nearest to failing, then what has no room to measure, in the order of the studies.
std::vector<Judged> by_weight(std::span<const Outcome> outcomes) {
  std::vector<Judged> all;
  for (const Outcome& outcome : outcomes)
    if (outcome.result)
      for (const Gate& gate : outcome.result->gates) all.push_back({&outcome, &gate});
  const auto weight = [](const Judged& j) { return j.gate->pass ? room_taken(*j.gate).value_or(-1) : HUGE_VAL; };
  std::stable_sort(all.begin(), all.end(), [&](const Judged& a, const Judged& b) { return weight(a) > weight(b); });
  return all;
}

/// A value that is a statement's truth reads better as a word.
std::string value_text(const Gate& gate) {
  if (!std::isfinite(gate.value)) return "not finite";
  if (gate.low == 1 && gate.high == 1) return gate.value == 1 ? "true" : "false";
  return console::significant(gate.value, 6);
}

std::string gates_table(const std::vector<Judged>& all, const std::string& id, const std::string& caption,
                        bool with_study) {
  std::vector<Column> columns{{"outcome"},
                              {"gate"},
                              {"value", "", {}, console::Align::right},
                              {"must be"},
                              {"room taken", "%", {Notation::Kind::fixed, 0}}};
  if (with_study) columns.insert(columns.begin() + 1, {"study"});
  Table table(columns, caption);
  std::vector<std::string> outcomes;
  for (const Judged& j : all) {
    const Gate& gate = *j.gate;
    const auto room = room_taken(gate);
    std::vector<console::Cell> cells{std::string(gate.pass ? "passed" : "failed"), gate.name, value_text(gate),
                                     gate.low == 1 && gate.high == 1 ? "true" : bound_text(gate),
                                     room ? console::Cell(100 * *room) : console::blank()};
    if (with_study) cells.insert(cells.begin() + 1, j.outcome->study->name());
    table.row(cells);
    outcomes.push_back(console::html_status(gate.pass));
  }
  return console::html_table(table, {.id = id, .shown = 12, .most = 2000, .raw_first = outcomes});
}

std::string remarks(const std::vector<Outcome>& outcomes) {
  std::string list;
  for (const Outcome& outcome : outcomes)
    if (outcome.result)
      for (const Remark& remark : outcome.result->remarks)
        list += fmt::format("<dt><strong>{}</strong></dt><dd>{} <a href=\"#{}\">{}</a></dd>\n", escaped(remark.about),
                            escaped(remark.text), anchor(outcome), escaped(outcome.study->name()));
  if (list.empty()) return {};
  return fmt::format(
      "<h2 id=\"print\">Where the print and the numbers differ</h2>\n<p>Parts of the paper's print are illegible or "
      "inconsistent; the numbers here were computed in this run.</p>\n<dl class=\"facts\">\n{}</dl>\n",
      list);
}

std::string figures(const Outcome& outcome) {
  std::string html;
  for (std::size_t i = 0; i < outcome.pictures.size(); ++i) {
    const console::Figure& figure = outcome.result->figures[i];
    std::vector<HtmlLink> links{{figure.name + ".svg", figure.name + ".svg"},
                                {figure.name + ".png", figure.name + ".png"}};
    for (const console::DataFile& data : figure.data) links.push_back({data.name, data.name});
    html += console::html_figure(figure, outcome.pictures[i], links);
  }
  return html;
}

std::string section(const Outcome& outcome) {
  const std::string id = anchor(outcome), name = outcome.study->name();
  std::string html =
      fmt::format("<section aria-labelledby=\"{}\">\n<h2 id=\"{}\">{} {}</h2>\n<p><strong>Claimed:</strong> {}.</p>\n",
                  id, id, escaped(name), console::html_status(passed(outcome)), escaped(outcome.study->claim()));
  if (!outcome.error.empty())
    html += fmt::format("<p class=\"verdict\"><strong>Broke down:</strong> {}</p>\n", escaped(outcome.error));
  if (!outcome.result) return html + "</section>\n";
  const StudyResult& result = *outcome.result;
  if (!result.verdict.empty())
    html += fmt::format("<p class=\"verdict\"><strong>Found:</strong> {}</p>\n", escaped(result.verdict));
  html += figures(outcome);
  if (!result.tables.empty()) html += "<h3>What was measured</h3>\n";
  for (std::size_t i = 0; i < result.tables.size(); ++i) {
    const auto files = table_files(*outcome.study, result);
    const std::string& file = files[std::min(i, files.size() - 1)];
    html +=
        console::html_table(result.tables[i], {.id = fmt::format("{}-table-{}", name, i + 1), .links = {{file, file}}});
  }
  html += fmt::format("<h3>Gates</h3>\n<p>{} Everything as <a href=\"{}.json\">{}.json</a>.</p>\n",
                      summary({result.gates.size(), result.gates.size() - passed_gates(result), 0}), name, name);
  const auto mine = by_weight({&outcome, 1});
  if (!mine.empty()) html += gates_table(mine, name + "-gates", "Gates of " + name, false);
  return html + "</section>\n";
}

std::string made(const Facts& made_by) {
  std::string html = "<dl class=\"facts\">\n";
  for (const auto& [what, value] : made_by)
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(what), escaped(value));
  return html + "</dl>\n";
}

}  // namespace

std::string report_page(const std::vector<Outcome>& outcomes, const Facts& made_by) {
  const Count all = count(outcomes);
  const bool good = all.failed == 0 && all.broken == 0;
  std::string body = fmt::format(
      "<header>\n<h1>What Ricochet verified</h1>\n<p class=\"lead\">{} {}</p>\n<p>Every claim of J. S. Leszczynski, "
      "Phys. "
      "Rev. E 70, 051315 (2004), on the fractional interaction law, and every claim of this program about itself, "
      "measured against bounds that were derived beforehand.</p>\n{}</header>\n<main id=\"content\">\n{}{}<h2 "
      "id=\"gates\">Gates</h2>\n<p>A gate is a number and the bounds that it must keep. What failed comes first, then "
      "what came nearest to its bound. The whole run as <a href=\"report.json\">report.json</a>.</p>\n{}",
      console::html_status(good), escaped(summary(all)), made(made_by), overview(outcomes), remarks(outcomes),
      gates_table(by_weight(outcomes), "all-gates", "All gates", true));
  for (const Outcome& outcome : outcomes) body += section(outcome);
  body += fmt::format("</main>\n<footer><p>{}. SI units unless a column says otherwise.</p></footer>\n",
                      escaped(made_by.front().second));
  return console::html_page("What Ricochet verified: " + summary(all), body);
}

}  // namespace ricochet::verify
