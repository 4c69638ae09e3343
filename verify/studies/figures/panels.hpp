#pragma once

#include <console/plot.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/solvers/fractional_solvers.hpp>
#include <ricochet/collision/trace.hpp>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace ricochet::verify::figures {

/// One curve of a figure, over time; a block of the figure's CSV.
struct Curve {
  std::string title;
  std::vector<Instant> points;
  std::string style;  ///< "with …"
  int panel = 0;      ///< the group of curves that share a column of panels
};

/// The axes of a row of panels: CSV columns 2 t [1e-6 s], 3 overlap [1e-6 m], 4 rate [m/s], 5 force [N].
struct Axes {
  int x, y;
  const char *x_label, *y_label;
};

inline constexpr Axes over_time[] = {
    {2, 3, "t [µs]", "overlap [µm]"}, {2, 4, "t [µs]", "velocity [m/s]"}, {2, 5, "t [µs]", "force [N]"}};
inline constexpr Axes phases[] = {{3, 4, "overlap [µm]", "velocity [m/s]"},
                                  {3, 5, "overlap [µm]", "force [N]"},
                                  {4, 5, "velocity [m/s]", "force [N]"}};

/// A group of curves, drawn in one column of panels; the key stands in the panel of row `key_row` at `key`.
struct Column {
  std::string title, key;
  std::size_t key_row;
};

/// Style of the i-th curve of a group, in colours that differ.
std::string line(std::size_t i);

/// Rows of panels over columns of curve groups.
console::Figure panels(const std::string& name, const std::string& caption, const std::vector<Curve>& curves,
                       std::span<const Axes> rows, const std::vector<Column>& columns);

std::vector<Instant> points_of(const std::vector<Instant>& path);

/// The closed form until the force has fallen to zero, or to `longest` [s] where it never does. At t_b the force of
/// α > 1 is infinite: the first point is left out.
std::vector<Instant> closed_form(const Fractional& law, const Impact& impact, double longest);

}  // namespace ricochet::verify::figures
