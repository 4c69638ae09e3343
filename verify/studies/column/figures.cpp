#include "figures.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

namespace ricochet::verify::column {

namespace {

std::string csv(const std::string& abscissa, const std::vector<double>& x, const std::vector<ShareCurve>& curves) {
  std::string text = abscissa;
  for (const ShareCurve& curve : curves) text += "," + curve.id;
  text += "\n";
  for (std::size_t i = 0; i < x.size(); ++i) {
    text += console::shortest(x[i]);
    for (const ShareCurve& curve : curves)
      text += fmt::format(",{}", curve.share[i] ? console::shortest(*curve.share[i]) : "");
    text += "\n";
  }
  return text;
}

/// Colours that are told apart in print and by colour-blind readers (Okabe and Ito); shapes say the same again.
std::string styled(const std::string& id) {
  struct Style {
    const char *id, *colour;
    int point;
  };
  constexpr Style styles[] = {{"event-driven", "#000000", 0},
                              {"linear1", "#56B4E9", 4},
                              {"linear2", "#0072B2", 1},
                              {"kuwabara-kono", "#009E73", 8},
                              {"tsuji", "#E69F00", 10},
                              {"hysteretic", "#CC79A7", 12},
                              {"fractional", "#D55E00", 7},
                              {"fractional alpha=0.0258", "#D55E00", 6},
                              {"fractional alpha(nc)", "#D55E00", 5}};
  for (const Style& s : styles)
    if (id == s.id) {
      if (s.point == 0) return fmt::format("with lines lw 2.5 lc rgb '{}'", s.colour);
      const bool fitted = id == "fractional alpha(nc)";
      return fmt::format("{} lc rgb '{}' pt {} ps {}", fitted ? "with points" : "with linespoints lw 1.4", s.colour,
                         s.point, fitted ? "1.0" : "0.8");
    }
  return "with linespoints";
}

std::string title(const std::string& id) {
  if (id == "kuwabara-kono") return "nonlinear (Kuwabara-Kono)";
  if (id == "fractional") return "fractional, constant α";
  if (id == "fractional alpha=0.0258") return "fractional, α = 0.0258";
  if (id == "fractional alpha(nc)") return "fractional, α(n_c)";
  return id;
}

std::string plot(const std::string& file, const std::vector<ShareCurve>& curves) {
  std::string script = "plot ";
  for (std::size_t i = 0; i < curves.size(); ++i)
    script += fmt::format("{}'{}' skip 1 using 1:{} {} title \"{}\"", i ? ", \\\n  " : "", file, i + 2,
                          styled(curves[i].id), title(curves[i].id));
  return script + "\n";
}

constexpr const char* common = "set ylabel 'dissipated share of the kinetic energy'\nset yrange [0:1]\n";

}  // namespace

console::Figure share_figure(const std::vector<std::size_t>& beads, const std::vector<ShareCurve>& curves) {
  const std::vector<double> x(beads.begin(), beads.end());
  const bool wide = beads.back() > 100;
  std::string script = common;
  script += "set xlabel 'number of beads n_c'\n";
  script += wide ? fmt::format("set logscale x\nset xrange [1:{}]\n", beads.back())
                 : fmt::format("set xrange [0:{}]\n", beads.back() + 1);
  // Left the whole range, right the laws that detach, drawn larger.
  const std::string drawn = plot("column-share.csv", curves);
  script += fmt::format(
      "set multiplot\nunset key\nset size 0.40, 1\nset origin 0, 0\nset title 'all'\n{}"
      "set size 0.60, 1\nset origin 0.40, 0\nset title 'the same, enlarged'\nunset ylabel\nset yrange [0:0.25]\n"
      "set key outside right center reverse Left spacing 1.3\n{}unset multiplot\n",
      drawn, drawn);
  return {.name = "column-share",
          .caption =
              "Dissipated share (62) of a column of beads that falls on a plate, against the number of beads; "
              "right the laws with constant parameters, enlarged.",
          .script = script,
          .data = {{"column-share.csv", csv("nc", x, curves)}},
          .width = 1150,
          .height = 460};
}

console::Figure gap_figure(std::size_t beads, const std::vector<double>& gaps, const std::vector<ShareCurve>& curves) {
  std::string script = common;
  script +=
      "set xlabel 'gap between the beads [m]'\nset logscale x\nset xrange [1e-8:1e-2]\nset format x '10^{%L}'\n"
      "set key outside right center reverse Left spacing 1.3\n";
  return {.name = "column-gap",
          .caption = fmt::format("Dissipated share (62) of {} beads against the gap between them: from detachment to "
                                 "single collisions.",
                                 beads),
          .script = script + plot("column-gap.csv", curves),
          .data = {{"column-gap.csv", csv("gap [m]", gaps, curves)}},
          .width = 900,
          .height = 480};
}

}  // namespace ricochet::verify::column
