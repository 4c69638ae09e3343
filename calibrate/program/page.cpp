#include "page_tangential.hpp"
#include "report.hpp"

#include <calibrate/advice.hpp>
#include <calibrate/export.hpp>
#include <console/gnuplot.hpp>
#include <console/html.hpp>
#include <console/number.hpp>
#include <console/panels.hpp>

#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/trace.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::calibration {
namespace {

using console::escaped;
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
    const Stepping stepping = stepping_of(r.law, r.end);
    all.push_back({title_of(r) + (stepping == Stepping::located ? ", touch located" : ""),
                   step_errors(r.law, r.end, r.request.target, stepping)});
  }
  return all;
}

console::Figure step_figure(const std::vector<Stepped>& all) {
  console::SeriesFile file("steps.csv", "law,steps,error of en");
  console::Panel panel{.x = {.label = "time steps a collision, t_{col}/Δt", .log = true},
                       .y = {.label = "greatest relative error of e_n", .log = true, .format = "%g"},
                       .key = "outside right center"};
  for (std::size_t i = 0; i < all.size(); ++i) {
    file.begin();
    for (const StepError& e : all[i].errors)
      if (e.error > 0) file.add(fmt::format("\"{}\",{},{}", all[i].title, e.steps, console::shortest(e.error)));
    panel.curves.push_back({.file = file.name(),
                            .rows = file.rows(i),
                            .what = "2:3",
                            .style = fmt::format("linespoints lt {} ps 0.7", i % 7 + 1),
                            .title = all[i].title});
  }
  console::Figure figure{
      .name = "steps",
      .caption = "Greatest error of e_n against the number of time steps a collision, as engines step it.",
      .script = console::script_of({.panels = {panel}}),
      .data = {file.data()},
      .width = 960,
      .height = 460};
  const auto last = [](const Stepped& s) { return s.errors.back().steps; };
  const auto worst =
      std::max_element(all.begin(), all.end(), [&](const Stepped& a, const Stepped& b) { return last(a) < last(b); });
  figure.finding = fmt::format("{} wants the most steps: with {} the error is {} %.", worst->title, last(*worst),
                               console::significant(100 * worst->errors.back().error, 2));
  return figure;
}

std::string snippets(const Report& report) {
  std::string html = R"(<h2 id="export">For the engines</h2>
<p>The first law that an engine runs exactly is active, the others are comments.</p>
)";
  for (const Engine engine : engines()) {
    const std::string word(text(engine));
    html += fmt::format("<h3>{}</h3>\n{}", escaped(version(engine)),
                        console::html_code("code-" + word, "Input for " + word, exported(report, engine)));
  }
  return html;
}

std::string head(const Job& job, const std::string& before) {
  return fmt::format(
      R"(<header>
<h1>Contact laws for a measured rebound</h1>
<p class="lead">{} at {} m/s, effective mass {} kg</p>
<p>{}</p>
</header>
<main id="content">
{}<h2 id="parameters">Parameters</h2>
)",
      escaped(asked_text(job)), console::shortest(job.known.impact.velocity),
      console::significant(job.known.impact.mass_eff, 9),
      job.given ? "What a law of these parameters does."
                : "Parameters of every contact law that meet this, proved by an independent numerical collision.",
      before);
}

/// What the laws do: curves, sensitivities, time steps, and the engines' input.
std::string about_laws(const Report& report) {
  const auto all = steppings(report);
  const auto curves = curves_figure(report), steps = step_figure(all);
  return fmt::format(
      R"(<h2 id="curves">The collision</h2>
{}<h2 id="sensitivity">Sensitivity</h2>
{}<h2 id="step">Which time step</h2>
<p>Velocity Verlet as LAMMPS, LIGGGHTS and Yade step it: the force from the position at the end of the step)"
      R"( and the velocity at its middle, a contact found once the bodies overlap. The error is the greatest over)"
      R"( sixteen places of the first touch within a step. liggghts-ricochet and lammps-ricochet locate touch and end.)"
      R"( The table of time steps above is read off these curves, but names no step that those two warn of.</p>
{}{})",
      console::html_figure(curves, console::svg_of(curves), {}),
      console::html_table(sensitivity_table(report), {.id = "sensitivities", .shown = 40}),
      console::html_figure(steps, console::svg_of(steps), {}), snippets(report));
}

}  // namespace

std::string page_of(const Report& report, const std::string& before) {
  std::string body = head(report.job, before);
  const auto tables = tables_of(report);
  for (std::size_t i = 0; i < tables.size(); ++i)
    body += console::html_table(tables[i], {.id = fmt::format("table-{}", i + 1), .shown = 40});
  if (!report.results.empty()) body += about_laws(report);
  body += oblique_section(report);
  body += fmt::format(R"(<h2 id="data">Everything as JSON</h2>
<details><summary>ricochet/calibration/1</summary>
{}</details>
</main>
<footer><p>Ricochet. SI units.</p></footer>
)",
                      console::html_code("code-json", "The calibration as JSON", json_of(report)));
  return console::html_page(fmt::format("Contact laws for {}", asked_text(report.job)), body);
}

}  // namespace ricochet::calibration
