#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ricochet::console {

// A plot in types, and the one place where it becomes a script of gnuplot. Words of gnuplot's own stand only where it
// has a language that no list of ours would be better than: columns, styles, the place of a key.

/// Data that a plot draws, written as a file of that name beside it.
struct DataFile {
  std::string name;  ///< for example "fig5.csv"
  std::string bytes;
};

struct Axis {
  std::string label = {};
  bool log = false;
  std::optional<std::pair<double, double>> range = {};  ///< without: gnuplot's choice
  std::optional<std::string> format = {};               ///< of the numbers, as printf; "" leaves them out
  std::optional<double> tics = {};      ///< their distance, on a log axis the factor; without: gnuplot's choice
  bool minor_tics = true;               ///< as gnuplot has them: on a log axis
  std::string label_offset = "0,0";     ///< in characters
  std::vector<std::string> names = {};  ///< in place of numbers, at 0, 1, 2, …
};

/// Rows of a file, counted from 0 below its header, first and last included.
struct Rows {
  std::size_t first = 0, last = 0;
};

/// A CSV of several series one below another, which a column names, and the rows that each series has.
class SeriesFile {
 public:
  SeriesFile(std::string name, const std::string& header) : name_(std::move(name)), bytes_(header + "\n") {}

  /// The rows from here on are the next series.
  void begin() { begins_.push_back(rows_); }
  void add(const std::string& row) {
    bytes_ += row + "\n";
    ++rows_;
  }

  /// Throws std::logic_error for a series without rows, which could not be drawn.
  Rows rows(std::size_t series) const;
  const std::string& name() const { return name_; }
  DataFile data() const { return {name_, bytes_}; }

 private:
  std::string name_, bytes_;
  std::vector<std::size_t> begins_ = {};
  std::size_t rows_ = 0;
};

/// Columns of one of the figure's data files, of which the first line is a header; or, without a file, an expression.
struct Curve {
  std::string file = {};
  std::optional<Rows> rows = {};  ///< those to draw; without: all
  std::string what = {};          ///< the columns, "1:3" or "($2*1e3):5", or the expression, "0"
  std::string style = {};         ///< "lines lt 1 lw 2"
  std::string title = {};         ///< in the key of a panel that has one
};

/// Words at a place of the axes; `style` is where they stand to it and their colour, "right tc rgb '#767676'".
struct Label {
  std::string text = {};
  double x = 0, y = 0;
  std::string style = {};
};

/// A closed line through corners of the axes' numbers.
struct Polygon {
  std::vector<std::pair<double, double>> corners = {};
  std::string style = {};  ///< "fs solid 0.15 fc lt 1"
};

/// Where a panel's axes stand; shares of the picture.
struct Box {
  double left = 0, right = 1, bottom = 0, top = 1;
};

struct Panel {
  std::optional<Box> box = {};  ///< without: as the layout has it
  std::string title = {};
  Axis x = {}, y = {};
  std::vector<Curve> curves = {};
  std::string key = {};    ///< where it stands, "outside right center"; without: there is none
  std::string room = {};   ///< around what an axis without a range must hold, "graph 0,0.02,0.03,0"
  bool zero_line = false;  ///< a black line at y = 0
  std::vector<Label> labels = {};
  std::vector<Polygon> polygons = {};
  bool equal_scales = false;  ///< a unit is as long on x as on y
};

/// Panels in rows, from the left above; all measures are shares of the picture.
struct Layout {
  int rows = 1, columns = 1;
  double left = 0, right = 1, bottom = 0, top = 1;  ///< edges of the whole
  double between_columns = 0, between_rows = 0;
  bool down = false;  ///< one reads its columns first
};

struct Plot {
  std::vector<Panel> panels = {};  ///< one, where there is no layout and they have no boxes
  std::optional<Layout> layout = {};
  std::string key_panel = {};   ///< the place in one panel more, without axes, of a key
  std::vector<Curve> key = {};  ///< to these; without: to the first panel's curves
};

/// A panel that is the whole picture, with its key below it in rows, clear of the axis's label; `below` is the share
/// of the picture's height that both take.
Plot with_key_below(Panel panel, int rows, double below);

/// The plot with its keys in smaller letters where a title would be too wide for a picture of this width with letters
/// of this size, both in pixels: gnuplot takes a letter for 0.6 of its size, and leaves out a key that it takes to be
/// wider than the picture.
Plot with_keys_within(Plot plot, double width, double letters);

/// The script of a Figure. Every panel says all that is said about it, nothing stays from the one before.
std::string script_of(const Plot& plot);

}  // namespace ricochet::console
