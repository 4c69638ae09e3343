#include <console/gnuplot.hpp>
#include <console/law_colour.hpp>
#include <console/number.hpp>
#include <console/panels.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::console {

namespace {

struct Prefix {
  std::string factor;  ///< from SI to the axis, as gnuplot reads it
  std::string letter;
  double scale;  ///< the factor
};

/// The prefix that brings `greatest` between 1 and 1000.
Prefix prefix_for(double greatest) {
  constexpr const char* letters[] = {"f", "p", "n", "µ", "m", "", "k", "M", "G", "T"};
  const int exponent = greatest > 0 ? static_cast<int>(std::floor(std::log10(greatest) / 3)) : 0;
  const int n = std::clamp(exponent, -5, 4);
  return {fmt::format("1e{}", -3 * n), letters[n + 5], std::pow(10.0, -3 * n)};
}

SeriesFile file_of(const std::string& name, const std::vector<Motion>& motions) {
  SeriesFile file(name, "curve,t [s],overlap [m],velocity [m/s],force [N]");
  for (const Motion& motion : motions) {
    file.begin();
    for (const Moment& m : motion.moments)
      file.add(fmt::format("\"{}\",{},{},{},{}", motion.title, shortest(m.time), shortest(m.overlap),
                           shortest(m.velocity), shortest(m.force)));
  }
  return file;
}

/// One quantity over time under every law.
Panel panel_of(const std::vector<Motion>& motions, const SeriesFile& file, const Prefix& time, const std::string& label,
               int column, const std::string& factor, double until) {
  Panel panel{.x = {.label = fmt::format("time since the first touch [{}s]", time.letter),
                    .range = std::pair(0.0, 1.03 * until * time.scale),
                    .label_offset = "0,0.3"},
              .y = {.label = label, .label_offset = "1,0"},
              .room = "graph 0,0.02,0.03,0",
              .zero_line = true};
  std::vector<std::string> titles;
  titles.reserve(motions.size());
  for (const Motion& motion : motions) titles.push_back(motion.title);
  panel.curves.reserve(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i)
    panel.curves.push_back({.file = file.name(),
                            .rows = file.rows(i),
                            .what = fmt::format("($2*{}):(${}*{})", time.factor, column, factor),
                            .style = fmt::format("lines {} lw 2.2", law_line(titles, i)),
                            .title = motions[i].title});
  return panel;
}

}  // namespace

Figure collision_panels(const std::string& name, const std::string& caption, const std::vector<Motion>& motions) {
  Moment greatest{};
  for (const Motion& motion : motions)
    for (const Moment& m : motion.moments) {
      greatest.time = std::max(greatest.time, m.time);
      greatest.overlap = std::max(greatest.overlap, m.overlap);
      greatest.force = std::max(greatest.force, m.force);
    }
  const Prefix time = prefix_for(greatest.time), overlap = prefix_for(greatest.overlap),
               force = prefix_for(greatest.force);
  const SeriesFile file = file_of(name + ".csv", motions);
  const Plot plot{.panels = {panel_of(motions, file, time, fmt::format("overlap [{}m]", overlap.letter), 3,
                                      overlap.factor, greatest.time),
                             panel_of(motions, file, time, "velocity [m/s]", 4, "1", greatest.time),
                             panel_of(motions, file, time, fmt::format("force [{}N]", force.letter), 5, force.factor,
                                      greatest.time)},
                  .layout = Layout{.rows = 2,
                                   .columns = 2,
                                   .left = 0.09,
                                   .right = 0.97,
                                   .bottom = 0.10,
                                   .top = 0.97,
                                   .between_columns = 0.11,
                                   .between_rows = 0.13},
                  .key_panel = "at graph 0.06,0.98 left top font ',13' spacing 1.1 samplen 3 maxcols 1"};
  return {.name = name, .caption = caption, .plot = plot, .data = {file.data()}, .width = 960, .height = 680};
}

}  // namespace ricochet::console
