#include "fit_figure.hpp"

#include <console/number.hpp>
#include <console/table.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::calibration {
namespace {

using console::Table;

/// Laws that say the same at every measured speed.
struct Curve {
  const Fit* fit;
  std::string title;
};

bool same(const Fit& a, const Fit& b) {
  return std::equal(a.predictions.begin(), a.predictions.end(), b.predictions.begin(),
                    [](const Prediction& p, const Prediction& q) {
                      return std::abs(p.en - q.en) < 1e-6 && std::abs(p.tcol - q.tcol) <= 1e-6 * p.tcol;
                    });
}

std::vector<Curve> curves_of(const std::vector<Fit>& fits) {
  std::vector<Curve> curves;
  for (const Fit& fit : fits) {
    const auto twin = std::find_if(curves.begin(), curves.end(), [&](const Curve& c) { return same(*c.fit, fit); });
    if (twin == curves.end())
      curves.push_back({&fit, fit_name(fit.request)});
    else
      twin->title += "; " + fit_name(fit.request);
  }
  return curves;
}

std::vector<console::Column> columns_of(std::vector<console::Column> first, const std::vector<Curve>& curves,
                                        bool times) {
  for (const Curve& curve : curves) {
    first.push_back({"en, " + curve.title});
    if (times) first.push_back({"tcol, " + curve.title, "s"});
  }
  return first;
}

/// The curves between the slowest and the fastest impact.
Table lines(const std::vector<Curve>& curves, const std::vector<Measurement>& data, bool times) {
  constexpr int steps = 100;
  const auto [slowest, fastest] = std::minmax_element(
      data.begin(), data.end(), [](const Measurement& a, const Measurement& b) { return a.velocity < b.velocity; });
  Table table(columns_of({{"velocity", "m/s"}}, curves, times));
  for (int i = 0; i <= steps; ++i) {
    const double v = slowest->velocity * std::pow(fastest->velocity / slowest->velocity, i / double{steps});
    std::vector<console::Cell> row{v};
    for (const Curve& curve : curves) {
      const Prediction p = predict(*curve.fit, v);
      row.push_back(p.en);
      if (times) row.push_back(p.tcol);
    }
    table.row(row);
  }
  return table;
}

/// The measurements, and what each curve leaves over of them, measured − fitted.
Table points(const std::vector<Curve>& curves, const std::vector<Measurement>& data, bool times) {
  Table table(
      columns_of({{"velocity", "m/s"}, {"en"}, {"en_sigma"}, {"tcol", "s"}, {"tcol_sigma", "s"}}, curves, times));
  for (std::size_t i = 0; i < data.size(); ++i) {
    const Measurement& m = data[i];
    std::vector<console::Cell> row{m.velocity, m.en, m.en_sigma, m.tcol, m.tcol_sigma};
    for (const Curve& curve : curves) {
      const Prediction& p = curve.fit->predictions[i];
      row.push_back((m.en - p.en) / (m.en_sigma > 0 ? m.en_sigma : 1));
      if (times) row.push_back((m.tcol - p.tcol) / m.tcol_sigma);
    }
    table.row(row);
  }
  return table;
}

/// gnuplot's choice, but where all values are the same a range around them, which it would warn of.
std::string range_of(const char* axis, const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  std::string range = "[*:*]";
  if (!(*high - *low > 1e-6 * std::abs(*high))) {
    const double room = *high == 0 ? 1 : 0.5 * std::abs(*high);
    range = "[" + console::shortest(*low - room) + ":" + console::shortest(*high + room) + "]";
  }
  return "set " + std::string(axis) + "range " + range + "\n";
}

/// A column of the table, a number in each row.
std::vector<double> column(const Table& table, std::size_t index) {
  std::vector<double> values;
  for (const auto& row : table.rows()) values.push_back(std::get<double>(row[index]));
  return values;
}

/// The panel of one quantity: its column among the points, and how many columns a curve has.
struct Panel {
  std::string label, measured;
  std::size_t offset, stride;
};

std::string upper(const Panel& panel, const Table& measured, const std::vector<Curve>& curves, bool known,
                  bool titled) {
  std::string script = range_of("y", column(measured, 1 + 2 * panel.offset)) + "set ylabel '" + panel.label +
                       "'\nset format x ''\nunset xlabel\nplot 'fit_points.csv' skip 1 using 1:" + panel.measured +
                       (known ? " with yerrorbars" : " with points") + " pt 7 ps 0.6 lc black " +
                       (titled ? "title 'measured'" : "notitle");
  for (std::size_t i = 0; i < curves.size(); ++i)
    script += ", 'fit_lines.csv' skip 1 using 1:" + std::to_string(2 + panel.offset + i * panel.stride) +
              " with lines lw 2 lt " + std::to_string(i + 1) +
              (titled ? " title '" + curves[i].title + "'" : " notitle");
  return script + "\n";
}

std::string lower(const Panel& panel, const Table& measured, const std::vector<Curve>& curves, bool known) {
  std::vector<double> left_over{0};
  for (std::size_t i = 0; i < curves.size(); ++i)
    for (const double value : column(measured, 5 + panel.offset + i * panel.stride)) left_over.push_back(value);
  std::string script = range_of("y", left_over) + "set ylabel '" +
                       std::string(known ? "residual / standard error" : "residual") +
                       "'\nset format x '%g'\nset xlabel 'impact velocity [m/s]'\nplot 0 lc black lw 1 notitle";
  for (std::size_t i = 0; i < curves.size(); ++i)
    script += ", 'fit_points.csv' skip 1 using 1:" + std::to_string(6 + panel.offset + i * panel.stride) +
              " with points pt 7 ps 0.7 lt " + std::to_string(i + 1) + " notitle";
  return script + "\n";
}

std::string finding_of(const std::vector<Fit>& fits) {
  const auto best =
      std::min_element(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.aic < b.aic; });
  std::string text = "By the AIC " + fit_name(best->request) + " fits best";
  for (const Fit& fit : fits)
    if (&fit != &*best)
      text += ", " + fit_name(fit.request) + " is " + console::fixed(fit.aic - best->aic, 1) + " over it";
  return text + ".";
}

}  // namespace

console::Figure figure_of(const std::vector<Fit>& fits, const std::vector<Measurement>& data) {
  const bool known = data.front().en_sigma > 0, times = data.front().tcol > 0;
  const auto curves = curves_of(fits);
  std::vector<Panel> panels{{"restitution", known ? "2:3" : "2", 0, times ? 2u : 1u}};
  if (times) panels.push_back({"collision time [s]", "4:5", 1, 2});
  constexpr int height = 640, line = 20, axis = 60;  // pixels; the key stands under the plots, a line a curve
  const double foot = static_cast<double>(axis + line * (static_cast<int>(curves.size()) + 1)) / height;
  const Table measured = points(curves, data, times);
  std::string script =
      range_of("x", column(measured, 0)) +
      "set logscale x\nset key at screen 0.5,0.01 center bottom vertical maxcols 1\nset multiplot layout 2," +
      std::to_string(panels.size()) + " margins " + (times ? "0.09,0.98," : "0.12,0.97,") + console::fixed(foot, 3) +
      ",0.97 spacing 0.13,0.05\n";
  for (std::size_t i = 0; i < panels.size(); ++i) script += upper(panels[i], measured, curves, known, i == 0);
  for (const Panel& panel : panels) script += lower(panel, measured, curves, known);
  return {"fit",
          "Measured restitution" + std::string(times ? " and collision times" : "") +
              " against impact velocity with the fitted laws; below, what they leave over.",
          script + "unset multiplot\n",
          {{"fit_points.csv", measured.csv()}, {"fit_lines.csv", lines(curves, data, times).csv()}},
          times ? 1000 : 720,
          height,
          finding_of(fits)};
}

}  // namespace ricochet::calibration
