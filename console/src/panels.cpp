#include <console/number.hpp>
#include <console/panels.hpp>

#include <algorithm>
#include <cmath>

namespace ricochet::console {

namespace {

struct Prefix {
  std::string factor;  ///< from SI to the axis, as gnuplot reads it
  std::string letter;
};

/// The prefix that brings `greatest` between 1 and 1000.
Prefix prefix_for(double greatest) {
  constexpr const char* letters[] = {"f", "p", "n", "µ", "m", "", "k", "M", "G", "T"};
  const int exponent = greatest > 0 ? static_cast<int>(std::floor(std::log10(greatest) / 3)) : 0;
  const int n = std::clamp(exponent, -5, 4);
  return {"1e" + std::to_string(-3 * n), letters[n + 5]};
}

std::string csv_of(const std::vector<Motion>& motions) {
  std::string csv = "curve,t [s],overlap [m],velocity [m/s],force [N]\n";
  for (const Motion& motion : motions) {
    if (&motion != &motions.front()) csv += "\n\n";
    for (const Moment& m : motion.moments)
      csv += '"' + motion.title + "\"," + shortest(m.time) + "," + shortest(m.overlap) + "," + shortest(m.velocity) +
             "," + shortest(m.force) + "\n";
  }
  return csv;
}

std::string style_of(std::size_t i) {
  return "with lines lt " + std::to_string(i % 7 + 1) + " lw 2.2 dt " + std::to_string(i < 7 ? 1 : 2);
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
  struct Panel {
    int column;
    std::string factor, label;
  };
  const Panel panels[] = {{3, overlap.factor, "overlap [" + overlap.letter + "m]"},
                          {4, "1", "velocity [m/s]"},
                          {5, force.factor, "force [" + force.letter + "N]"}};
  const std::string file = name + ".csv";
  std::string script =
      "set multiplot layout 2,2 margins 0.09,0.97,0.10,0.97 spacing 0.11,0.13\nunset key\nset offsets graph "
      "0,0.02,0.03,0\n"
      "set xlabel 'time since the first touch [" +
      time.letter + "s]' offset 0,0.3\nset xzeroaxis lt 1 lc rgb 'black' lw 0.7\n";
  for (const Panel& panel : panels) {
    script += "set ylabel '" + panel.label + "' offset 1,0\nplot ";
    for (std::size_t i = 0; i < motions.size(); ++i)
      script += (i ? ", \\\n  '" : "'") + file + "' " + (i ? "" : "skip 1 ") + "index " + std::to_string(i) +
                " using ($2*" + time.factor + "):($" + std::to_string(panel.column) + "*" + panel.factor + ") " +
                style_of(i) + " notitle";
    script += "\n";
  }
  script +=
      "unset border\nunset tics\nunset grid\nunset xlabel\nunset ylabel\nunset xzeroaxis\nset key at graph 0.06,0.94 "
      "left top font ',15' spacing 1.5 samplen 3\n"
      "set xrange [0:1]\nset yrange [0:1]\nplot ";
  for (std::size_t i = 0; i < motions.size(); ++i)
    script += (i ? ", \\\n  NaN " : "NaN ") + style_of(i) + " title '" + motions[i].title + "'";
  script += "\nunset multiplot\n";
  return {.name = name,
          .caption = caption,
          .script = script,
          .data = {{file, csv_of(motions)}},
          .width = 960,
          .height = 680};
}

}  // namespace ricochet::console
