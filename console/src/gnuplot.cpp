#include <console/gnuplot.hpp>
#include <console/number.hpp>
#include <console/table.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace ricochet::console {

namespace {

/// As gnuplot reads a text between single quotes.
std::string quoted(const std::string& text) {
  std::string inside;
  for (const char c : text) inside += c == '\'' ? "''" : std::string(1, c);
  return fmt::format("'{}'", inside);
}

/// Letters of a key in a picture of this width: smaller ones where its longest title and what gnuplot puts beside it
/// would be wider.
std::string font_of_key(const std::vector<Curve>& curves, double width, double letters) {
  constexpr double letter = 0.6, beside = 14;  // of a letter's size; letters
  std::size_t longest = 0;
  for (const Curve& curve : curves) longest = std::max(longest, display_width(curve.title));
  const double fitting = width / (letter * (static_cast<double>(longest) + beside));
  return fitting < letters ? fmt::format(" font ',{}'", fixed(fitting, 1)) : "";
}

std::string tics_of(const Axis& axis) {
  if (axis.names.empty()) return axis.tics ? shortest(*axis.tics) : "autofreq";
  std::vector<std::string> places;
  for (const std::string& text : axis.names) places.push_back(fmt::format("{} {}", quoted(text), places.size()));
  return fmt::format("({})", fmt::join(places, ", "));
}

std::string words_of(char name, const Axis& axis) {
  const std::string range =
      axis.range ? fmt::format("{}:{}", shortest(axis.range->first), shortest(axis.range->second)) : "*:*";
  const std::string label = axis.label.empty()
                                ? fmt::format("unset {}label", name)
                                : fmt::format("set {}label {} offset {}", name, quoted(axis.label), axis.label_offset);
  // A range with 0 is set before the axis becomes logarithmic, or after it has ceased to be.
  return fmt::format(
      "unset logscale {0}\nset {0}range [{1}]\n{2}set format {0} {3}\nset {0}tics {4}\n{5}\n{6}\n", name, range,
      axis.log ? fmt::format("set logscale {}\n", name) : "", axis.format ? quoted(*axis.format) : "", tics_of(axis),
      axis.minor_tics ? fmt::format("set m{}tics default", name) : fmt::format("unset m{}tics", name), label);
}

std::string words_of(const Curve& curve, bool titled) {
  std::string source = curve.what;
  if (!curve.file.empty()) {
    const std::string rows = curve.rows ? fmt::format(" every ::{}::{}", curve.rows->first, curve.rows->last) : "";
    source = fmt::format("{} skip 1{} using {}", quoted(curve.file), rows, curve.what);
  }
  const std::string title = titled && !curve.title.empty() ? fmt::format("title {}", quoted(curve.title)) : "notitle";
  return fmt::format("{} with {} {}", source, curve.style, title);
}

std::string words_of(const std::vector<Curve>& curves, bool titled) {
  std::vector<std::string> all;
  all.reserve(curves.size());
  for (const Curve& curve : curves) all.push_back(words_of(curve, titled));
  return fmt::format("plot {}\n", fmt::join(all, ", \\\n  "));
}

std::string words_of(const std::vector<Polygon>& polygons) {
  std::string words = "unset object\n";
  for (const Polygon& p : polygons) {
    std::vector<std::string> corners;
    for (const auto& [x, y] : p.corners) corners.push_back(fmt::format("{},{}", shortest(x), shortest(y)));
    corners.push_back(corners.front());
    words += fmt::format("set object polygon from {} {}\n", fmt::join(corners, " to "), p.style);
  }
  return words;
}

std::string words_of(const std::vector<Label>& labels) {
  std::string words = "unset label\n";
  for (const Label& l : labels)
    words += fmt::format("set label {} at {},{} {}\n", quoted(l.text), shortest(l.x), shortest(l.y), l.style);
  return words;
}

std::string share(double value) { return fixed(value, 3); }

std::string words_of(const Box& box) {
  return fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset bmargin at screen {}\nset tmargin at "
      "screen {}\n",
      share(box.left), share(box.right), share(box.bottom), share(box.top));
}

/// All but its curves.
std::string surroundings_of(const Panel& panel) {
  return (panel.box ? words_of(*panel.box) : "") +
         (panel.title.empty() ? "unset title\n" : fmt::format("set title {} offset 0,-0.5\n", quoted(panel.title))) +
         words_of('x', panel.x) + words_of('y', panel.y) + words_of(panel.labels) + words_of(panel.polygons) +
         (panel.key.empty() ? "unset key\n" : fmt::format("set key {}\n", panel.key)) +
         (panel.room.empty() ? "unset offsets\n" : fmt::format("set offsets {}\n", panel.room)) +
         (panel.zero_line ? "set xzeroaxis lt 1 lc rgb 'black' lw 0.7\n" : "unset xzeroaxis\n") +
         (panel.equal_scales ? "set size ratio -1\n" : "set size noratio\n");
}

std::string words_of(const Panel& panel) { return surroundings_of(panel) + words_of(panel.curves, !panel.key.empty()); }

/// A key needs curves to stand for: these, with nothing to draw.
std::string key_alone(std::vector<Curve> curves, const std::string& place) {
  for (Curve& curve : curves) curve = {.what = "NaN", .style = curve.style, .title = curve.title};
  const Axis unit{.range = std::pair(0.0, 1.0)};
  return surroundings_of({.x = unit, .y = unit, .key = place}) + "unset border\nunset tics\nunset grid\n" +
         words_of(curves, true);
}

std::string words_of(const Layout& layout) {
  return fmt::format("set multiplot layout {},{} margins {},{},{},{} spacing {},{}\n", layout.rows, layout.columns,
                     share(layout.left), share(layout.right), share(layout.bottom), share(layout.top),
                     share(layout.between_columns), share(layout.between_rows));
}

}  // namespace

Rows SeriesFile::rows(std::size_t series) const {
  const std::size_t first = begins_.at(series), end = series + 1 < begins_.size() ? begins_[series + 1] : rows_;
  if (first == end) throw std::logic_error(fmt::format("{}: series {} has no rows", name_, series));
  return {first, end - 1};
}

Plot with_key_below(Panel panel, int rows, double below) {
  panel.key = fmt::format("at screen 0.5,0.01 center bottom maxrows {}", rows);
  return {.panels = {std::move(panel)}, .layout = Layout{.left = 0.1, .right = 0.97, .bottom = below, .top = 0.96}};
}

Plot with_keys_within(Plot plot, double width, double letters) {
  for (Panel& panel : plot.panels)
    if (!panel.key.empty()) panel.key += font_of_key(panel.curves, width, letters);
  if (!plot.key_panel.empty())
    plot.key_panel += font_of_key(plot.key.empty() ? plot.panels.front().curves : plot.key, width, letters);
  return plot;
}

std::string script_of(const Plot& plot) {
  const bool several = plot.layout || plot.panels.front().box;
  std::string script = plot.layout ? words_of(*plot.layout) : several ? "set multiplot\n" : "";
  for (const Panel& panel : plot.panels) script += words_of(panel);
  if (!plot.key_panel.empty())
    script += key_alone(plot.key.empty() ? plot.panels.front().curves : plot.key, plot.key_panel);
  return several ? script + "unset multiplot\n" : script;
}

}  // namespace ricochet::console
