#include "figures.hpp"

#include <console/gnuplot.hpp>
#include <console/law_colour.hpp>
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

/// In the law's colour; shapes say the same again.
std::string styled(const std::string& id) {
  struct Style {
    const char* id;
    int point;
  };
  constexpr Style styles[] = {{"event-driven", 0},
                              {"linear1", 4},
                              {"linear2", 1},
                              {"kuwabara-kono", 8},
                              {"tsuji", 10},
                              {"hysteretic", 12},
                              {"fractional", 7},
                              {"fractional alpha=0.0258", 6},
                              {"fractional alpha(nc)", 5}};
  for (const Style& s : styles)
    if (id == s.id) {
      if (s.point == 0) return fmt::format("lines lw 2.5 lc rgb '{}'", console::palette::black);
      const bool fitted = id == "fractional alpha(nc)";
      return fmt::format("{} lc rgb '{}' pt {} ps {}", fitted ? "points" : "linespoints lw 1.4",
                         console::law_colour(id), s.point, fitted ? "1.0" : "0.8");
    }
  return "linespoints";
}

/// By the program's name of the law.
std::string title(const std::string& id) {
  if (id == "linear1") return "linear, ended by overlap";
  if (id == "linear2") return "linear, ended by force";
  if (id == "fractional") return "fractional, constant α";
  if (id == "fractional alpha=0.0258") return "fractional, α = 0.0258";
  if (id == "fractional alpha(nc)") return "fractional, α(n_c)";
  return id;
}

std::vector<console::Curve> drawn(const std::string& file, const std::vector<ShareCurve>& curves) {
  std::vector<console::Curve> all;
  for (std::size_t i = 0; i < curves.size(); ++i)
    all.push_back({.file = file,
                   .what = fmt::format("1:{}", i + 2),
                   .style = styled(curves[i].id),
                   .title = title(curves[i].id)});
  return all;
}

constexpr const char* share_label = "dissipated share of the kinetic energy";
constexpr const char* key = "outside right center reverse Left spacing 1.3";

}  // namespace

console::Figure share_figure(const std::vector<std::size_t>& beads, const std::vector<ShareCurve>& curves) {
  const std::vector<double> x(beads.begin(), beads.end());
  const bool wide = beads.back() > 100;
  const auto most = static_cast<double>(beads.back());
  const console::Axis number{
      .label = "number of beads n_c", .log = wide, .range = wide ? std::pair(1.0, most) : std::pair(0.0, most + 1)};
  // Left the whole range, right the laws that detach, drawn larger.
  const console::Panel all{.title = "all",
                           .x = number,
                           .y = {.label = share_label, .range = std::pair(0.0, 1.0)},
                           .curves = drawn("column-share.csv", curves)};
  const console::Panel enlarged{.title = "the same, enlarged",
                                .x = number,
                                .y = {.range = std::pair(0.0, 0.25)},
                                .curves = all.curves,
                                .key = key};
  return {.name = "column-share",
          .caption =
              "Dissipated share (62) of a column of beads that falls on a plate, against the number of beads; "
              "right the laws with constant parameters, enlarged.",
          .plot = {.panels = {all, enlarged},
                   .layout = console::Layout{.columns = 2,
                                             .left = 0.07,
                                             .right = 0.725,
                                             .bottom = 0.17,
                                             .top = 0.91,
                                             .between_columns = 0.06}},
          .data = {{"column-share.csv", csv("nc", x, curves)}},
          .width = 1150,
          .height = 460};
}

console::Figure gap_figure(std::size_t beads, const std::vector<double>& gaps, const std::vector<ShareCurve>& curves) {
  const console::Panel panel{
      .x = {.label = "gap between the beads [m]", .log = true, .range = std::pair(1e-8, 1e-2), .format = "10^{%L}"},
      .y = {.label = share_label, .range = std::pair(0.0, 1.0)},
      .curves = drawn("column-gap.csv", curves),
      .key = key};
  return {.name = "column-gap",
          .caption = fmt::format("Dissipated share (62) of {} beads against the gap between them: from detachment to "
                                 "single collisions.",
                                 beads),
          .plot = {.panels = {panel}},
          .data = {{"column-gap.csv", csv("gap [m]", gaps, curves)}},
          .width = 900,
          .height = 480};
}

}  // namespace ricochet::verify::column
