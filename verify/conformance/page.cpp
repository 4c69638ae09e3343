#include "page.hpp"

#include "badge.hpp"
#include "show.hpp"

#include <console/html.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::conformance {

namespace {

using console::escaped;
using console::html_text;
using console::Table;

std::string anchor(const EngineGrade& e) { return "engine-" + file_stem(e.results); }

std::string contents(const std::vector<EngineGrade>& engines) {
  std::vector<console::HtmlLink> links{
      {"#engines", "Engines"}, {"#verdicts", "What the verdicts mean"}, {"#cases", "Cases by engine"}};
  for (const EngineGrade& e : engines) links.push_back({"#" + anchor(e), label(e.results)});
  links.insert(links.end(), {{"#sources", "Sources"}, {"#made", "How this page was made"}});
  return console::html_contents(links);
}

/// Families of which every case that was run is right.
std::string right_throughout(const EngineGrade& e) {
  std::vector<std::string> names;
  for (const CaseGrade& c : e.cases) {
    const std::string& family = c.of->family;
    if (std::find(names.begin(), names.end(), family) != names.end()) continue;
    const auto in_family = [&](const CaseGrade& o) { return o.of->family == family; };
    const bool none_wrong = std::none_of(e.cases.begin(), e.cases.end(), [&](const CaseGrade& o) {
      return in_family(o) && (o.verdict == Verdict::elsewhere || o.verdict == Verdict::does_not_converge);
    });
    const bool some = std::any_of(e.cases.begin(), e.cases.end(),
                                  [&](const CaseGrade& o) { return in_family(o) && o.verdict <= Verdict::converges; });
    if (none_wrong && some) names.push_back(family);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The greatest error at about a hundred steps of what converges to the answer.
double greatest_at_100(const EngineGrade& e) {
  double most = 0;
  for (const CaseGrade& c : e.cases) {
    if (c.verdict != Verdict::converges) continue;
    const std::vector<double>& steps = c.worst()->steps_in_scale;
    const auto at = std::find_if(steps.begin(), steps.end(), [](double n) { return n >= 100; });
    if (at != steps.end()) most = std::max(most, c.error_at(static_cast<std::size_t>(at - steps.begin())));
  }
  return most;
}

std::string found(const EngineGrade& e) {
  std::string said =
      fmt::format("{} of the {} cases that it ran converge to the answer or are exact.", e.right(), e.run());
  const std::string families = right_throughout(e);
  if (!families.empty()) said += fmt::format(" All that was run is right in: {}.", families);
  if (e.count(Verdict::converges) > 0)
    said += fmt::format(" At 100 steps a collision, what converges is off by {} % of its scale at most.",
                        console::significant(100 * greatest_at_100(e), 2));
  const std::size_t elsewhere = e.count(Verdict::elsewhere), wander = e.count(Verdict::does_not_converge);
  if (elsewhere > 0) said += fmt::format(" Converging elsewhere: {}.", elsewhere);
  if (wander > 0) said += fmt::format(" Without a limit: {}.", wander);
  return said;
}

Table grades_of(const EngineGrade& e) {
  const console::Notation two{console::Notation::Kind::scientific, 1};
  Table table({{"case"}, {"verdict"}, {"error, coarsest", "", two}, {"error, finest", "", two}, {"why"}},
              "Grades of " + label(e.results));
  for (const CaseGrade& c : e.cases) {
    const Graded* w = c.worst();
    table.row({c.of->name,
               c.verdict == Verdict::converges   ? "converges to it, " + in_short(c)
               : c.verdict == Verdict::elsewhere ? "converges elsewhere, " + in_short(c)
                                                 : std::string(text(c.verdict)),
               w ? console::Cell(c.error_at(0)) : console::blank(),
               w ? console::Cell(c.error_at(w->error.size() - 1)) : console::blank(), why(c)});
  }
  return table;
}

std::string section(const EngineGrade& e) {
  const std::string id = anchor(e);
  return fmt::format(
      "<section aria-labelledby=\"{id}\">\n<h2 id=\"{id}\">{title}</h2>\n<p>Run {date} by {by}.</p>\n<p "
      "class=\"verdict\"><strong>Found:</strong> {found}</p>\n{table}<p class=\"back\"><a "
      "href=\"#contents\">Contents</a></p>\n</section>\n",
      fmt::arg("id", id), fmt::arg("title", escaped(label(e.results))), fmt::arg("date", escaped(e.results.date)),
      fmt::arg("by", escaped(e.results.by)), fmt::arg("found", html_text(found(e))),
      fmt::arg("table", console::html_table(grades_of(e), {.id = "grades-" + file_stem(e.results), .shown = 60})));
}

std::string verdicts() {
  return fmt::format(
      "<h2 id=\"verdicts\">What the verdicts mean</h2>\n<p>Errors are shares of an answer's scale: the speed of "
      "impact, "
      "the collision time. L is the limit of the errors as the step goes to 0, u its uncertainty, f what the answer is "
      "known to and rounding.</p>\n<dl class=\"facts\">\n<dt>exact</dt><dd>every error is at most f</dd>\n"
      "<dt>converges to it</dt><dd>|L| is at most u + f</dd>\n<dt>steps too coarse</dt><dd>so it is, but u is above "
      "{0} %: finer steps would tell</dd>\n"
      "<dt>converges elsewhere</dt><dd>|L| is greater</dd>\n"
      "<dt>does not converge</dt><dd>the values do not settle, and u is above {0} %</dd>\n"
      "<dt>not run</dt><dd>the engine cannot run it, or gave fewer than {1} runs or too close ones</dd>\n</dl>\n",
      console::shortest(100 * least_known), fewest_runs);
}

std::string sources(const EngineGrade& e) {
  Table table({{"case"}, {"what"}, {"source"}, {"answers by"}}, "The cases and where they are from");
  for (const CaseGrade& c : e.cases) table.row({c.of->name, c.of->title, c.of->source, c.of->how});
  return console::html_table(table, {.id = "sources", .shown = 100});
}

std::string made(const Facts& made_by) {
  std::string html = "<h2 id=\"made\">How this page was made</h2>\n<dl class=\"facts\">\n";
  for (const auto& [what, value] : made_by)
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(what), escaped(value));
  return html + "</dl>\n";
}

}  // namespace

std::string conformance_page(const std::vector<EngineGrade>& engines, const Facts& made_by) {
  std::string body = fmt::format(
      "<div class=\"beside\">\n<header>\n<h1>Contact models in engines</h1>\n<p class=\"lead\">{} cases with exact "
      "answers, {} engines.</p>\n</header>\n{}<main id=\"content\">\n<p>Every engine was given the same bodies, laws "
      "and "
      "parameters and runs at several time steps; its end states are compared with answers that were computed in this "
      "run by other means than time steps. An engine that has no such law did not run the case, which says nothing "
      "about it.</p>\n{}{}{}",
      engines.front().cases.size(), engines.size(), contents(engines),
      console::html_table(engine_table(engines), {.id = "engines", .shown = 40}), verdicts(),
      console::html_table(side_by_side(engines, Heads::names), {.id = "cases", .shown = 100}));
  for (const EngineGrade& e : engines) body += section(e);
  body += sources(engines.front()) + made(made_by);
  body += fmt::format("</main>\n<footer><p>{}. SI units unless a column says otherwise.</p></footer>\n</div>\n",
                      escaped(made_by.front().second));
  return console::html_page("Contact models in engines", body);
}

}  // namespace ricochet::verify::conformance
