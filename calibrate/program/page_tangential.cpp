#include "page_tangential.hpp"

#include <console/gnuplot.hpp>
#include <console/html.hpp>
#include <console/law_colour.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace ricochet::calibration {
namespace {

using console::Notation;
using console::Table;

constexpr double degree = std::numbers::pi / 180;

/// One curve of e_t over the angle.
struct Line {
  std::string title;
  std::vector<ObliqueRebound> rebounds;
  std::string style = {};
};

std::vector<Line> lines_of_laws(const Report& report) {
  std::vector<Line> lines;
  for (std::size_t i = 0; i < report.results.size(); ++i)
    if (!report.tangential[i].rebounds.empty())
      lines.push_back({fmt::format("{}, {}", name(report.results[i].law), text(report.results[i].end)),
                       report.tangential[i].rebounds});
  std::vector<std::string> titles;
  titles.reserve(lines.size());
  for (const Line& line : lines) titles.push_back(line.title);
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].style = console::law_line(titles, i);
  return lines;
}

/// The first law with another β₀ or μ, where its form has it.
std::vector<Line> lines_of_inputs(const Report& report) {
  const Calibration& r = report.results.front();
  const TangentialRequest& asked = *report.job.tangential;
  const double beta0 = report.tangential.front().found.beta0, mu = *asked.mu;
  std::vector<Line> lines;
  const auto add = [&](std::optional<double> other, double friction) {
    TangentialRequest request = asked;
    if (other) request.beta0 = other;
    const auto outcome = calibrate_tangential(request, r.law, r.end, r.request.target);
    const auto* found = std::get_if<TangentialCalibration>(&outcome);
    if (!found) return;
    try {
      lines.push_back({fmt::format("β_0 = {}, μ = {}", console::significant(other.value_or(beta0), 3),
                                   console::significant(friction, 3)),
                       rebounds(found->law, friction, r.law, r.end, r.request.target.impact, usual_angles())});
    } catch (const NotConverged&) {  // a dashpot too weak to be followed there: no line
    }
  };
  add({}, mu);
  for (const double step : {-0.3, 0.3}) add(beta0 + step, mu);
  for (const double factor : {0.5, 2.0}) add({}, factor * mu);
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i].style = fmt::format("lt {}", i + 1);
  return lines;
}

/// `middle`: of its key, which stands under it, as a share of the picture's width.
console::Panel panel_of(const std::string& title, double middle, const std::vector<Line>& lines,
                        console::SeriesFile& data) {
  console::Panel panel{.title = title,
                       .x = {.label = "angle from the normal [deg]", .range = std::pair(0.0, 90.0)},
                       .y = {.label = "e_t of the centre", .range = std::pair(0.0, 1.05)},  // 3/7 is the least
                       .key = fmt::format("at screen {},0.01 center bottom vertical maxcols 1", middle)};
  for (std::size_t i = 0; i < lines.size(); ++i) {
    data.begin();
    for (const ObliqueRebound& r : lines[i].rebounds)
      data.add(
          fmt::format("\"{}\",{},{}", lines[i].title, console::shortest(r.angle / degree), console::shortest(r.et)));
    panel.curves.push_back({.file = data.name(),
                            .rows = data.rows(i),
                            .what = "2:3",
                            .style = fmt::format("linespoints {} lw 2 pt 7 ps 0.4", lines[i].style),
                            .title = lines[i].title});
  }
  return panel;
}

console::Figure figure_of(const Report& report) {
  console::SeriesFile laws("oblique_laws.csv", "law,angle [deg],et"),
      inputs("oblique_inputs.csv", "inputs,angle [deg],et");
  const auto of_laws = lines_of_laws(report), of_inputs = lines_of_inputs(report);
  constexpr int height = 420, axis = 90;  // pixels; a line of the keys is a curve
  const int key = console::key_line * static_cast<int>(std::max(of_laws.size(), of_inputs.size()));
  const double foot = static_cast<double>(axis + key) / (height + key);
  const console::Plot plot{
      .panels = {panel_of("every law", 0.32, of_laws, laws), panel_of(of_laws.front().title, 0.77, of_inputs, inputs)},
      .layout = console::Layout{
          .rows = 1, .columns = 2, .left = 0.1, .right = 0.98, .bottom = foot, .top = 0.94, .between_columns = 0.1}};
  const auto& first = of_laws.front().rebounds;
  const auto least = std::min_element(first.begin(), first.end(),
                                      [](const ObliqueRebound& a, const ObliqueRebound& b) { return a.et < b.et; });
  return {.name = "oblique",
          .caption = "Tangential restitution of the centre against the angle of impact, without spin before it.",
          .plot = plot,
          .data = {laws.data(), inputs.data()},
          .width = 1000,
          .height = height + key,
          .finding = fmt::format("Under {} the centre keeps least of its tangential speed at {} degrees, {}.",
                                 of_laws.front().title, console::significant(least->angle / degree, 3),
                                 console::significant(least->et, 4))};
}

Table sensitivity_table(const Report& report) {
  const Notation four{Notation::Kind::fixed, 6};
  Table table({{"angle", "deg", {Notation::Kind::significant, 3}},
               {"tcol", "", four},
               {"en", "", four},
               {"beta0", "", four},
               {"mu", "", four}},
              "Change of e_t for one percent more of each; tcol and en with the tangential law as it is");
  const Calibration& r = report.results.front();
  const std::array angles{5 * degree, 20 * degree, 35 * degree, 50 * degree, 65 * degree, 80 * degree};
  try {
    for (const ObliqueSensitivity& s : sensitivities(report.tangential.front().found, *report.job.tangential,
                                                     LawKind::of(r.law), r.end, r.request.target, angles))
      table.row({s.angle / degree, s.tcol, s.en, s.beta0, s.mu});
  } catch (const std::invalid_argument&) {  // e_n = 1 or β₀ at its end cannot be moved both ways
    table.note("not told where en or beta0 stands at the end of its range");
  } catch (const NotConverged&) {
    table.note("not told where a dashpot is too weak for its sliding to be followed");
  }
  return table;
}

}  // namespace

std::string oblique_section(const Report& report) {
  if (report.tangential.empty() || report.tangential.front().rebounds.empty()) return "";
  const auto figure = figure_of(report);
  return fmt::format(
      "<p>{}</p>\n{}{}",
      console::html_text("At the same speed along the normal; on the right the first law with other inputs. With beta0 "
                         "held, e_t does not know t_col, mu and e_n show where it slides."),
      console::html_figure(figure, console::pictures_of(figure), {}),
      console::html_table(sensitivity_table(report), {.id = "oblique-sensitivities", .shown = 40}));
}

}  // namespace ricochet::calibration
