#include "fit_figure.hpp"

#include <console/gnuplot.hpp>
#include <console/law_colour.hpp>
#include <console/number.hpp>
#include <console/table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace ricochet::calibration {
namespace {

using console::Table;

/// Laws that say the same at every measured speed.
struct Line {
  const Fit* fit;
  std::string title;
};

bool same(const Fit& a, const Fit& b) {
  return std::equal(a.predictions.begin(), a.predictions.end(), b.predictions.begin(),
                    [](const Prediction& p, const Prediction& q) {
                      return std::abs(p.en - q.en) < 1e-6 && std::abs(p.tcol - q.tcol) <= 1e-6 * p.tcol;
                    });
}

std::vector<Line> lines_of(const std::vector<Fit>& fits) {
  std::vector<Line> curves;
  for (const Fit& fit : fits) {
    const auto twin = std::find_if(curves.begin(), curves.end(), [&](const Line& c) { return same(*c.fit, fit); });
    if (twin == curves.end())
      curves.push_back({&fit, fit_name(fit.request)});
    else
      twin->title += fmt::format("; {}", fit_name(fit.request));
  }
  return curves;
}

std::vector<console::Column> columns_of(std::vector<console::Column> first, const std::vector<Line>& curves,
                                        bool times) {
  for (const Line& curve : curves) {
    first.push_back({fmt::format("en, {}", curve.title)});
    if (times) first.push_back({fmt::format("tcol, {}", curve.title), "s"});
  }
  return first;
}

/// The curves between the slowest and the fastest impact.
Table lines(const std::vector<Line>& curves, const std::vector<Measurement>& data, bool times) {
  constexpr int steps = 100;
  const auto [slowest, fastest] = std::minmax_element(
      data.begin(), data.end(), [](const Measurement& a, const Measurement& b) { return a.velocity < b.velocity; });
  Table table(columns_of({{"velocity", "m/s"}}, curves, times));
  for (int i = 0; i <= steps; ++i) {
    const double v = slowest->velocity * std::pow(fastest->velocity / slowest->velocity, i / double{steps});
    std::vector<console::Cell> row{v};
    for (const Line& curve : curves) {
      const Prediction p = predict(*curve.fit, v);
      row.push_back(p.en);
      if (times) row.push_back(p.tcol);
    }
    table.row(row);
  }
  return table;
}

/// The measurements, and what each curve leaves over of them, measured − fitted.
Table points(const std::vector<Line>& curves, const std::vector<Measurement>& data, bool times) {
  Table table(
      columns_of({{"velocity", "m/s"}, {"en"}, {"en_sigma"}, {"tcol", "s"}, {"tcol_sigma", "s"}}, curves, times));
  for (std::size_t i = 0; i < data.size(); ++i) {
    const Measurement& m = data[i];
    std::vector<console::Cell> row{m.velocity, m.en, m.en_sigma, m.tcol, m.tcol_sigma};
    for (const Line& curve : curves) {
      const Prediction& p = curve.fit->predictions[i];
      row.push_back((m.en - p.en) / (m.en_sigma > 0 ? m.en_sigma : 1));
      if (times) row.push_back((m.tcol - p.tcol) / m.tcol_sigma);
    }
    table.row(row);
  }
  return table;
}

/// gnuplot's choice, but where all values are the same a range around them, which it would warn of.
std::optional<std::pair<double, double>> range_of(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (*high - *low > 1e-6 * std::abs(*high)) return std::nullopt;
  const double room = *high == 0 ? 1 : 0.5 * std::abs(*high);
  return std::pair(*low - room, *high + room);
}

/// A column of the table, a number in each row.
std::vector<double> column(const Table& table, std::size_t index) {
  std::vector<double> values;
  for (const auto& row : table.rows()) values.push_back(std::get<double>(row[index]));
  return values;
}

/// One quantity: its columns among the points, the first of them counted from that of en, and how many columns a
/// curve has.
struct Quantity {
  std::string label, measured;
  std::size_t offset, stride;
};

/// The title as far as a key has room for it.
std::string key_of(const Line& curve) {
  constexpr std::size_t room = 60;
  if (curve.title.size() <= room) return curve.title;
  const std::size_t end = curve.title.rfind(';', room);
  const auto more = std::count(curve.title.begin() + static_cast<std::ptrdiff_t>(end), curve.title.end(), ';');
  return fmt::format("{} and {} more", curve.title.substr(0, end), more);
}

/// That of the first law of the curve.
std::string colour_of(const Line& curve) {
  return fmt::format("lc rgb '{}'", console::law_colour(fit_name(curve.fit->request)));
}

/// What was measured, and every curve.
console::Panel upper(const Quantity& of, const Table& measured, const std::vector<Line>& curves, bool known,
                     const std::string& key) {
  console::Panel panel{.x = {.log = true, .range = range_of(column(measured, 0)), .format = ""},
                       .y = {.label = of.label, .range = range_of(column(measured, 1 + 2 * of.offset))},
                       .curves = {{.file = "fit_points.csv",
                                   .what = fmt::format("1:{}", of.measured),
                                   .style = fmt::format("{} pt 7 ps 0.6 lc black", known ? "yerrorbars" : "points"),
                                   .title = "measured"}},
                       .key = key};
  for (std::size_t i = 0; i < curves.size(); ++i)
    panel.curves.push_back({.file = "fit_lines.csv",
                            .what = fmt::format("1:{}", 2 + of.offset + i * of.stride),
                            .style = fmt::format("lines lw 2 {}{}", colour_of(curves[i]),
                                                 curves[i].fit->request.alpha_of_speed ? " dt 2" : ""),
                            .title = key_of(curves[i])});
  return panel;
}

/// What the curves leave over.
console::Panel lower(const Quantity& of, const Table& measured, const std::vector<Line>& curves, bool known) {
  std::vector<double> left_over{0};
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const double value : column(measured, 5 + of.offset + i * of.stride)) left_over.push_back(value);
  console::Panel panel{
      .x = {.label = "impact velocity [m/s]", .log = true, .range = range_of(column(measured, 0)), .format = "%g"},
      .y = {.label = known ? "residual / standard error" : "residual", .range = range_of(left_over)},
      .curves = {{.what = "0", .style = "lines lc black lw 1"}}};
  for (std::size_t i = 0; i < curves.size(); ++i)
    panel.curves.push_back({.file = "fit_points.csv",
                            .what = fmt::format("1:{}", 6 + of.offset + i * of.stride),
                            .style = fmt::format("points pt {} ps 0.7 {}",
                                                 curves[i].fit->request.alpha_of_speed ? 6 : 7, colour_of(curves[i]))});
  return panel;
}

}  // namespace

console::Figure figure_of(const std::vector<Fit>& fits, const std::vector<Measurement>& data) {
  const bool known = data.front().en_sigma > 0, times = data.front().tcol > 0;
  const auto curves = lines_of(fits);
  std::vector<Quantity> quantities{{"restitution", known ? "2:3" : "2", 0, times ? 2u : 1u}};
  if (times) quantities.push_back({"collision time [s]", "4:5", 1, 2});
  constexpr int plots = 500, below = 8;  // pixels; under the plots stands the key, a line a curve
  const int key_height = console::key_line * (static_cast<int>(curves.size()) + 1);
  const int foot = console::axis_room + key_height + below, height = plots + foot;
  const Table measured = points(curves, data, times);
  console::Plot plot{.layout = console::Layout{.rows = 2,
                                               .columns = static_cast<int>(quantities.size()),
                                               .left = times ? 0.09 : 0.14,
                                               .right = times ? 0.98 : 0.97,
                                               .bottom = static_cast<double>(foot) / height,
                                               .top = 0.97,
                                               .between_columns = 0.13,
                                               .between_rows = 0.05,
                                               .down = true}};
  std::string key = fmt::format("at screen 0.5,{:.4f} center bottom vertical maxcols 1",
                                static_cast<double>(below) / height);  // the first panel's, for all
  for (const Quantity& q : quantities) plot.panels.push_back(upper(q, measured, curves, known, std::exchange(key, "")));
  for (const Quantity& q : quantities) plot.panels.push_back(lower(q, measured, curves, known));
  return {"fit",
          fmt::format("Measured restitution{} against impact velocity with the fitted laws; below, what they leave "
                      "over.",
                      times ? " and collision times" : ""),
          plot,
          {{"fit_points.csv", measured.csv()}, {"fit_lines.csv", lines(curves, data, times).csv()}},
          times ? 1000 : 720,
          height,
          preference_text(fits)};
}

}  // namespace ricochet::calibration
