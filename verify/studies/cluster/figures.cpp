#include "figures.hpp"

#include <console/gnuplot.hpp>
#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <map>
#include <utility>

namespace ricochet::verify::cluster {
namespace {

using console::Curve;
using console::DataFile;
using console::Figure;
using console::Panel;
using console::shortest;

// One a sphere, and in the other figures strong and weak repulsion.
namespace palette = console::palette;
constexpr const char* colours[] = {palette::blue, palette::vermilion, palette::green, palette::purple, palette::orange};

void add(std::string& row, Vec3 v) {
  for (double c : {v.x, v.y, v.z}) row += fmt::format(",{}", shortest(c));
}

// All samples: time, then position, velocity and spin of spheres 1 to 5.
DataFile samples(const Run& run, const std::string& name) {
  std::string csv = "t [s]";
  for (int i = 1; i <= 5; ++i)
    for (const char* what : {"x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz"}) {
      const char first = what[0];
      csv += fmt::format(",{}{} {}", what, i, what[1] == 0 ? "[m]" : first == 'v' ? "[m/s]" : "[1/s]");
    }
  csv += "\n";
  for (const Sample& s : run.samples) {
    csv += shortest(s.time);
    for (std::size_t i = 0; i < 5; ++i) add(csv, s.position[i]), add(csv, s.velocity[i]), add(csv, s.spin[i]);
    csv += "\n";
  }
  return {name, csv};
}

int column(int sphere, int quantity) { return 2 + 9 * (sphere - 1) + quantity; }

DataFile circles(const Run& run) {
  std::string csv = "y [m],z [m],r [m],sphere\n";
  const ClusterSetup setup = five_spheres(run.law);
  for (std::size_t i = 0; i < 5; ++i)
    csv += fmt::format("{},{},{},{}\n", shortest(setup.spheres[i].position.y), shortest(setup.spheres[i].position.z),
                       shortest(setup.spheres[i].radius), i + 1);
  return {"cluster-start.csv", csv};
}

/// How far the sphere that travels farthest gets, in words.
std::string farthest(const Run& run) {
  double most = 0;
  std::size_t sphere = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec3 way = run.samples.back().position[i] - run.samples.front().position[i];
    const double length = std::hypot(way.x, way.y, way.z);
    if (length > most) most = length, sphere = i + 1;
  }
  return fmt::format("sphere {} goes farthest, {} cm,", sphere, console::significant(100 * most, 3));
}

/// |v| of sphere 1 at the end, in words.
std::string last_speed(const Run& run) {
  const Vec3 v = run.samples.back().velocity[0];
  return fmt::format("{} m/s", console::significant(std::hypot(v.x, v.y, v.z), 3));
}

/// Spin of sphere 1 in the frame of its contact with sphere 5, while the two collide; a series a run.
console::SeriesFile local_spins(const Run& strong, const Run& weak) {
  console::SeriesFile file("cluster-local-spins.csv", "t [s],w_xi [1/s],w_eta [1/s],w_zeta [1/s],repulsion");
  for (const Run* run : {&strong, &weak}) {
    file.begin();
    for (const auto& [time, spin] : spins_against(*run, 0, 4)) {
      std::string row = shortest(time);
      add(row, spin);
      file.add(row + (run == &strong ? ",strong" : ",weak"));
    }
  }
  return file;
}

/// One component: where it is drawn from, its colour and name.
struct Component {
  const char* name = "";
  int column = 0, colour = 0;
};

/// Dashed in the strong state, solid in the weak one; the states are two files, or two series of `file`.
Panel panel(const std::string& label, std::initializer_list<Component> components,
            const console::SeriesFile* file = nullptr) {
  Panel panel{.y = {.label = label, .minor_tics = false},
              .key = "outside right center samplen 2",
              .room = "0,0,graph 0.05,graph 0.05"};
  for (const Component& c : components)
    for (const bool weak : {false, true}) {
      Curve curve{.file = weak ? "cluster-weak.csv" : "cluster-strong.csv",
                  .what = fmt::format("(1000*$1):{}", c.column),
                  .style = fmt::format("lines lw 2 {} lc rgb '{}'", weak ? "dt 1" : "dt (6,4)", colours[c.colour]),
                  .title = fmt::format("{}, {}", c.name, weak ? "weak" : "strong")};
      if (file) curve.file = file->name(), curve.rows = file->rows(weak ? 1 : 0);
      panel.curves.push_back(curve);
    }
  return panel;
}

/// What the picture has to hold of one axis.
using Extent = std::pair<double, double>;

/// Of all that the spheres reach in both runs, whole where they start, and a little more.
Extent extent(const Run& strong, const Run& weak, double Vec3::*axis) {
  constexpr double room = 0.01;  // m
  Extent held{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  const auto hold = [&](double at, double around) {
    held = {std::min(held.first, at - around), std::max(held.second, at + around)};
  };
  for (const Sphere& sphere : five_spheres(strong.law).spheres) hold(sphere.position.*axis, sphere.radius + room);
  for (const Run* run : {&strong, &weak})
    for (const Sample& s : run->samples)
      for (std::size_t i = 0; i < 5; ++i) hold(s.position[i].*axis, room);
  return held;
}

/// The five ways of one run, seen along x, and where they begin.
Panel ways(const char* title, const char* file, Extent y, Extent z) {
  Panel panel{.title = title,
              .x = {.label = "y [m]", .range = y, .tics = 0.04, .minor_tics = false},
              .y = {.label = "z [m]", .range = z, .tics = 0.04, .minor_tics = false},
              .key = "bottom right samplen 1.5",
              .equal_scales = true};
  panel.curves = {{.file = "cluster-start.csv", .what = "1:2:3", .style = "circles lc rgb '#767676' fs empty"},
                  {.file = "cluster-start.csv",
                   // Each beside its circle where no way leads.
                   .what = "($1+($4==3?-1:1)*($3+($4==5?0.004:0.006))):($2-($4==5?0.013:0)):4",
                   .style = "labels font ',12' tc rgb '#767676'"}};
  for (int i = 1; i <= 5; ++i)
    panel.curves.push_back({.file = file,
                            .what = fmt::format("{}:{}", column(i, 1), column(i, 2)),
                            .style = fmt::format("lines lw 2.2 lc rgb '{}'", colours[i - 1]),
                            .title = fmt::format("sphere {}", i)});
  return panel;
}

}  // namespace

Figure trajectories(const Run& strong, const Run& weak) {
  const Extent y = extent(strong, weak, &Vec3::y), z = extent(strong, weak, &Vec3::z);
  console::Plot plot{
      .panels = {ways("strong repulsion, α = 0.01", "cluster-strong.csv", y, z),
                 ways("weak repulsion, α = 0.97", "cluster-weak.csv", y, z)},
      .layout = console::Layout{
          .columns = 2, .left = 0.10, .right = 0.98, .bottom = 0.14, .top = 0.94, .between_columns = 0.08}};
  plot.panels.back().y.label = "";
  return {
      .name = "cluster-trajectories",
      .caption = "Fig. 7: trajectories of the five spheres, seen along x; circles: where they start.",
      .plot = plot,
      .data = {samples(strong, "cluster-strong.csv"), samples(weak, "cluster-weak.csv"), circles(strong)},
      .width = 900,
      .height = 600,
      .finding = fmt::format("Sphere 1 comes from above and drives the others apart: {} under strong, {} under weak "
                             "repulsion.",
                             farthest(strong), farthest(weak))};
}

Figure velocities(const Run& strong, const Run& weak) {
  // Along z sphere 1 is an order of magnitude faster than across: a panel of its own.
  const console::SeriesFile spins = local_spins(strong, weak);
  std::vector<Panel> panels{
      panel("v_x, v_y [m/s]", {{"v_x", column(1, 3), 0}, {"v_y", column(1, 4), 1}}),
      panel("v_z [m/s]", {{"v_z", column(1, 5), 2}}),
      panel("ω_x, ω_y, ω_z [1/s]", {{"ω_x", column(1, 6), 0}, {"ω_y", column(1, 7), 1}, {"ω_z", column(1, 8), 2}}),
      panel("ω_ξ, ω_η against 5 [1/s]", {{"ω_ξ", 2, 3}, {"ω_η", 3, 4}}, &spins)};
  for (Panel& p : panels) p.x = {.range = std::pair(0.0, 1e3 * strong.samples.back().time), .format = ""};
  panels.back().x.format = {};
  panels.back().x.label = "t [ms]";
  return {.name = "cluster-velocities",
          .caption =
              "Fig. 8: velocity and spin of sphere 1, and its spin in the frame of its contact with sphere 5 "
              "while the two collide; dashed: strong repulsion (α = 0.01), solid: weak (α = 0.97).",
          .plot = {.panels = panels,
                   .layout =
                       console::Layout{
                           .rows = 4, .left = 0.12, .right = 0.81, .bottom = 0.07, .top = 0.98, .between_rows = 0.03}},
          .data = {samples(strong, "cluster-strong.csv"), samples(weak, "cluster-weak.csv"), spins.data()},
          .width = 900,
          .height = 980,
          .finding =
              fmt::format("Sphere 1 leaves at {} after strong and at {} after weak collisions. While it touches sphere "
                          "5 it turns at up to {:.1f} 1/s under strong and {:.1f} 1/s under weak repulsion.",
                          last_speed(strong), last_speed(weak), greatest_tangential(strong, 0, 4),
                          greatest_tangential(weak, 0, 4))};
}

Figure sequence(const Run& strong, const Run& weak, double until) {
  // One line a pair, in the order of the first touch; strong above weak.
  std::map<std::string, int> rows;
  std::vector<std::string> pairs;
  for (const Run* run : {&strong, &weak})
    for (const Encounter& e : run->collisions)
      if (rows.emplace(pair_name(e), static_cast<int>(rows.size())).second) pairs.push_back(pair_name(e));
  std::string csv = "pair,row,t_begin [s],t_end [s],weak\n";
  for (const Run* run : {&strong, &weak})
    for (const Encounter& e : run->collisions)
      csv +=
          fmt::format("{},{},{},{},{}\n", pair_name(e), shortest(rows[pair_name(e)] + (run == &strong ? -0.13 : 0.13)),
                      shortest(e.begin), shortest(std::min(e.end, until)), run == &strong ? 0 : 1);
  const auto bars = [](int which, const char* title) {
    return Curve{.file = "cluster-sequence.csv",
                 .what = fmt::format("($5=={}?1000*$3:NaN):2:(1000*($4-$3)):(0)", which),
                 .style = fmt::format("vectors nohead lw 7 lc rgb '{}'", colours[which]),
                 .title = title};
  };
  const Panel panel{
      .x = {.label = "t [ms]", .range = std::pair(0.0, 1e3 * until)},
      .y = {.label = "pair", .range = std::pair(static_cast<double>(rows.size()) - 0.4, -0.6), .names = pairs},
      .curves = {bars(0, "strong, α = 0.01"), bars(1, "weak, α = 0.97")},
      .key = "top right samplen 2"};
  const auto shared = [until](const Run& run) { return 100 * overlap(run.collisions, until).shared; };
  return {.name = "cluster-sequence",
          .caption = "Fig. 9: when each pair collides, from the first touch to the first zero of the force.",
          .plot = {.panels = {panel}},
          .data = {{"cluster-sequence.csv", csv}},
          .width = 800,
          .height = 400,
          .finding = fmt::format("Several pairs collide at once for {:.0f} % of the collision time under strong and "
                                 "{:.0f} % under weak repulsion.",
                                 shared(strong), shared(weak))};
}

Figure binary(const std::vector<Run>& strong, const std::vector<Run>& weak, double until) {
  std::string csv = "k [kg/s^2],shared strong,pairs strong,shared weak,pairs weak\n";
  for (std::size_t n = 0; n < strong.size(); ++n) {
    const Overlap s = overlap(strong[n].collisions, until), w = overlap(weak[n].collisions, until);
    csv += fmt::format("{},{},{},{},{}\n", shortest(strong[n].law.k), shortest(s.shared), shortest(s.mean_pairs),
                       shortest(w.shared), shortest(w.mean_pairs));
  }
  const auto shared = [until](const Run& run) { return 100 * overlap(run.collisions, until).shared; };
  const auto line = [](int which, const char* what, const char* title) {
    return Curve{.file = "cluster-binary.csv",
                 .what = what,
                 .style = fmt::format("linespoints lw 2 pt {} lc rgb '{}'", 7 - 2 * which, colours[which]),
                 .title = title};
  };
  const Panel panel{.x = {.label = "k [kg/s²]", .log = true, .range = std::pair(500.0, 2e7), .format = "10^{%T}"},
                    .y = {.label = "collision time shared by several pairs [%]", .range = std::pair(-3.0, 100.0)},
                    .curves = {line(0, "1:(100*$2)", "strong, α = 0.01"), line(1, "1:(100*$4)", "weak, α = 0.97")},
                    .key = "top right"};
  return {
      .name = "cluster-binary",
      .caption = "Share of the collision time during which more than one pair collides, against the stiffness k.",
      .plot = {.panels = {panel}},
      .data = {{"cluster-binary.csv", csv}},
      .width = 700,
      .height = 430,
      .finding = fmt::format("From the softest to the stiffest k the share falls from {:.0f} to {:.0f} % under "
                             "strong and goes from {:.0f} to {:.0f} % under weak repulsion.",
                             shared(strong.front()), shared(strong.back()), shared(weak.front()), shared(weak.back()))};
}

}  // namespace ricochet::verify::cluster
