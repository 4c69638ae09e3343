#pragma once

#include <string>
#include <vector>

namespace ricochet::console {

/// Data that a plot draws, written as a file of that name beside it.
struct DataFile {
  std::string name;  ///< for example "fig5.csv"
  std::string bytes;
};

/// A plot as gnuplot commands without terminal and output, which draw() sets. The commands name data files without
/// a folder and separate CSV columns by `set datafile separator comma`, which is set already.
struct Figure {
  std::string name;     ///< file name without ending
  std::string caption;  ///< what the picture shows, in one sentence
  std::string script;
  std::vector<DataFile> data;
  int width = 720;  ///< pixels
  int height = 450;
};

/// Writes the figure's data, `<name>.svg` and `<name>.png` into the folder (made if missing), each atomically.
/// Throws Failed with gnuplot's own message when it rejects the script, warns or draws nothing, or is not installed.
void draw(const Figure& figure, const std::string& folder);

}  // namespace ricochet::console
