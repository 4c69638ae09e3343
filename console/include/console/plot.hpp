#pragma once

#include <string>
#include <vector>

namespace ricochet::console {

/// Data that a plot draws, written as a file of that name beside it.
struct DataFile {
  std::string name;  ///< for example "fig5.csv"
  std::string bytes;
};

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

/// A plot as gnuplot commands without terminal and output, which draw() sets. The commands name data files without
/// a folder. Set already: `set datafile separator comma`, UTF-8, the palette as line types 1 to 7 (blue, vermilion,
/// green, orange, purple, sky, gray), axes at the left and below, a faint grid.
struct Figure {
  std::string name;     ///< file name without ending
  std::string caption;  ///< what the picture shows, in one sentence
  std::string script;
  std::vector<DataFile> data;
  int width = 720;  ///< pixels
  int height = 450;
  std::string finding = {};  ///< what one sees in it, for those who cannot: sentences made from the numbers of this run
  double text = 1;           ///< size of its letters, to that of the others
};

class OutputFolder;

/// Adds the figure's data, `<name>.svg`, for print `<name>.pdf` and, at 300 dpi, `<name>.png` to the folder; returns
/// the SVG, which follows the reader's choice of light or dark. Throws Failed with gnuplot's own message when it
/// rejects the script, warns or draws nothing, or is not installed.
std::string draw(const Figure& figure, OutputFolder& folder);

/// The SVG alone, no file left behind. Throws as draw() does.
std::string svg_of(const Figure& figure);

/// "gnuplot 5.4 patchlevel 4". Throws Failed when it is not installed.
std::string gnuplot_version();

}  // namespace ricochet::console
