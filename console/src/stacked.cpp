#include "stacked.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ricochet::console {

namespace {

// Pixels; a screen of 390 shows them about as they are.
constexpr int width = 420, left = 110;
constexpr int right = 24;              ///< holds half of the last number of an axis, of five digits
constexpr int above = 14, title = 24;  ///< over a panel, and what its title needs

const Layout& layout_of(const Plot& plot) {
  static const Layout alone{.bottom = 0.15, .top = 0.95};
  return plot.layout ? *plot.layout : alone;
}

/// The panel with what its neighbours' axes say for it.
Panel whole(const Plot& plot, std::size_t at) {
  Panel panel = plot.panels[at];
  const auto columns = static_cast<std::size_t>(layout_of(plot).columns);
  for (std::size_t below = at + columns; panel.x.label.empty() && below < plot.panels.size(); below += columns)
    panel.x = plot.panels[below].x;
  for (std::size_t before = at; panel.y.label.empty() && before % columns > 0;)
    panel.y.label = plot.panels[--before].y.label;
  return panel;
}

/// As one reads them.
std::vector<Panel> in_order(const Plot& plot) {
  const auto columns = static_cast<std::size_t>(layout_of(plot).columns);
  std::vector<Panel> panels;
  if (!layout_of(plot).down)
    for (std::size_t i = 0; i < plot.panels.size(); ++i) panels.push_back(whole(plot, i));
  else
    for (std::size_t column = 0; column < columns; ++column)
      for (std::size_t i = column; i < plot.panels.size(); i += columns) panels.push_back(whole(plot, i));
  return panels;
}

int titled(const std::vector<Curve>& curves) {
  return static_cast<int>(std::count_if(curves.begin(), curves.end(), [](const Curve& c) { return !c.title.empty(); }));
}

/// The lines of the key that stands under the panel, where it covers nothing: its own, or that of all.
int lines_under(const Plot& plot, const Panel& panel, bool first) {
  if (!panel.key.empty()) return titled(panel.curves);
  return first && !plot.key_panel.empty() ? titled(plot.key.empty() ? panel.curves : plot.key) : 0;
}

/// The height of one panel between its axes, as it was.
int height_of_panel(const Figure& figure) {
  const Layout& l = layout_of(figure.plot);
  return static_cast<int>(figure.height * (l.top - l.bottom - (l.rows - 1) * l.between_rows) / l.rows / figure.text);
}

/// Where the axes of a panel begin and end, and where it does; pixels from above.
struct Place {
  int top, bottom, end;
};

}  // namespace

Figure stacked(const Figure& figure) {
  Figure narrow = figure;
  std::vector<Panel> panels = in_order(figure.plot);
  std::vector<Place> rows;
  int height = 0;
  for (const Panel& panel : panels) {
    const int top = height + above + (panel.title.empty() ? 0 : title), bottom = top + height_of_panel(figure);
    height = bottom + axis_room + key_line * lines_under(figure.plot, panel, rows.empty());
    rows.push_back({top, bottom, height});
  }
  const auto up = [height](int pixels) { return 1 - static_cast<double>(pixels) / height; };
  std::string key_of_all;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const auto [top, bottom, end] = rows[i];
    panels[i].box = Box{.left = static_cast<double>(left) / width,
                        .right = static_cast<double>(width - right) / width,
                        .bottom = up(bottom),
                        .top = up(top)};
    if (end == bottom + axis_room) continue;
    const std::string key = fmt::format(
        "at screen 0.5,{:.3f} center bottom vertical maxcols 1 reverse Left spacing 1.2 samplen 2", up(end));
    (panels[i].key.empty() ? key_of_all : panels[i].key) = key;
  }
  narrow.width = width;
  narrow.height = height;
  narrow.text = 1;
  narrow.plot = {.panels = std::move(panels), .key_panel = key_of_all, .key = figure.plot.key};
  return narrow;
}

}  // namespace ricochet::console
