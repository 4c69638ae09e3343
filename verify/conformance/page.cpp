#include "page.hpp"

#include "badge.hpp"
#include "causes.hpp"
#include "curves.hpp"
#include "groups.hpp"
#include "matrix.hpp"
#include "show.hpp"

#include <console/html.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

namespace ricochet::verify::conformance {

namespace {

using console::escaped;
using console::html_text;
using console::Table;

std::string anchor(const EngineGrade& e) { return "engine-" + file_stem(e.results); }

std::string contents(const std::vector<EngineGroup>& groups) {
  std::vector<console::HtmlLink> links{{"#engines", "Engines"},
                                       {"#cases", "Cases by engine"},
                                       {"#verdicts", "What the verdicts mean"},
                                       {"#curves", "Errors against steps"},
                                       {"#why", "Why"}};
  for (const EngineGroup& g : groups) links.push_back({"#" + anchor(*g.front()), labels(g)});
  links.insert(links.end(), {{"#sources", "Sources"}, {"#made", "How this page was made"}});
  return console::html_contents(links);
}

/// Families of which every case that was run is right.
std::string right_throughout(const EngineGrade& e) {
  std::vector<std::string> names;
  for (const CaseGrade& c : e.cases) {
    const std::string& family = c.of->family;
    if (std::find(names.begin(), names.end(), family) != names.end()) continue;
    const auto is_in = [&](const CaseGrade& o) { return o.of->family == family; };
    const bool none_wrong = std::none_of(e.cases.begin(), e.cases.end(), [&](const CaseGrade& o) {
      return is_in(o) && o.verdict > Verdict::converges && o.verdict != Verdict::not_run;
    });
    const bool some = std::any_of(e.cases.begin(), e.cases.end(),
                                  [&](const CaseGrade& o) { return is_in(o) && o.verdict <= Verdict::converges; });
    if (none_wrong && some) names.push_back(family);
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The greatest error at a hundred steps of what converges to the answer and was run so; nothing where none was.
std::optional<double> greatest_at_100(const EngineGrade& e) {
  std::optional<double> most;
  for (const CaseGrade& c : e.cases) {
    if (c.verdict != Verdict::converges) continue;
    const std::vector<double>& steps = c.worst()->steps_in_scale;
    const auto at = std::find(steps.begin(), steps.end(), 100);
    if (at != steps.end()) most = std::max(most.value_or(0), c.error_at(static_cast<std::size_t>(at - steps.begin())));
  }
  return most;
}

std::string found(const EngineGrade& e) {
  std::string said =
      fmt::format("{} of the {} cases that it ran converge to the answer or are exact.", e.right(), e.run());
  const std::string families = right_throughout(e);
  if (!families.empty()) said += fmt::format(" All that was run is right in: {}.", families);
  if (const auto most = greatest_at_100(e))
    said += fmt::format(" At 100 steps a collision, what converges is off by {} % of its scale at most.",
                        console::significant(100 * *most, 2));
  for (const auto& [verdict, words] :
       {std::pair(Verdict::another_rule, "By another rule than was asked"),
        std::pair(Verdict::elsewhere, "Converging elsewhere"), std::pair(Verdict::does_not_converge, "Without a limit"),
        std::pair(Verdict::too_coarse, "With steps too coarse to tell")})
    if (e.count(verdict) > 0) said += fmt::format(" {}: {}.", words, e.count(verdict));
  const auto repeated = std::count_if(e.cases.begin(), e.cases.end(), [](const CaseGrade& c) {
    return c.verdict == Verdict::converges && !c.causes.empty() &&
           c.causes.front().what.starts_with(half_a_step_before);
  });
  if (repeated > 0)
    said += fmt::format(
        " In {} of those that converge to it every run was repeated here to rounding by steps whose forces take the "
        "velocity of half a step before: that is where their errors are from.",
        repeated);
  return said;
}

Table grades_of(const EngineGroup& group) {
  const console::Notation two{console::Notation::Kind::scientific, 1};
  Table table({{"case"}, {"verdict"}, {"error, coarsest", "", two}, {"error, finest", "", two}, {"in the limit"}},
              "Grades of " + labels(group));
  for (const CaseGrade& c : group.front()->cases) {
    const Graded* w = c.worst();
    const std::string verdict(text(c.verdict));
    const bool more =
        c.verdict == Verdict::converges || c.verdict == Verdict::elsewhere || c.verdict == Verdict::another_rule;
    table.row({c.of->name, more ? verdict + ", " + in_short(c) : verdict,
               w ? console::Cell(c.error_at(0)) : console::blank(),
               w ? console::Cell(c.error_at(w->error.size() - 1)) : console::blank(), energy_of(c)});
  }
  return table;
}

std::string section(const EngineGroup& group) {
  const EngineGrade& first = *group.front();
  std::string runs, aliases;
  for (const EngineGrade* e : group) {
    runs += fmt::format("<p>{}: run {} by {}.</p>\n", escaped(label(e->results)), escaped(e->results.date),
                        escaped(e->results.by));
    if (e != &first) aliases += fmt::format("<span id=\"{}\"></span>", anchor(*e));
  }
  return fmt::format(
      "<section aria-labelledby=\"{id}\">\n<h2 id=\"{id}\">{title}</h2>{aliases}\n{runs}{same}<p "
      "class=\"verdict\"><strong>Found:</strong> {found}</p>\n{table}<p class=\"back\"><a "
      "href=\"#contents\">Contents</a></p>\n</section>\n",
      fmt::arg("id", anchor(first)), fmt::arg("title", escaped(labels(group))), fmt::arg("aliases", aliases),
      fmt::arg("runs", runs),
      fmt::arg("same", group.size() > 1 ? "<p>All that is shown is the same of these.</p>\n" : ""),
      fmt::arg("found", html_text(found(first))),
      fmt::arg("table",
               console::html_table(grades_of(group), {.id = "grades-" + file_stem(first.results), .shown = 12})));
}

std::string verdicts_explained() {
  const std::string known = console::shortest(100 * least_known);
  const std::string another_rule =
      "|L| is greater, and it is what a rule for tangential springs gives that engines have and say in place of the "
      "one "
      "that was asked";
  const std::string meanings[]{
      "every error is at most f",
      "|L| is at most u + f; h^1.0 is the power of the step that its errors fall with, where one is to be seen",
      fmt::format("so it is, but u is above {} %: finer steps would tell", known),
      another_rule,
      "|L| is greater",
      fmt::format("the values do not settle, and u is above {} %", known),
      fmt::format("the engine cannot run it, or gave fewer than {} runs or too close ones", fewest_runs)};
  std::string html =
      "<h2 id=\"verdicts\">What the verdicts mean</h2>\n<p>Errors are shares of an answer's scale: the speed of "
      "impact, "
      "the collision time. L is the limit of the errors as the step goes to 0, u its uncertainty, f what the answer is "
      "known to, rounding and the digits printed.</p>\n<dl class=\"facts\">\n";
  const char* const signs[]{"✓ exact", "✓ h^1.0", "coarse", "≠ 2 %", "✗ 2 %", "✗ no limit", "–"};
  for (std::size_t i = 0; i < verdicts.size(); ++i)
    html += fmt::format("<dt><span class=\"sign {}\">{}</span>{}</dt><dd>{}</dd>\n", colour_class(verdicts[i]),
                        signs[i], text(verdicts[i]), meanings[i]);
  return html + "</dl>\n";
}

std::string curves(const std::vector<EngineGroup>& groups) {
  const auto figure = error_curves(groups);
  return "<h2 id=\"curves\">Errors against steps</h2>\n" +
         (figure ? console::html_figure(*figure, console::pictures_of(*figure), {})
                 : "<p>No case of these families was run.</p>\n");
}

std::string reason_table(const std::vector<EngineGrade>& engines, const std::vector<Verdict>& of,
                         const std::string& caption, const std::string& id) {
  Table table({{"why"}, {"cases"}, {"engines"}}, caption);
  for (const Reason& r : reasons(engines, of))
    table.row({r.what, fmt::format("{}", fmt::join(r.cases, ", ")), labels(r.engines)});
  return table.rows().empty() ? "" : console::html_table(table, {.id = id, .shown = 100});
}

/// Each reason once, not once a version.
std::string reasons_of(const std::vector<EngineGrade>& engines) {
  return "<h2 id=\"why\">Why</h2>\n" +
         reason_table(engines, {Verdict::another_rule}, "Another rule for tangential springs", "why-rule") +
         reason_table(engines, {Verdict::elsewhere, Verdict::does_not_converge}, "What goes elsewhere",
                      "why-elsewhere") +
         reason_table(engines, {Verdict::not_run}, "What was not run", "why-not-run");
}

std::string sources(const EngineGrade& e) {
  Table table({{"case"}, {"what"}, {"source"}, {"answers by"}}, "The cases and where they are from");
  for (const CaseGrade& c : e.cases) table.row({c.of->name, c.of->title, c.of->source, c.of->how});
  return console::html_table(table, {.id = "sources", .shown = 100});
}

/// The counts, under short heads.
Table counts(const std::vector<EngineGrade>& engines) {
  Table table({{"no"},
               {"engine"},
               {"exact"},
               {"converges"},
               {"coarse"},
               {"other rule"},
               {"elsewhere"},
               {"no limit"},
               {"not run"}},
              "Engines, by the number of cases");
  for (const EngineGrade& e : engines) {
    std::vector<console::Cell> cells{static_cast<std::int64_t>(table.rows().size() + 1), label(e.results)};
    for (const Verdict v : verdicts) cells.push_back(static_cast<std::int64_t>(e.count(v)));
    table.row(cells);
  }
  return table;
}

std::string made(const Facts& made_by) {
  std::string html = "<h2 id=\"made\">How this page was made</h2>\n<dl class=\"facts\">\n";
  for (const auto& [what, value] : made_by)
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(what), escaped(value));
  return html + "</dl>\n";
}

}  // namespace

std::string conformance_page(const std::vector<EngineGrade>& engines, const Facts& made_by) {
  const std::vector<EngineGroup> groups = grouped(engines);
  std::string body = fmt::format(
      "<div class=\"beside\">\n<header>\n<h1>Contact models in engines</h1>\n<p class=\"lead\">{} cases with exact "
      "answers, {} engines.</p>\n</header>\n{}<main id=\"content\">\n<p>Every engine was given the same bodies, laws "
      "and parameters and runs at several time steps; its end states are compared with answers that were computed in "
      "this "
      "run by other means than time steps. An engine that has no such law did not run the case, which says nothing "
      "about it.</p>\n",
      engines.front().cases.size(), engines.size(), contents(groups));
  body += console::html_table(counts(engines), {.id = "engines", .shown = 40}) + matrix(engines) +
          verdicts_explained() + curves(groups) + reasons_of(engines);
  for (const EngineGroup& g : groups) body += section(g);
  body += sources(engines.front()) + made(made_by);
  body += fmt::format("</main>\n<footer><p>{}. SI units unless a column says otherwise.</p></footer>\n</div>\n",
                      escaped(made_by.front().second));
  return console::html_page("Contact models in engines", body, {.style = matrix_style});
}

}  // namespace ricochet::verify::conformance
