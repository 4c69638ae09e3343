#pragma once

#include <console/gnuplot.hpp>
#include <console/plot.hpp>
#include <ricochet/collision/collision.hpp>
#include <ricochet/collision/instant.hpp>

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace ricochet::verify::figures {

/// One motion of a figure; a series of the figure's CSV.
struct Path {
  std::string title;
  std::vector<Instant> points;
  std::string style;  ///< "lines lt 1"
  std::size_t column = 0;
};

/// A quantity of an Instant, as CSV and axes have it.
enum class Quantity { time = 2, overlap, rate, force };  // by the column of the CSV

/// The axes of a row of panels.
struct Axes {
  Quantity x, y;
};

inline constexpr Axes over_time[] = {
    {Quantity::time, Quantity::overlap}, {Quantity::time, Quantity::rate}, {Quantity::time, Quantity::force}};
inline constexpr Axes phases[] = {
    {Quantity::overlap, Quantity::rate}, {Quantity::overlap, Quantity::force}, {Quantity::rate, Quantity::force}};

using Range = std::optional<std::pair<double, double>>;

/// The ranges of a column's axes, in their units; none: of the data.
struct Ranges {
  Range time = {}, overlap = {}, rate = {}, force = {};
};

/// A group of paths, drawn in one column of panels; the key stands in the panel of row `key_row` at `key`.
struct Column {
  std::string title, key;
  std::size_t key_row;
  Ranges ranges = {};
};

/// Style of the i-th path of a group, in `line_colours` colours that differ; `dash` as gnuplot counts them.
inline constexpr std::size_t line_colours = 5;
std::string line(std::size_t i, const std::string& dash = "1");

/// Rows of panels over columns of groups.
console::Figure panels(const std::string& name, const std::string& caption, const std::vector<Path>& paths,
                       std::span<const Axes> rows, const std::vector<Column>& columns);

/// How large a picture is, in pixels of a screen of 96 to the inch, and its letters, to those of other figures.
struct Canvas {
  int width = 960, height = 760;
  double text = 1;
};

/// All paths together in three panels, their key in a fourth.
console::Figure overlaid(const std::string& name, const std::string& caption, const std::vector<Path>& paths,
                         std::span<const Axes, 3> axes, const Ranges& ranges, const Canvas& canvas = {});

/// The closed form from t_b to `until` [s]. At t_b the force of α > 1 is infinite: the first point is left out.
std::vector<Instant> closed_form(const Fractional& law, const Impact& impact, double until);

}  // namespace ricochet::verify::figures
