#include "drawings.hpp"

#include <console/gnuplot.hpp>
#include <console/law_colour.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

namespace ricochet::verify::figures {

DegreeSweep sweep_degrees() {
  DegreeSweep sweep;
  for (int percent = -50; percent <= 97; ++percent) {
    const Collision out = alpha_collision(percent / 100.0);
    sweep.alpha.push_back(percent / 100.0);
    sweep.tcol.push_back(out.tcol);
    sweep.en.push_back(out.en);
  }
  return sweep;
}

namespace {

const std::string file = "alpha.csv";

std::string csv_of(const DegreeSweep& sweep) {
  std::string csv = "alpha,t_col [1e-6 s],e_n\n";
  for (std::size_t i = 0; i < sweep.alpha.size(); ++i)
    csv += fmt::format("{},{},{}\n", console::shortest(sweep.alpha[i]), console::shortest(1e6 * sweep.tcol[i]),
                       console::shortest(sweep.en[i]));
  return csv;
}

console::Panel panel_of(const std::string& label, double most, const std::string& columns) {
  return {.x = {.label = "conversion degree α", .range = std::pair(-0.5, 1.0), .label_offset = "0,0.3"},
          .y = {.label = label, .range = std::pair(0.0, most), .label_offset = "1,0"},
          .curves = {{.file = file,
                      .what = columns,
                      .style = fmt::format("lines lc rgb '{}' lw 2.5", console::law_colour(Fractional::name))}}};
}

}  // namespace

console::Figure degree_figure(const DegreeSweep& sweep) {
  const console::Panel time = panel_of("collision time [µs]", 500, "1:2");
  console::Panel restitution = panel_of("e_n", 2, "1:3");
  restitution.curves.push_back(
      {.what = "1", .style = fmt::format("lines lw 1.5 dt 2 lc rgb '{}'", console::palette::gray)});
  const console::Plot plot{
      .panels = {time, restitution},
      .layout = console::Layout{
          .rows = 1, .columns = 2, .left = 0.09, .right = 0.98, .bottom = 0.2, .top = 0.96, .between_columns = 0.1}};
  const std::size_t last = sweep.alpha.size() - 1;
  return {.name = "alpha",
          .caption = "Collision time and restitution of the pair of Figs. 3 and 4 over the conversion degree.",
          .plot = plot,
          .data = {{file, csv_of(sweep)}},
          .width = 900,
          .height = 380,
          .finding = fmt::format("The collision time rises all the way, from {:.1f} µs at α = {} to {:.1f} µs at {}, "
                                 "and the restitution falls from {:.3f} to {:.4f}.",
                                 1e6 * sweep.tcol.front(), sweep.alpha.front(), 1e6 * sweep.tcol[last],
                                 sweep.alpha[last], sweep.en.front(), sweep.en[last])};
}

}  // namespace ricochet::verify::figures
