#include "panels.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ricochet::verify::figures {

namespace {

using console::shortest;

std::string csv_of(const std::vector<Curve>& curves) {
  std::string csv = "curve,t [1e-6 s],overlap [1e-6 m],velocity [m/s],force [N]\n";
  for (const Curve& curve : curves) {
    if (&curve != &curves.front()) csv += "\n\n";
    for (const Instant& p : curve.points)
      csv += fmt::format("\"{}\",{},{},{},{}\n", curve.title, shortest(p.time * 1e6), shortest(p.overlap * 1e6),
                         shortest(p.rate), shortest(p.force));
  }
  return csv;
}

double coordinate(const Instant& p, int column) {
  return column == 2 ? 1e6 * p.time : column == 3 ? 1e6 * p.overlap : column == 4 ? p.rate : p.force;
}

/// The distance of an axis's tics, 1, 2 or 5 times a power of ten: left to itself gnuplot sets so many that their
/// labels touch in a panel of this width.
double tic_step(const std::vector<Curve>& curves, int panel, int column) {
  double low = 0, high = 0;
  for (const Curve& curve : curves) {
    if (curve.panel != panel) continue;
    for (const Instant& p : curve.points) {
      low = std::min(low, coordinate(p, column));
      high = std::max(high, coordinate(p, column));
    }
  }
  constexpr double intervals = 6;
  const double least = (high - low) / intervals, power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least) return factor * power;
  return 10 * power;
}

/// The curves of one panel.
std::string plot(const std::string& file, const std::vector<Curve>& curves, int panel, const Axes& axes) {
  std::string text;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].panel != panel) continue;
    text += fmt::format("{}'{}' {}index {} using {}:{} {} title '{}'", text.empty() ? "plot " : ", \\\n  ", file,
                        i == 0 ? "skip 1 " : "", i, axes.x, axes.y, curves[i].style, curves[i].title);
  }
  return text + "\n";
}

}  // namespace

std::string line(std::size_t i) {
  constexpr const char* colours[] = {console::palette::purple, console::palette::blue, console::palette::green,
                                     console::palette::orange, console::palette::vermilion};
  return fmt::format("with lines lw 2 lc '{}'", colours[i % std::size(colours)]);
}

console::Figure panels(const std::string& name, const std::string& caption, const std::vector<Curve>& curves,
                       std::span<const Axes> rows, const std::vector<Column>& columns) {
  const std::string file = name + ".csv";
  std::string script = fmt::format(
      "set multiplot layout {},{} margins {},0.96,0.07,0.95 spacing 0.08,0.075\nset key font ',10' samplen 1.5 "
      "spacing 1\nset xzeroaxis lt 1 lc rgb 'black' lw 0.6\nset title font ',15'\n",
      rows.size(), columns.size(), columns.size() == 1 ? "0.13" : "0.08");
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < columns.size(); ++column) {
      const Axes& axes = rows[row];
      const int panel = static_cast<int>(column);
      script += fmt::format(
          "set title '{}'\nset key {}\nset xlabel '{}' offset 0,0.5\nset ylabel '{}' offset 1,0\nset xtics {}\n",
          row == 0 ? columns[column].title : "", row == columns[column].key_row ? columns[column].key : "off",
          axes.x_label, axes.y_label, shortest(tic_step(curves, panel, axes.x)));
      script += plot(file, curves, panel, axes);
    }
  return {.name = name,
          .caption = caption,
          .script = script + "unset multiplot\n",
          .data = {{file, csv_of(curves)}},
          .width = columns.size() == 1 ? 640 : 400 * static_cast<int>(columns.size()),
          .height = 320 * static_cast<int>(rows.size())};
}

std::vector<Instant> points_of(const std::vector<Instant>& path) {
  std::vector<Instant> points;
  points.reserve(path.size());
  for (const Instant& s : path) points.push_back({s.time, s.overlap, s.rate, s.force});
  return points;
}

std::vector<Instant> closed_form(const Fractional& law, const Impact& impact, double longest) {
  const FractionalTrajectory motion(law.coefficient(), law.alpha(), impact.mass_eff, impact.velocity);
  std::vector<Instant> points;
  constexpr int samples = 600;
  for (int i = law.alpha() > 1 ? 1 : 0; i <= samples; ++i) {
    const double t = longest * i / samples;
    points.push_back({t, motion.overlap(t), motion.rate(t), motion.force(t)});
    if (i > 1 && points.back().force <= 0) break;
  }
  return points;
}

}  // namespace ricochet::verify::figures
