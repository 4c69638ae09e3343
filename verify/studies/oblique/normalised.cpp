#include "measured.hpp"

#include <ricochet/collision/damping_ratio.hpp>

#include <console/csv.hpp>
#include <console/gnuplot.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ricochet::verify::oblique {

namespace {

using console::Curve;
using console::Panel;
using console::SeriesFile;
using console::shortest;
namespace palette = console::palette;

struct NormalisedPoint {
  std::string law;
  double before = 0, after = 0;
};

std::vector<NormalisedPoint> thornton() {
  constexpr std::array columns{console::CsvColumn{"law", "", true}, console::CsvColumn{"before", "", true},
                               console::CsvColumn{"after", "", true}};
  console::CsvReader source(data_folder() + "/oblique_thornton_e050.csv", columns);
  std::vector<NormalisedPoint> points;
  while (source.next()) points.push_back({std::string(source.text(0)), source.number(1), source.number(2)});
  return points;
}

/// Slip after, both slips in units of μ(1+e_n)v_n/2, where e_n does not depend on the speed.
double normalised_after(const Contact& contact, double before) {
  ObliqueImpact impact = at_angle(0);
  const double v = impact.i.velocity.z, en = collide(contact.normal, Impact{v, impact.i.mass}).en;
  impact.i.velocity.x = 0.5 * before * mu * (1 + en) * v;
  const ObliqueCollision out = collide(contact.normal, contact.tangential, impact);
  return -before * out.beta.value_or(0);
}

/// e_n = 0.5 by force, as the curves have it.
Contact damped_linear() {
  Contact contact = contacts()[1];
  const double k = 1.72e7;
  const double c = 2 * damping_of_restitution(0.5, ContactEnd::force) * std::sqrt(at_angle(0).i.mass * k);
  contact.normal = Linear(k, c);
  return contact;
}

constexpr const char* colours[] = {palette::blue, palette::vermilion, palette::green};

Curve points(const SeriesFile& file, std::size_t series, const char* style, const char* title) {
  return {.file = file.name(), .rows = file.rows(series), .what = "2:3", .style = style, .title = title};
}

/// Series of (name, angle, value).
void add(SeriesFile& file, const std::string& name, double x, double y) {
  file.add(fmt::format("{},{},{}", name, shortest(x), shortest(y)));
}

void add_points(SeriesFile& file, const char* source, const std::string& quantity) {
  file.begin();
  for (const Point& p : read_points(source))
    if (p.quantity == quantity) add(file, "read off", p.degrees, p.value);
}

/// One quantity over the angle of impact; its series go to a file of its own.
Panel rebound_panel(SeriesFile& file, const std::string& quantity, const std::string& label) {
  Panel panel{.x = {.label = "angle of impact [deg]", .range = std::pair(0.0, 90.0), .tics = 15},
              .y = {.label = label},
              .room = "0,0,graph 0.05,graph 0.05"};
  const auto all = contacts();
  for (const auto& one : all) {
    file.begin();
    for (int n = 1; n <= 178; ++n) add(file, one.name, 0.5 * n, value_of(rebound(one, 0.5 * n), quantity));
  }
  add_points(file, "oblique_kharaz2001.csv", quantity);
  add_points(file, "oblique_kharaz2001_second_reading.csv", quantity);
  for (std::size_t k = 0; k < all.size(); ++k)
    panel.curves.push_back({.file = file.name(),
                            .rows = file.rows(k),
                            .what = "2:3",
                            .style = fmt::format("lines lw 2 lc rgb '{}'", colours[k]),
                            .title = all[k].name});
  panel.curves.push_back(points(file, 3, "points pt 6 ps 1.2 lc rgb 'black'", "measured"));
  panel.curves.push_back(points(file, 4, "points pt 2 ps 0.8 lc rgb 'black'", "measured, second reading"));
  return panel;
}

}  // namespace

void compare_with_thornton(StudyResult& result) {
  const Contact linear = damped_linear();
  double worst = 0;
  for (const NormalisedPoint& p : thornton())
    if (p.before > 7) worst = std::max(worst, std::abs(normalised_after(linear, p.before) - p.after));
  // Read off an axis of some ten units.
  result.gates.push_back(at_most("Thornton's normalised curve, gross sliding: slip after, off by", worst, 0.2));
}

console::Figure rebound_figure() {
  SeriesFile et("oblique-et.csv", "series,angle [deg],et"), spin("oblique-spin.csv", "series,angle [deg],spin [1/s]"),
      angle("oblique-angle.csv", "series,angle [deg],angle after [deg]");
  console::Plot plot;
  plot.panels = {rebound_panel(et, "et", "e_t of the centre"), rebound_panel(spin, "spin", "spin after [1/s]"),
                 rebound_panel(angle, "angle", "angle of rebound [deg]")};
  plot.layout = console::Layout{.rows = 2,
                                .columns = 2,
                                .left = 0.09,
                                .right = 0.97,
                                .bottom = 0.09,
                                .top = 0.97,
                                .between_columns = 0.11,
                                .between_rows = 0.12};
  plot.key_panel = "center";
  return {.name = "oblique",
          .caption =
              "Oblique impact of a 5 mm grain at 3.9 m/s with rigid friction and with springs in the tangent "
              "plane, and what Kharaz, Gorham and Salman (2001) measured.",
          .plot = plot,
          .data = {et.data(), spin.data(), angle.data()},
          .width = 1000,
          .height = 760};
}

console::Figure normalised_figure() {
  SeriesFile file("oblique-normalised.csv", "series,slip before,slip after");
  const Contact linear = damped_linear();
  Contact rigid = linear;
  rigid.tangential.law = RigidTangential{};
  for (const auto& [contact, name] : {std::pair<const Contact*, const char*>{&rigid, "rigid"}, {&linear, "linear"}}) {
    file.begin();
    for (int n = 1; n <= 100; ++n) add(file, name, 0.1 * n, normalised_after(*contact, 0.1 * n));
  }
  for (const char* law : {"linear", "hertz"}) {
    file.begin();
    for (const NormalisedPoint& p : thornton())
      if (p.law == law) add(file, p.law, p.before, p.after);
  }
  Panel panel{.x = {.label = "slip before, 2u/({/Symbol m}(1+e_n)v_n)", .range = std::pair(0.0, 10.0)},
              .y = {.label = "slip after"},
              .key = "top left",
              .room = "0,0,graph 0.05,graph 0.05",
              .zero_line = true};
  panel.curves = {{.file = file.name(),
                   .rows = file.rows(0),
                   .what = "2:3",
                   .style = fmt::format("lines lw 2 lc rgb '{}'", colours[0]),
                   .title = "rigid"},
                  {.file = file.name(),
                   .rows = file.rows(1),
                   .what = "2:3",
                   .style = fmt::format("lines lw 2 lc rgb '{}'", colours[1]),
                   .title = "linear, no dashpot in the tangent plane"},
                  points(file, 2, "points pt 6 ps 1.2 lc rgb 'black'", "Thornton et al., linear"),
                  points(file, 3, "points pt 2 ps 1 lc rgb 'black'", "Thornton et al., Hertz")};
  return {.name = "oblique-normalised",
          .caption =
              "Slip of the contact point after an impact with e_n = 0.5 over that before; past 7 every contact "
              "slides throughout.",
          .plot = {.panels = {panel}},
          .data = {file.data()},
          .width = 800,
          .height = 560};
}

}  // namespace ricochet::verify::oblique
