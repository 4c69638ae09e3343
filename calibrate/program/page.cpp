#include "page_input.hpp"
#include "page_tangential.hpp"
#include "report.hpp"

#include <calibrate/advice.hpp>
#include <console/gnuplot.hpp>
#include <console/html.hpp>
#include <console/law_colour.hpp>
#include <console/number.hpp>
#include <console/panels.hpp>

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/trace.hpp>
#include <ricochet/version.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::calibration {
namespace {

using console::Notation;
using console::Table;

std::string title_of(const Calibration& r) { return fmt::format("{}, ended by {}", name(r.law), text(r.end)); }

/// The curves of one law up to the end of its contact; those of the fractional law are the closed form.
struct Curves {
  const Target& target;
  double tcol;

  template <class Law>
  std::vector<console::Moment> operator()(const Law& law) const {
    constexpr std::size_t steps = 2000, every = 10;
    std::vector<console::Moment> moments;
    const auto points = trace(law, target.impact, tcol, steps);
    for (std::size_t i = 0; i < points.size(); i += every)
      moments.push_back({points[i].time, points[i].overlap, points[i].rate, points[i].force});
    return moments;
  }
  template <RemembersAll Law>
  std::vector<console::Moment> operator()(const Law& law) const {
    return (*this)(arms_of_collision(law, tcol));
  }
  std::vector<console::Moment> operator()(const Fractional& law) const {
    constexpr int samples = 200;
    const FractionalTrajectory motion(law.coefficient(), law.alpha(), target.impact.mass_eff, target.impact.velocity);
    std::vector<console::Moment> moments;
    for (int i = 0; i <= samples; ++i) {
      const double t = tcol * i / samples;
      moments.push_back({t, motion.overlap(t), motion.rate(t), motion.force(t)});
    }
    return moments;
  }
};

console::Figure curves_figure(const Report& report) {
  std::vector<console::Motion> motions;
  const Calibration *least = nullptr, *most = nullptr;
  for (const Calibration& r : report.results) {
    motions.push_back({title_of(r), std::visit(Curves{r.request.target, r.achieved.tcol}, r.law)});
    if (!least || r.achieved.max_force < least->achieved.max_force) least = &r;
    if (!most || r.achieved.max_force > most->achieved.max_force) most = &r;
  }
  auto figure = console::collision_panels(
      "collision", "Overlap, velocity and force during the collision, under every law.", motions);
  if (motions.size() == 1) {
    figure.caption = fmt::format("Overlap, velocity and force during the collision: {}.", title_of(*most));
    figure.finding =
        fmt::format("It ends after {} s, and the greatest force is {} N.", console::significant(most->achieved.tcol, 3),
                    console::significant(most->achieved.max_force, 3));
    return figure;
  }
  figure.finding = fmt::format("{} the greatest force ranges from {} N ({}) to {} N ({}).",
                               std::holds_alternative<scale::CollisionTime>(report.job.known.scale) && !report.job.given
                                   ? "All laws end after the same time with the same velocity; on the way"
                                   : "The laws take times of their own;",
                               console::significant(least->achieved.max_force, 3), title_of(*least),
                               console::significant(most->achieved.max_force, 3), title_of(*most));
  return figure;
}

Table sensitivity_table(const Report& report) {
  const Notation three{Notation::Kind::fixed, 3};
  Table table({{"law"}, {"end"}, {"parameter"}, {"tcol changes by", "%", three}, {"en changes by", "%", three}},
              "What one percent more of a parameter does");
  for (const Calibration& r : report.results)
    for (const Sensitivity& s : sensitivities(r.law, r.end, report.job.known.impact))
      table.row({std::string(name(r.law)), std::string(text(r.end)), s.parameter.name,
                 s.tcol ? console::Cell(*s.tcol) : console::blank(), s.en ? console::Cell(*s.en) : console::blank()});
  return table;
}

/// The errors of one law by its way of stepping.
struct Stepped {
  std::string title;
  std::vector<StepError> errors;
};

/// Laws that remember all, ended by force, as the drivers step them, which alone run them.
std::vector<Stepped> steppings(const Report& report) {
  std::vector<Stepped> all;
  for (const Calibration& r : report.results) {
    all.push_back({fmt::format("{}, {}", name(r.law), text(r.end)),
                   step_errors(r.law, r.end, r.request.target, stepping_of(r.law, r.end))});
  }
  return all;
}

/// Somewhat more than the least and the greatest of positive numbers.
std::pair<double, double> around(const std::vector<double>& numbers) {
  const auto [least, greatest] = std::minmax_element(numbers.begin(), numbers.end());
  return {*least / 1.3, *greatest * 1.3};
}

console::Figure step_figure(const std::vector<Stepped>& all) {
  console::SeriesFile file("steps.csv", "law,steps,error of en");
  console::Panel panel;
  std::vector<std::string> titles;
  std::vector<double> steps, errors;
  for (const Stepped& s : all) {
    file.begin();
    titles.push_back(s.title);
    for (const StepError& e : s.errors) {
      if (!(e.error > 0)) continue;
      file.add(fmt::format("\"{}\",{},{}", s.title, e.steps, console::shortest(e.error)));
      steps.push_back(e.steps);
      errors.push_back(e.error);
    }
  }
  for (std::size_t i = 0; i < all.size(); ++i)
    panel.curves.push_back({.file = file.name(),
                            .rows = file.rows(i),
                            .what = "2:3",
                            .style = fmt::format("linespoints {} lw 2 pt 7 ps 0.6", console::law_line(titles, i)),
                            .title = titles[i]});
  panel.x = {.label = "time steps a collision, t_{col}/Δt", .log = true, .range = around(steps)};
  panel.y = {.label = "greatest relative error of e_n", .log = true, .range = around(errors), .format = "%g"};
  const int rows = (static_cast<int>(all.size()) + 1) / 2;
  console::Figure figure{
      .name = "steps",
      .caption = "Greatest error of e_n against the number of time steps a collision, as engines step it.",
      .plot = console::with_key_below(panel, rows, 0.15 + 0.045 * rows),
      .data = {file.data()},
      .width = 960,
      .height = 560};
  const auto last = [](const Stepped& s) { return s.errors.back().steps; };
  const auto worst =
      std::max_element(all.begin(), all.end(), [&](const Stepped& a, const Stepped& b) { return last(a) < last(b); });
  figure.finding = fmt::format("{} wants the most steps: with {} the error is {} %.", worst->title, last(*worst),
                               console::significant(100 * worst->errors.back().error, 2));
  return figure;
}

/// What the page is: nothing in it was measured, but for what a fit begins with.
std::string heading_of(const Job& job) {
  return job.given ? fmt::format("What the law {} does", asked_text(job))
                   : fmt::format("Contact laws calibrated for {}", asked_text(job));
}

std::string lead_of(const Report& report) {
  const Impact& impact = report.job.known.impact;
  const std::size_t laws = report.results.size(), missed = report.infeasible.size() + report.failed.size();
  std::string lead =
      fmt::format("Computed, at {} m/s with an effective mass of {} kg: ", console::shortest(impact.velocity),
                  console::significant(impact.mass_eff, 9));
  lead += fmt::format("{} {} by an independent numerical collision",
                      laws == 1 ? "one contact law" : fmt::format("{} contact laws", laws),
                      report.job.given ? "followed"
                      : laws == 1      ? "found, and proved"
                                       : "found, and each proved");
  return lead + (missed ? fmt::format("; {} out of reach.", missed) : ".");
}

/// A part of the page under a heading of its own.
struct Section {
  std::string id, title, html;
};

std::string drawn(const console::Figure& figure) {
  return console::html_figure(figure, console::pictures_of(figure), {});
}

std::string parameters_of(const Report& report) {
  std::string html;
  const auto tables = tables_of(report);
  for (std::size_t i = 0; i < tables.size(); ++i)
    html += console::html_table(tables[i], {.id = fmt::format("table-{}", i + 1), .shown = 40});
  return html;
}

constexpr const char* about_steps =
    "<p>Velocity Verlet as LAMMPS, LIGGGHTS and Yade step it: the force from the position at the end of the step and "
    "the velocity at its middle, a contact found once the bodies overlap. The error is the greatest over eighteen "
    "places of the first touch within a step. liggghts-ricochet and lammps-ricochet locate touch and end. The table of "
    "time steps above is read off these curves, but names no step that those two warn of.</p>\n";

std::string as_json(const Report& report) {
  return fmt::format("<details><summary>ricochet/calibration/1</summary>\n{}</details>\n",
                     console::html_code("code-json", "The calibration as JSON", json_of(report)));
}

/// Those that have something to say.
std::vector<Section> sections_of(const Report& report, const PageStart& start) {
  const bool any = !report.results.empty();
  std::vector<Section> all{
      {"fit", "The fit", start.section},
      {"parameters", "Parameters", parameters_of(report)},
      {"curves", "The collision", any && !start.figure.empty() ? drawn(curves_figure(report)) : ""},
      {"export", "For the engines", input_section(report)},
      {"step", "Which time step", any ? about_steps + drawn(step_figure(steppings(report))) : ""},
      {"sensitivity", "Sensitivity",
       any ? console::html_table(sensitivity_table(report), {.id = "sensitivities", .shown = 40}) : ""},
      {"oblique", "Oblique impacts", oblique_section(report)},
      {"data", "Everything as JSON", as_json(report)}};
  std::erase_if(all, [](const Section& section) { return section.html.empty(); });
  return all;
}

/// The first screen: what it is, how it looks, how it is made again.
std::string head(const Report& report, const PageStart& start, const std::string& heading) {
  const bool own = start.figure.empty() && !report.results.empty();
  return fmt::format("<header>\n<h1>{}</h1>\n<p class=\"lead\">{}</p>\n{}{}</header>\n", console::html_text(heading),
                     console::html_text(lead_of(report)), own ? drawn(curves_figure(report)) : start.figure,
                     console::html_code("command", "The command that makes this page", start.command));
}

}  // namespace

std::string page_of(const Report& report, const PageStart& start) {
  const std::string heading = start.heading.empty() ? heading_of(report.job) : start.heading;
  std::vector<console::HtmlLink> contents;
  std::string sections;
  for (const auto& [id, title, html] : sections_of(report, start)) {
    contents.push_back({"#" + id, title});
    sections += fmt::format("<h2 id=\"{}\">{}</h2>\n{}<p class=\"back\"><a href=\"#contents\">Contents</a></p>\n", id,
                            title, html);
  }
  return console::html_page(heading, fmt::format("<div class=\"beside\">\n{}{}<main id=\"content\">\n{}</main>\n"
                                                 "<footer><p>Ricochet {}. SI units.</p></footer>\n</div>\n",
                                                 head(report, start, heading), console::html_contents(contents),
                                                 sections, ricochet::version));
}

}  // namespace ricochet::calibration
