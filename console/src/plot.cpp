#include "svg_theme.hpp"

#include <console/child.hpp>
#include <console/exit.hpp>
#include <console/output.hpp>
#include <console/plot.hpp>
#include <console/scratch.hpp>

#include <fmt/format.h>

#include <sys/wait.h>

#include <cstring>

namespace ricochet::console {

namespace {

Ran gnuplot(const std::string& script, const std::string& folder) {
  Ran ran = run({.arguments = {"gnuplot", "-d"}, .folder = folder, .input = script});
  if (!ran.found) throw Failed("gnuplot: not found; Debian's package is gnuplot-nox");
  return ran;
}

/// What all figures share. Grid and axes stay behind the data; line types are the palette.
constexpr const char* house_style = R"(set encoding utf8
set datafile separator comma
set border 3 lc rgb 'black' lw 1
set tics nomirror out scale 0.5
set grid back lt 1 lc rgb '#dddddd' lw 0.7, lt 1 lc rgb '#dddddd' lw 0.7
set key reverse Left spacing 1.2 samplen 2
set linetype 1 lc rgb '#0072b2' lw 2 pt 7
set linetype 2 lc rgb '#d55e00' lw 2 pt 5
set linetype 3 lc rgb '#009e73' lw 2 pt 9
set linetype 4 lc rgb '#e69f00' lw 2 pt 13
set linetype 5 lc rgb '#cc79a7' lw 2 pt 11
set linetype 6 lc rgb '#56b4e9' lw 2 pt 6
set linetype 7 lc rgb '#767676' lw 2 pt 4
set linetype cycle 7
)";

std::string why(const Ran& failed) {
  if (!failed.err.empty()) return failed.err;
  if (WIFSIGNALED(failed.status)) return fmt::format("ended by a signal: {}", ::sigdescr_np(WTERMSIG(failed.status)));
  return "nothing drawn";
}

/// Whether gnuplot complains about the script, "line 12: warning: Skipping data file with no valid points", which it
/// ends with 0 on. Words of others on stderr (a fontconfig without its files) are no failure.
bool complains(const std::string& words) {
  for (auto at = words.find("line "); at != std::string::npos; at = words.find("line ", at + 1)) {
    const auto end = words.find_first_not_of("0123456789", at + 5);
    if (end != at + 5 && end != std::string::npos && words[end] == ':') return true;
  }
  return false;
}

std::string picture(const Figure& figure, std::string_view terminal, const std::string& folder) {
  const Ran ran = gnuplot(fmt::format("set terminal {} size {},{}\n{}{}\n", terminal, figure.width, figure.height,
                                      house_style, figure.script),
                          folder);
  if (ran.status != 0 || complains(ran.err) || ran.out.empty())
    throw Failed(fmt::format("gnuplot, figure {}: {}", figure.name, why(ran)));
  return ran.out;
}

/// The figure's data in a folder that passes: where gnuplot runs.
class Workshop {
 public:
  explicit Workshop(const Figure& figure) : figure_(figure) {
    for (const DataFile& data : figure.data) folder_.write(data.name, data.bytes);
  }
  std::string svg() const {
    return themed(picture(figure_, "svg dynamic font 'sans-serif,14' background rgb 'white'", folder_.path()),
                  figure_.caption, figure_.finding);
  }
  std::string png() const { return picture(figure_, "pngcairo font 'sans,11' background rgb 'white'", folder_.path()); }

 private:
  const Figure& figure_;
  ScratchFolder folder_;
};

}  // namespace

std::string draw(const Figure& figure, OutputFolder& folder) {
  const Workshop workshop(figure);
  std::string svg = workshop.svg();
  const std::string png = workshop.png();
  for (const DataFile& data : figure.data) folder.add(data.name, data.bytes);
  folder.add(figure.name + ".svg", svg);
  folder.add(figure.name + ".png", png);
  return svg;
}

std::string svg_of(const Figure& figure) { return Workshop(figure).svg(); }

std::string gnuplot_version() {
  const Ran ran = gnuplot("set print '-'\nprint GPVAL_VERSION, ' patchlevel ', GPVAL_PATCHLEVEL\n", ".");
  if (ran.status != 0 || ran.out.empty()) throw Failed("gnuplot: it does not tell its version");
  return ran.out.substr(0, ran.out.find('\n'));
}

}  // namespace ricochet::console
