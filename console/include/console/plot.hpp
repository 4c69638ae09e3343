#pragma once

#include <console/gnuplot.hpp>

#include <string>
#include <vector>

namespace ricochet::console {

/// Okabe and Ito's colours, which readers with any colour vision tell apart. In the SVG each has a lighter partner
/// that a dark page shows instead.
namespace palette {
inline constexpr const char* black = "#000000";
inline constexpr const char* blue = "#0072b2";
inline constexpr const char* vermilion = "#d55e00";
inline constexpr const char* green = "#009e73";
inline constexpr const char* orange = "#e69f00";
inline constexpr const char* purple = "#cc79a7";
inline constexpr const char* sky = "#56b4e9";
inline constexpr const char* gray = "#767676";
}  // namespace palette

inline constexpr double letters = 14;                ///< of a Figure, pixels
inline constexpr int axis_room = 68, key_line = 25;  ///< with such: under a panel with a label, a line of a key; pixels

/// A plot that is shown: on a screen, in print, in a page. Line types 1 to 7 are the palette (blue, vermilion, green,
/// orange, purple, sky, gray); axes stand at the left and below, on a faint grid.
struct Figure {
  std::string name;     ///< file name without ending
  std::string caption;  ///< what the picture shows, in one sentence
  Plot plot;
  std::vector<DataFile> data = {};
  int width = 720;  ///< pixels
  int height = 450;
  std::string finding = {};  ///< what one sees in it, for those who cannot: sentences made from the numbers of this run
  double text = 1;           ///< size of its letters, to `letters`
};

/// A figure as SVG that follows the reader's choice of light or dark.
struct Pictures {
  std::string wide;
  std::string narrow;  ///< its panels one below another, for a phone
};

class OutputFolder;

/// Adds the figure's data, `<name>.svg`, for print `<name>.pdf` and, at 300 dpi, `<name>.png` to the folder; returns
/// what a page shows of it. Throws Failed with gnuplot's own message when it rejects the plot, warns or draws nothing,
/// or is not installed.
Pictures draw(const Figure& figure, OutputFolder& folder);

/// The pictures alone, no file left behind. Throws as draw() does.
Pictures pictures_of(const Figure& figure);

/// "gnuplot 5.4 patchlevel 4". Throws Failed when it is not installed.
std::string gnuplot_version();

}  // namespace ricochet::console
