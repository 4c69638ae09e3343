#include "drawings.hpp"

#include <console/gnuplot.hpp>
#include <console/number.hpp>
#include <ricochet/contact/friction.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ricochet::verify::figures {

namespace {

constexpr int summed_every = 10;

/// λ = 10^(−2 + i/40), i = 0..160.
double ratio(int i) { return std::pow(10.0, -2 + i / 40.0); }

/// F and 𝒯 from what they stand for: on a disc of radius 1 that slides with λ and turns with 1 the friction of each
/// part is against its own velocity. A sum over parts of equal area, at their middles.
DiscFriction summed(double lambda) {
  constexpr int rings = 400, sectors = 400;
  DiscFriction sum{0, 0};
  for (int i = 0; i < rings; ++i)
    for (int j = 0; j < sectors; ++j) {
      const double r = std::sqrt((i + 0.5) / rings), angle = 2 * std::numbers::pi * (j + 0.5) / sectors;
      const double x = r * std::cos(angle), y = r * std::sin(angle);
      const double along = lambda - y, across = x, speed = std::hypot(along, across);
      sum.force += along / speed;
      sum.torque += (x * across - y * along) / speed;
    }
  return {sum.force / (rings * sectors), sum.torque / (rings * sectors)};
}

struct Point {
  double lambda = 0;
  DiscFriction closed;
  bool has_sum = false;
  DiscFriction sum;
};

std::vector<Point> points() {
  std::vector<Point> all;
  for (int i = 0; i <= 160; ++i) {
    const double lambda = ratio(i);
    const bool has_sum = i % summed_every == 0;
    all.push_back({lambda, disc_friction(lambda), has_sum, has_sum ? summed(lambda) : DiscFriction{}});
  }
  return all;
}

}  // namespace

double disc_distance() {
  double worst = 0;
  for (const Point& p : points()) {
    if (!p.has_sum) continue;
    const double off = std::max(std::fabs(p.sum.force - p.closed.force), std::fabs(p.sum.torque - p.closed.torque));
    if (!(off <= worst)) worst = off;
  }
  return worst;
}

console::Figure disc_figure() {
  const std::string file = "disc.csv";
  std::string csv = "lambda,F,T,F summed,T summed\n";
  for (const Point& p : points()) {
    csv += fmt::format("{},{},{},", console::shortest(p.lambda), console::shortest(p.closed.force),
                       console::shortest(p.closed.torque));
    csv += p.has_sum ? fmt::format("{},{}\n", console::shortest(p.sum.force), console::shortest(p.sum.torque))
                     : std::string(",\n");
  }
  const console::Panel panel{
      .x = {.label = "λ = |u_t| / ((w/2) |Ω|)", .log = true, .range = std::pair(0.01, 100.0)},
      .y = {.label = "share of the sliding limit", .range = std::pair(0.0, 1.05)},
      .curves =
          {{.file = file, .what = "1:2", .style = "lines lt 1 lw 2.5", .title = "F: force over µR"},
           {.file = file, .what = "1:3", .style = "lines lt 2 lw 2.5", .title = "T: torque over µR w/2"},
           {.file = file, .what = "1:4", .style = "points pt 6 ps 0.9 lc rgb 'black'", .title = "summed over the disc"},
           {.file = file, .what = "1:5", .style = "points pt 6 ps 0.9 lc rgb 'black'"}},
      .key = "left center"};
  const DiscFriction equal = disc_friction(1);
  return {.name = "disc",
          .caption =
              "Friction of a contact that slides and spins at once, F of (36) and T of (44), over how much it "
              "slides for its spin.",
          .plot = {.panels = {panel}},
          .data = {{file, csv}},
          .finding = fmt::format("Spin takes from the force and sliding from the torque: at λ = 1 F is {:.2f}, of 1 "
                                 "without spin, and T is {:.2f}, of {:.2f} without sliding.",
                                 equal.force, equal.torque, disc_friction(0).torque)};
}

}  // namespace ricochet::verify::figures
