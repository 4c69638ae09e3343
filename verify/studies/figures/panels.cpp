#include "panels.hpp"

#include <console/number.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace ricochet::verify::figures {

namespace {

using console::shortest;

/// How a Quantity is shown.
struct Scale {
  const char* label;
  double (*value)(const Instant&);
  Range Ranges::*range;
};

const Scale& scale_of(Quantity quantity) {
  static constexpr Scale scales[] = {
      {"t [µs]", [](const Instant& p) { return 1e6 * p.time; }, &Ranges::time},
      {"overlap [µm]", [](const Instant& p) { return 1e6 * p.overlap; }, &Ranges::overlap},
      {"velocity [m/s]", [](const Instant& p) { return p.rate; }, &Ranges::rate},
      {"force [N]", [](const Instant& p) { return p.force; }, &Ranges::force}};
  return scales[static_cast<std::size_t>(quantity) - static_cast<std::size_t>(Quantity::time)];
}

console::SeriesFile file_of(const std::string& figure, const std::vector<Path>& paths) {
  console::SeriesFile file(figure + ".csv", "curve,t [1e-6 s],overlap [1e-6 m],velocity [m/s],force [N]");
  for (const Path& path : paths) {
    file.begin();
    for (const Instant& p : path.points)
      file.add(fmt::format("\"{}\",{},{},{},{}", path.title, shortest(p.time * 1e6), shortest(p.overlap * 1e6),
                           shortest(p.rate), shortest(p.force)));
  }
  return file;
}

/// The distance of an axis's tics, 1, 2 or 5 times a power of ten: left to itself gnuplot sets so many that their
/// labels touch in a panel of this width.
double tic_step(std::pair<double, double> shown) {
  constexpr double intervals = 6;
  const double least = (shown.second - shown.first) / intervals, power = std::pow(10.0, std::floor(std::log10(least)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= least) return factor * power;
  return 10 * power;
}

/// What paths take of an axis, from 0 on and a little more; what is left below 0 where they end is rounding.
std::pair<double, double> taken(const std::vector<const Path*>& paths, const Scale& scale) {
  double low = 0, high = 0;
  for (const Path* path : paths)
    for (const Instant& p : path->points) {
      low = std::min(low, scale.value(p));
      high = std::max(high, scale.value(p));
    }
  return {low > -1e-9 * high ? 0 : 1.03 * low, 1.03 * high};
}

/// One panel; `first` is the first of all paths, which the file's series are counted from.
console::Panel panel_of(const std::vector<const Path*>& paths, const Path* first, const console::SeriesFile& file,
                        Axes axes, const Ranges& ranges) {
  const auto axis = [&](Quantity quantity, const char* label_offset) {
    const Scale& scale = scale_of(quantity);
    const auto shown = (ranges.*scale.range).value_or(taken(paths, scale));
    return console::Axis{.label = scale.label, .range = shown, .tics = tic_step(shown), .label_offset = label_offset};
  };
  console::Panel panel{.x = axis(axes.x, "0,0.5"), .y = axis(axes.y, "1,0"), .zero_line = true};
  for (const Path* path : paths)
    panel.curves.push_back({.file = file.name(),
                            .rows = file.rows(static_cast<std::size_t>(path - first)),
                            .what = fmt::format("{}:{}", static_cast<int>(axes.x), static_cast<int>(axes.y)),
                            .style = path->style,
                            .title = path->title});
  return panel;
}

}  // namespace

std::string line(std::size_t i, const std::string& dash) {
  constexpr const char* colours[line_colours] = {console::palette::purple, console::palette::blue,
                                                 console::palette::green, console::palette::orange,
                                                 console::palette::vermilion};
  return fmt::format("lines lw 2 dt {} lc rgb '{}'", dash, colours[i % line_colours]);
}

console::Figure panels(const std::string& name, const std::string& caption, const std::vector<Path>& paths,
                       std::span<const Axes> rows, const std::vector<Column>& columns) {
  const console::SeriesFile file = file_of(name, paths);
  const int width = 400 * static_cast<int>(columns.size());
  const double labels = 96.0 / width;  // what the labels of a column need
  console::Plot plot{.layout = console::Layout{.rows = static_cast<int>(rows.size()),
                                               .columns = static_cast<int>(columns.size()),
                                               .left = labels,
                                               .right = 0.96,
                                               .bottom = 0.07,
                                               .top = 0.95,
                                               .between_columns = labels,
                                               .between_rows = 0.075,
                                               .down = true}};
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < columns.size(); ++column) {
      std::vector<const Path*> shown;
      for (const Path& path : paths)
        if (path.column == column) shown.push_back(&path);
      console::Panel panel = panel_of(shown, paths.data(), file, rows[row], columns[column].ranges);
      if (row == 0) panel.title = columns[column].title;
      if (row == columns[column].key_row) panel.key = columns[column].key + " font ',10' samplen 1.5 spacing 1";
      plot.panels.push_back(std::move(panel));
    }
  return {.name = name,
          .caption = caption,
          .plot = plot,
          .data = {file.data()},
          .width = width,
          .height = 320 * static_cast<int>(rows.size())};
}

console::Figure overlaid(const std::string& name, const std::string& caption, const std::vector<Path>& paths,
                         std::span<const Axes, 3> axes, const Ranges& ranges, const Canvas& canvas) {
  const console::SeriesFile file = file_of(name, paths);
  const auto across = [&](double pixels) { return pixels * canvas.text / canvas.width; };
  const auto down = [&](double pixels) { return pixels * canvas.text / canvas.height; };
  std::vector<const Path*> all;
  all.reserve(paths.size());
  for (const Path& path : paths) all.push_back(&path);
  console::Plot plot{.layout = console::Layout{.rows = 2,
                                               .columns = 2,
                                               .left = across(86),
                                               .right = 1 - across(29),
                                               .bottom = down(68),
                                               .top = 1 - down(23),
                                               .between_columns = across(96),
                                               .between_rows = down(91)},
                     .key_panel = fmt::format("at graph 0.02,0.98 left top maxrows 6 font ',{}' spacing 1.4 samplen 3",
                                              13 * canvas.text)};
  for (const Axes& a : axes) plot.panels.push_back(panel_of(all, paths.data(), file, a, ranges));
  return {.name = name,
          .caption = caption,
          .plot = plot,
          .data = {file.data()},
          .width = canvas.width,
          .height = canvas.height,
          .text = canvas.text};
}

std::vector<Instant> closed_form(const Fractional& law, const Impact& impact, double until) {
  const FractionalTrajectory motion(law.coefficient(), law.alpha(), impact.mass_eff, impact.velocity);
  std::vector<Instant> points;
  constexpr int samples = 600;
  for (int i = 0; i <= samples; ++i) {
    const double t = i == 0 && law.alpha() > 1 ? 1e-9 * until : until * i / samples;  // at 0 its force is infinite
    points.push_back({t, motion.overlap(t), motion.rate(t), motion.force(t)});
  }
  return points;
}

}  // namespace ricochet::verify::figures
