#include "show.hpp"

#include "case_json.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace ricochet::verify::conformance {

namespace {

using console::Json;
using console::Notation;
using console::Table;

std::int64_t whole(std::size_t n) { return static_cast<std::int64_t>(n); }

std::string percent(double share) {
  return (share < 1 ? console::significant(100 * share, 2) : console::fixed(100 * share, 0)) + " %";
}

/// What the printed digits leave open where they are most of what does.
std::string of_digits(const CaseGrade& grade) {
  const Graded* most = nullptr;
  for (const Graded& g : grade.answers)
    if (g.answer.required && 2 * g.digits > g.floor && (!most || g.digits > most->digits)) most = &g;
  return most ? fmt::format("the digits printed leave {} open", percent(most->digits)) : "";
}

console::Cell number_of(const Graded* g, double Graded::*member) {
  return g ? console::number_or_blank(g->*member) : console::blank();
}

/// Of the errors of the two usual steppings.
std::string expected_of(const Case& c) { return fmt::format("{:g} or {:g}", c.orders.leapfrog, c.orders.located); }

Json json(const Graded& g) {
  Json steps = Json::array(), errors = Json::array();
  for (std::size_t i = 0; i < g.error.size(); ++i)
    steps.push_back(static_cast<int>(g.steps_in_scale[i])), errors.push_back(g.error[i]);
  return {{"quantity", name(g.answer.quantity)},
          {"body", g.answer.body},
          {"required", g.answer.required},
          {"verdict", text(g.verdict)},
          {"value", g.answer.value},
          {"scale", g.answer.scale},
          {"steps", steps},
          {"errors", errors},
          {"limit", g.limit.value},
          {"uncertainty", g.limit.uncertainty},
          {"floor", g.floor},
          {"digits", g.digits},
          {"order", console::number_or_null(g.order)},
          {"order_uncertainty", console::number_or_null(g.order_uncertainty)}};
}

Json json(const CaseGrade& grade) {
  Json answers = Json::array(), causes = Json::array();
  for (const Graded& g : grade.answers) answers.push_back(json(g));
  for (const Cause& c : grade.causes)
    causes.push_back({{"cause", c.what},
                      {"repeated", c.repeated},
                      {"as_asked", c.as_asked},
                      {"rule", c.rule},
                      {"misfit", c.misfit}});
  Json energy = nullptr;
  if (grade.energy)
    energy = {{"exact", grade.energy->exact},
              {"limit", grade.energy->limit},
              {"uncertainty", grade.energy->uncertainty},
              {"coarsest", grade.energy->coarsest},
              {"finest", grade.energy->finest}};
  return {{"case", grade.of->name},
          {"family", grade.of->family},
          {"verdict", text(grade.verdict)},
          {"note", grade.note},
          {"expected_order", to_json(grade.of->orders)},
          {"answers", answers},
          {"energy", energy},
          {"causes", causes}};
}

}  // namespace

std::string label(const Results& results) { return fmt::format("{} {}", results.engine, results.version); }

std::string in_short(const CaseGrade& grade) {
  const Graded* worst = grade.worst();
  if (grade.verdict == Verdict::exact) return "exact";
  if (grade.verdict == Verdict::converges)
    return worst->order_uncertainty <= 0.5 ? fmt::format("order {}", console::fixed(worst->order, 1)) : "converges";
  if (grade.verdict == Verdict::too_coarse) return "steps too coarse";
  if (grade.verdict == Verdict::elsewhere || grade.verdict == Verdict::another_rule)
    return "off by " + percent(std::abs(worst->limit.value));
  return grade.verdict == Verdict::not_run ? "not run" : "does not converge";
}

std::string cause_of(const CaseGrade& grade) {
  if (grade.verdict == Verdict::not_run) return grade.note;
  std::string said;
  for (const Cause& c : grade.causes) said += (said.empty() ? "" : "; or, equally well: ") + c.what;
  return said.empty() && grade.verdict >= Verdict::elsewhere ? "no known cause fits" : said;
}

std::string sign_of(const CaseGrade& grade) {
  const Graded* worst = grade.worst();
  switch (grade.verdict) {
    case Verdict::exact: return "✓ exact";
    case Verdict::converges: return worst->order_uncertainty <= 0.5 ? "✓ h^" + console::fixed(worst->order, 1) : "✓";
    case Verdict::too_coarse: return "coarse";
    case Verdict::another_rule: return "≠ " + percent(std::abs(worst->limit.value));
    case Verdict::elsewhere: return "✗ " + percent(std::abs(worst->limit.value));
    case Verdict::does_not_converge: return "✗ no limit";
    case Verdict::not_run: break;
  }
  return "–";
}

std::string energy_of(const CaseGrade& grade) {
  if (!grade.energy || grade.verdict == Verdict::exact) return {};
  const double by = grade.energy->limit - grade.energy->exact;
  if (grade.energy->made()) return percent(by) + " of the energy too much";
  if (grade.energy->lost()) return percent(-by) + " of the energy too little";
  return {};
}

std::string why(const CaseGrade& grade) {
  if (grade.verdict == Verdict::not_run) return grade.note;
  std::string said = cause_of(grade);
  for (const std::string& more : {energy_of(grade), of_digits(grade), grade.note})
    if (!more.empty()) said += (said.empty() ? "" : "; ") + more;
  return said;
}

Table engine_table(const std::vector<EngineGrade>& engines) {
  Table table({{"no"},
               {"engine"},
               {"version"},
               {"date"},
               {"exact"},
               {"converges to it"},
               {"steps too coarse"},
               {"another rule"},
               {"converges elsewhere"},
               {"does not converge"},
               {"not run"}},
              "Engines, by the number of cases");
  for (const EngineGrade& e : engines)
    table.row({static_cast<std::int64_t>(table.rows().size() + 1), e.results.engine, e.results.version, e.results.date,
               whole(e.count(Verdict::exact)), whole(e.count(Verdict::converges)), whole(e.count(Verdict::too_coarse)),
               whole(e.count(Verdict::another_rule)), whole(e.count(Verdict::elsewhere)),
               whole(e.count(Verdict::does_not_converge)), whole(e.count(Verdict::not_run))});
  return table;
}

Table side_by_side(const std::vector<EngineGrade>& engines) {
  std::vector<console::Column> columns{{"case"}};
  while (columns.size() <= engines.size()) columns.push_back({std::to_string(columns.size())});
  Table table(columns, "Cases by engine");
  for (std::size_t i = 0; !engines.empty() && i < engines.front().cases.size(); ++i) {
    std::vector<console::Cell> cells{engines.front().cases[i].of->name};
    for (const EngineGrade& e : engines)
      cells.push_back(e.cases[i].verdict == Verdict::not_run ? console::blank() : console::Cell(sign_of(e.cases[i])));
    table.row(cells);
  }
  table.note(
      "✓: right, converges to the answer, its errors falling with this power of the step h where one is to be seen (of "
      "the number that is farthest off). ≠: goes by another rule for tangential springs than was asked, off by this "
      "share of the answer's scale. ✗: converges elsewhere, off by so much. coarse: "
      "finer "
      "steps would tell. -: not run.");
  return table;
}

Table grade_table(const std::vector<EngineGrade>& engines) {
  const Notation two{Notation::Kind::scientific, 1};
  Table table({{"engine"},
               {"version"},
               {"case"},
               {"verdict"},
               {"quantity"},
               {"body"},
               {"error_coarsest", "", two},
               {"error_finest", "", two},
               {"limit", "", two},
               {"uncertainty", "", two},
               {"order", "", {Notation::Kind::fixed, 2}},
               {"order_expected"},
               {"energy_exact", "", {Notation::Kind::fixed, 4}},
               {"energy_limit", "", {Notation::Kind::fixed, 4}},
               {"why"}},
              "Grades");
  for (const EngineGrade& e : engines)
    for (const CaseGrade& c : e.cases) {
      const Graded* w = c.worst();
      table.row({e.results.engine, e.results.version, c.of->name, std::string(text(c.verdict)),
                 w ? console::Cell(std::string(name(w->answer.quantity))) : console::blank(),
                 w ? console::Cell(whole(w->answer.body)) : console::blank(),
                 w ? console::Cell(w->error.front()) : console::blank(),
                 w ? console::Cell(w->error.back()) : console::blank(),
                 w ? console::Cell(w->limit.value) : console::blank(),
                 w ? console::Cell(w->limit.uncertainty) : console::blank(), number_of(w, &Graded::order),
                 expected_of(*c.of), c.energy ? console::Cell(c.energy->exact) : console::blank(),
                 c.energy ? console::Cell(c.energy->limit) : console::blank(), why(c)});
    }
  return table;
}

Table cause_table(const std::vector<EngineGrade>& engines) {
  Table table({{"engine"}, {"case"}, {"verdict"}, {"why"}}, "What goes elsewhere, and which known cause fits");
  for (const EngineGrade& e : engines)
    for (const CaseGrade& c : e.cases)
      if (c.verdict >= Verdict::another_rule && c.verdict != Verdict::not_run)
        table.row({label(e.results), c.of->name, in_short(c), why(c)});
  return table;
}

Json to_json(const EngineGrade& engine) {
  Json cases = Json::array(), counts = Json::object();
  for (const CaseGrade& c : engine.cases) cases.push_back(json(c));
  for (const Verdict v : verdicts) counts[std::string(text(v))] = engine.count(v);
  return {{"engine", engine.results.engine},
          {"version", engine.results.version},
          {"date", engine.results.date},
          {"by", engine.results.by},
          {"verdicts", counts},
          {"cases", cases}};
}

}  // namespace ricochet::verify::conformance
