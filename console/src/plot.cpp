#include "stacked.hpp"
#include "svg_corners.hpp"
#include "svg_theme.hpp"

#include <console/child.hpp>
#include <console/exit.hpp>
#include <console/output.hpp>
#include <console/plot.hpp>
#include <console/scratch.hpp>

#include <boost/crc.hpp>
#include <fmt/format.h>

#include <sys/wait.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

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

std::string picture(const Figure& figure, const std::string& terminal, const std::string& folder) {
  const Plot plot = with_keys_within(figure.plot, figure.width, letters * figure.text);
  const Ran ran = gnuplot(fmt::format("set terminal {}\n{}{}\n", terminal, house_style, script_of(plot)), folder);
  if (ran.status != 0 || complains(ran.err) || ran.out.empty())
    throw Failed(fmt::format("gnuplot, figure {}: {}", figure.name, why(ran)));
  return ran.out;
}

// A figure's pixels are those of a screen; on paper they are as large.
constexpr double screen_dpi = 96, print_dpi = 300;

std::string svg_terminal(const Figure& figure) {
  return fmt::format("svg dynamic font 'sans-serif,{}' background rgb 'white' size {},{}", letters * figure.text,
                     figure.width, figure.height);
}

std::string png_terminal(const Figure& figure) {
  constexpr double finer = print_dpi / screen_dpi;
  return fmt::format(
      "pngcairo font 'sans,{0}' fontscale {1} linewidth {1} pointscale {1} background rgb 'white' size {2:.0f},{3:.0f}",
      11 * figure.text, finer, finer * figure.width, finer * figure.height);
}

/// Cairo's scales of a PDF are others: these look like the PNG.
std::string pdf_terminal(const Figure& figure) {
  return fmt::format(
      "pdfcairo font 'sans,{}' fontscale 0.75 linewidth 1.5 dashlength 1.2 pointscale 0.8 background rgb 'white' "
      "size {}in,{}in",
      11 * figure.text, figure.width / screen_dpi, figure.height / screen_dpi);
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

/// The picture with its resolution said, which gnuplot leaves out: a chunk pHYs behind the header (PNG, 11.3.5.3).
std::string with_resolution(std::string png) {
  constexpr std::size_t header_end = 8 + 25;  // the signature and IHDR
  const auto per_metre = static_cast<std::uint32_t>(std::lround(print_dpi / 0.0254));
  const std::string chunk = "pHYs" + big_endian(per_metre) + big_endian(per_metre) + '\1';
  boost::crc_32_type sum;
  sum.process_bytes(chunk.data(), chunk.size());
  constexpr std::uint32_t data_length = 9;
  return png.insert(header_end, big_endian(data_length) + chunk + big_endian(sum.checksum()));
}

/// The picture without the time at which it was drawn, which Cairo notes in it: the same figure is the same bytes.
/// Other digits in their place, as the file counts its bytes. Cairo from 1.18 on packs the time into a compressed
/// object, where it stays.
std::string without_time(std::string pdf) {
  constexpr std::string_view before = "/CreationDate (D:", some_day = "20000101000000";
  if (const auto at = pdf.find(before); at != std::string::npos)
    pdf.replace(at + before.size(), some_day.size(), some_day);
  return pdf;
}

std::string svg(const Figure& figure, const std::string& folder) {
  return themed(with_fewer_corners(picture(figure, svg_terminal(figure), folder)), figure.caption, figure.finding);
}

/// The figure's data in a folder that passes: where gnuplot runs.
class Workshop {
 public:
  explicit Workshop(const Figure& figure) : figure_(figure) {
    for (const DataFile& data : figure.data) folder_.write(data.name, data.bytes);
  }
  Pictures pictures() const { return {svg(figure_, folder_.path()), svg(stacked(figure_), folder_.path())}; }
  std::string png() const { return with_resolution(picture(figure_, png_terminal(figure_), folder_.path())); }
  std::string pdf() const { return without_time(picture(figure_, pdf_terminal(figure_), folder_.path())); }

 private:
  const Figure& figure_;
  ScratchFolder folder_;
};

}  // namespace

Pictures draw(const Figure& figure, OutputFolder& folder) {
  const Workshop workshop(figure);
  Pictures pictures = workshop.pictures();
  const std::string png = workshop.png(), pdf = workshop.pdf();
  for (const DataFile& data : figure.data) folder.add(data.name, data.bytes);
  folder.add(figure.name + ".svg", pictures.wide);
  folder.add(figure.name + ".png", png);
  folder.add(figure.name + ".pdf", pdf);
  return pictures;
}

Pictures pictures_of(const Figure& figure) { return Workshop(figure).pictures(); }

std::string gnuplot_version() {
  const Ran ran = gnuplot("set print '-'\nprint GPVAL_VERSION, ' patchlevel ', GPVAL_PATCHLEVEL\n", ".");
  if (ran.status != 0 || ran.out.empty()) throw Failed("gnuplot: it does not tell its version");
  return ran.out.substr(0, ran.out.find('\n'));
}

}  // namespace ricochet::console
