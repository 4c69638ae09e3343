#include <verify/report.hpp>

#include <console/html.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>

namespace ricochet::verify {

namespace {

using console::Column;
using console::escaped;
using console::html_text;
using console::HtmlLink;
using console::Notation;
using console::Table;

bool passed(const Outcome& outcome) {
  return outcome.error.empty() && outcome.result && all_pass(outcome.result->gates);
}

std::size_t broken(const std::vector<Outcome>& outcomes) {
  return static_cast<std::size_t>(
      std::count_if(outcomes.begin(), outcomes.end(), [](const Outcome& o) { return !o.error.empty(); }));
}

/// "12 gates passed, none failed, 3 skipped."
std::string summary(const Counts& counts, std::size_t broke_down = 0) {
  std::string text = fmt::format("{} {} passed, {} failed", counts.passed, counts.passed == 1 ? "gate" : "gates",
                                 counts.failed == 0 ? "none" : std::to_string(counts.failed));
  if (counts.skipped) text += fmt::format(", {} skipped", counts.skipped);
  if (broke_down) text += fmt::format("; {} {} broke down", broke_down, broke_down == 1 ? "study" : "studies");
  return text + ".";
}

std::string anchor(const Outcome& outcome) { return "study-" + outcome.study->name(); }

std::string link_to(const Outcome& outcome, const std::string& text) {
  return fmt::format("<a href=\"#{}\">{}</a>", anchor(outcome), escaped(text));
}

/// The way into the page, beside it where there is room.
std::string contents(const std::vector<Outcome>& outcomes, bool with_remarks) {
  std::vector<HtmlLink> links{{"#studies", "All studies"}};
  if (with_remarks) links.push_back({"#print", "Where print and numbers differ"});
  links.push_back({"#gates", "Gates"});
  for (const Outcome& o : outcomes) links.push_back({"#" + anchor(o), o.study->title()});
  links.push_back({"#made", "How this page was made"});
  return console::html_contents(links);
}

/// One line a study.
std::string overview(const std::vector<Outcome>& outcomes) {
  Table table({{"study"},
               {"outcome"},
               {"passed"},
               {"failed"},
               {"skipped"},
               {"what was found"},
               {"time", "s", {Notation::Kind::fixed, 1}}},
              "The studies");
  std::vector<std::vector<std::string>> names;
  for (const Outcome& o : outcomes) {
    names.push_back({link_to(o, o.study->title())});
    const Counts counts = o.result ? counts_of(*o.result) : Counts{};
    const auto number = [](std::size_t n) { return static_cast<std::int64_t>(n); };
    table.row({o.study->title(),
               std::string(!o.error.empty() ? "broke down"
                           : passed(o)      ? "passed"
                                            : "failed"),
               number(counts.passed), number(counts.failed), number(counts.skipped),
               o.error.empty() ? o.result->verdict : o.error, o.seconds});
  }
  return console::html_table(table, {.id = "studies", .shown = 40, .raw = names});
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
  std::vector<std::vector<std::string>> outcomes;
  for (const Judged& j : all) {
    const Gate& gate = *j.gate;
    const auto room = room_taken(gate);
    std::vector<console::Cell> cells{std::string(gate.pass ? "passed" : "failed"), gate.name, value_text(gate),
                                     gate.low == 1 && gate.high == 1 ? "true" : bound_text(gate),
                                     room ? console::Cell(100 * *room) : console::blank()};
    if (with_study) cells.insert(cells.begin() + 1, j.outcome->study->title());
    table.row(cells);
    outcomes.push_back({console::html_status(gate.pass)});
  }
  return console::html_table(table, {.id = id, .shown = 12, .most = 2000, .raw = outcomes});
}

std::string remarks(const std::vector<Outcome>& outcomes) {
  std::string list;
  for (const Outcome& outcome : outcomes)
    if (outcome.result)
      for (const Remark& remark : outcome.result->remarks)
        list += fmt::format("<dt><strong>{}</strong></dt><dd>{} {}</dd>\n", html_text(remark.about),
                            html_text(remark.text), link_to(outcome, outcome.study->title()));
  if (list.empty()) return {};
  return fmt::format(
      "<h2 id=\"print\">Where the print and the numbers differ</h2>\n<p>Parts of the paper's print are illegible or "
      "inconsistent; the numbers here were computed in this run.</p>\n<dl class=\"facts\">\n{}</dl>\n",
      list);
}

std::string figure(const Outcome& outcome, std::size_t i) {
  const console::Figure& drawn = outcome.result->figures[i];
  std::vector<HtmlLink> links;
  for (const char* ending : {".svg", ".pdf", ".png"}) links.push_back({drawn.name + ending, drawn.name + ending});
  for (const console::DataFile& data : drawn.data) links.push_back({data.name, data.name});
  return console::html_figure(drawn, outcome.pictures[i], links);
}

/// What the page begins with: the study that answers what every reader of the paper asks, is it physics or a fit; else
/// the first that drew something.
const Outcome* leading(const std::vector<Outcome>& outcomes) {
  const Outcome* first = nullptr;
  for (const Outcome& o : outcomes) {
    if (o.pictures.empty()) continue;
    if (o.study->name() == "sphere") return &o;
    if (!first) first = &o;
  }
  return first;
}

std::string lead(const std::vector<Outcome>& outcomes) {
  const Outcome* o = leading(outcomes);
  if (!o) return {};
  // The figure's own words have the numbers.
  const std::string sentence = passed(*o) ? o->study->claim() + "." : o->result->verdict;
  return fmt::format("<p class=\"verdict\">{} {}</p>\n{}", html_text(sentence), link_to(*o, o->study->title()),
                     figure(*o, 0));
}

std::string tables(const Outcome& outcome) {
  const StudyResult& result = *outcome.result;
  std::string html = result.tables.empty() ? "" : "<h3>What was measured</h3>\n";
  for (std::size_t i = 0; i < result.tables.size(); ++i) {
    const auto files = table_files(*outcome.study, result);
    const std::string& file = files[std::min(i, files.size() - 1)];
    html += console::html_table(
        result.tables[i], {.id = fmt::format("{}-table-{}", outcome.study->name(), i + 1), .links = {{file, file}}});
  }
  return html;
}

std::string gates(const Outcome& outcome) {
  const std::string name = outcome.study->name();
  std::string html = fmt::format("<h3>Gates</h3>\n<p>{} Everything as <a href=\"{}.json\">{}.json</a>.</p>\n",
                                 summary(counts_of(*outcome.result)), name, name);
  const auto mine = by_weight({&outcome, 1});
  if (!mine.empty()) html += gates_table(mine, name + "-gates", "Gates: " + outcome.study->title(), false);
  return html;
}

std::string section(const Outcome& outcome) {
  const std::string id = anchor(outcome);
  std::string html = fmt::format(
      "<section aria-labelledby=\"{}\">\n<h2 id=\"{}\">{} {}</h2>\n<p><strong>Claimed:</strong> {}. <span "
      "class=\"soft\">verify {}</span></p>\n",
      id, id, escaped(outcome.study->title()), console::html_status(passed(outcome)), html_text(outcome.study->claim()),
      escaped(outcome.study->name()));
  if (!outcome.error.empty())
    html += fmt::format("<p class=\"verdict\"><strong>Broke down:</strong> {}</p>\n", escaped(outcome.error));
  if (outcome.result) {
    if (!outcome.result->verdict.empty())
      html += fmt::format("<p class=\"verdict\"><strong>Found:</strong> {}</p>\n", html_text(outcome.result->verdict));
    for (std::size_t i = 0; i < outcome.pictures.size(); ++i) html += figure(outcome, i);
    html += tables(outcome) + gates(outcome);
  }
  return html + "<p class=\"back\"><a href=\"#contents\">Contents</a></p>\n</section>\n";
}

std::string made(const Facts& made_by) {
  std::string html = "<h2 id=\"made\">How this page was made</h2>\n<dl class=\"facts\">\n";
  for (const auto& [what, value] : made_by)
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(what), escaped(value));
  return html + "</dl>\n";
}

/// What could not be tried here.
std::string skipped(const std::vector<Outcome>& outcomes) {
  std::vector<std::string> all;
  for (const Outcome& o : outcomes)
    if (o.result) all.insert(all.end(), o.result->skipped.begin(), o.result->skipped.end());
  if (all.empty()) return {};
  return fmt::format("<p>Skipped here: {}.</p>\n", escaped(fmt::format("{}", fmt::join(all, ", "))));
}

}  // namespace

std::string report_page(const std::vector<Outcome>& outcomes, const Facts& made_by) {
  const Counts all = counts_of(outcomes);
  const std::size_t broke_down = broken(outcomes);
  const std::string differing = remarks(outcomes);
  std::string body = fmt::format(
      "<div class=\"beside\">\n<header>\n<h1>What Ricochet verified</h1>\n<p class=\"lead\">{} {}</p>\n{}"
      "{}</header>\n{}<main id=\"content\">\n<p>The claims of J. S. Leszczynski, Phys. Rev. E 70, 051315 (2004), on "
      "the "
      "fractional interaction law, and those of this program about itself, measured against bounds that were derived "
      "beforehand.</p>\n{}{}<h2 id=\"gates\">Gates</h2>\n<p>A gate is a number and the bounds that it must keep. What "
      "failed comes first, then what came nearest to its bound. The whole run as <a "
      "href=\"report.json\">report.json</a>.</p>\n{}",
      console::html_status(all.failed == 0 && broke_down == 0), escaped(summary(all, broke_down)), skipped(outcomes),
      lead(outcomes), contents(outcomes, !differing.empty()), overview(outcomes), differing,
      gates_table(by_weight(outcomes), "all-gates", "All gates", true));
  for (const Outcome& outcome : outcomes) body += section(outcome);
  body += fmt::format("{}</main>\n<footer><p>{}. SI units unless a column says otherwise.</p></footer>\n</div>\n",
                      made(made_by), escaped(made_by.front().second));
  return console::html_page("What Ricochet verified: " + summary(all, broke_down), body);
}

}  // namespace ricochet::verify
