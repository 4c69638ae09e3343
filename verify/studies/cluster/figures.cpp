#include "figures.hpp"

#include <console/number.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace ricochet::verify::cluster {
namespace {

using console::DataFile;
using console::Figure;
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

/// One quantity of sphere 1, less `from`, for both runs.
struct Panel {
  const char* label = "";
  std::array<const char*, 3> names{};
  Vec3 from{};
  int first = 0;
};

std::string plot(const Panel& panel) {
  const std::array from{panel.from.x, panel.from.y, panel.from.z};
  std::string script = fmt::format("set ylabel '{}'\n", panel.label);
  std::string separator = "plot ";
  for (int c = 0; c < 3; ++c)
    for (const auto& [file, dash, word] :
         {std::tuple("cluster-strong.csv", "dt (6,4)", "strong"), std::tuple("cluster-weak.csv", "dt 1", "weak")}) {
      script += fmt::format("{}'{}' skip 1 using (1000*$1):(${}-({})) with lines lw 2 {} lc rgb '{}' title '{}, {}'",
                            separator, file, column(1, panel.first + c), shortest(from[c]), dash, colours[c],
                            panel.names[c], word);
      separator = ", \\\n  ";
    }
  return script + "\n";
}

}  // namespace

Figure trajectories(const Run& strong, const Run& weak) {
  std::string script =
      "set multiplot layout 1,2 margins 0.10,0.98,0.11,0.94 spacing 0.08,0.1\nset size ratio -1\n"
      "set xrange [-0.01:0.2]\nset yrange [0:0.26]\nset xtics 0.04\nset ytics 0.04\n"
      "set xlabel 'y [m]'\nset key bottom right samplen 1.5\n";
  for (const auto& [title, file, z] :
       {std::tuple("strong repulsion, α = 0.01", "cluster-strong.csv", "set ylabel 'z [m]'\n"),
        std::tuple("weak repulsion, α = 0.97", "cluster-weak.csv", "unset ylabel\n")}) {
    script += fmt::format(
        "{}set title '{}'\nplot 'cluster-start.csv' skip 1 using 1:2:3 with circles lc rgb '#767676' fs empty notitle"
        ", \\\n  '' skip 1 using ($1+($4==3||$4==5?-1:1)*($3+0.006)):2:4 with labels font ',12' tc rgb '#767676' "
        "notitle",
        z, title);
    for (int i = 1; i <= 5; ++i)
      script += fmt::format(", \\\n  '{}' skip 1 using {}:{} with lines lw 2.2 lc rgb '{}' title 'sphere {}'", file,
                            column(i, 1), column(i, 2), colours[i - 1], i);
    script += "\n";
  }
  return {
      .name = "cluster-trajectories",
      .caption = "Fig. 7: trajectories of the five spheres, seen along x; circles: where they start.",
      .script = script + "unset multiplot\n",
      .data = {samples(strong, "cluster-strong.csv"), samples(weak, "cluster-weak.csv"), circles(strong)},
      .width = 900,
      .height = 560,
      .finding = fmt::format("Sphere 1 comes from above and drives the others apart: {} under strong, {} under weak "
                             "repulsion.",
                             farthest(strong), farthest(weak))};
}

Figure velocities(const Run& strong, const Run& weak) {
  std::string script =
      "set multiplot layout 2,1 margins 0.09,0.78,0.10,0.97 spacing 0.1,0.04\n"
      "set key outside right center samplen 2\n";
  // Next to its first velocity, along z, what the collisions change would be lines on top of each other.
  script += "set format x ''\n";
  script += plot(
      {"velocity of sphere 1, less its first [m/s]", {"Δv_x", "Δv_y", "Δv_z"}, strong.samples.front().velocity[0], 3});
  script += "set format x '%g'\nset xlabel 't [ms]'\n";
  script += plot({"spin of sphere 1 [1/s]", {"ω_x", "ω_y", "ω_z"}, {}, 6});
  return {.name = "cluster-velocities",
          .caption =
              "Fig. 8: velocity of sphere 1, less its first, and spin; dashed: strong repulsion (α = 0.01), solid: "
              "weak (α = 0.97).",
          .script = script + "unset multiplot\n",
          .data = {samples(strong, "cluster-strong.csv"), samples(weak, "cluster-weak.csv")},
          .width = 900,
          .height = 680,
          .finding = fmt::format("Sphere 1 leaves at {} after strong and at {} after weak collisions.",
                                 last_speed(strong), last_speed(weak))};
}

Figure sequence(const Run& strong, const Run& weak, double until) {
  // One line a pair, in the order of the first touch; strong above weak.
  std::map<std::string, int> rows;
  std::string tics;
  for (const Run* run : {&strong, &weak})
    for (const Encounter& e : run->collisions)
      if (rows.emplace(pair_name(e), static_cast<int>(rows.size())).second)
        tics += fmt::format("{}'{}' {}", tics.empty() ? "" : ", ", pair_name(e), rows.size() - 1);
  std::string csv = "pair,row,t_begin [s],t_end [s],weak\n";
  for (const Run* run : {&strong, &weak})
    for (const Encounter& e : run->collisions)
      csv +=
          fmt::format("{},{},{},{},{}\n", pair_name(e), shortest(rows[pair_name(e)] + (run == &strong ? -0.13 : 0.13)),
                      shortest(e.begin), shortest(std::min(e.end, until)), run == &strong ? 0 : 1);
  const auto line = [](int which, const char* colour, const char* title) {
    return fmt::format(
        "'cluster-sequence.csv' skip 1 using ($5=={}?1000*$3:NaN):2:(1000*($4-$3)):(0) with vectors nohead lw 7 lc rgb "
        "'{}' title '{}'",
        which, colour, title);
  };
  const auto shared = [until](const Run& run) { return 100 * overlap(run.collisions, until).shared; };
  return {.name = "cluster-sequence",
          .caption = "Fig. 9: when each pair collides, from the first touch to the first zero of the force.",
          .script = fmt::format("set xlabel 't [ms]'\nset ylabel 'pair'\nset yrange [{}-0.4:-0.6]\nset ytics ({})\n"
                                "set grid x\nset xrange [0:*]\nset key top right samplen 2\nplot {}, \\\n  {}\n",
                                rows.size(), tics, line(0, colours[0], "strong, α = 0.01"),
                                line(1, colours[1], "weak, α = 0.97")),
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
  return {
      .name = "cluster-binary",
      .caption = "Share of the collision time during which more than one pair collides, against the stiffness k.",
      .script = fmt::format(
          "set logscale x\nset xrange [500:2e7]\nset xlabel 'k [kg/s²]'\nset format x '10^{{%T}}'\n"
          "set ylabel 'collision time shared by several pairs [%]'\nset yrange [-3:100]\n"
          "set key top right\nplot 'cluster-binary.csv' skip 1 using 1:(100*$2) with linespoints lw 2 pt 7 lc rgb "
          "'{}' title 'strong, α = 0.01', '' skip 1 using 1:(100*$4) with linespoints lw 2 pt 5 lc rgb '{}' title "
          "'weak, α = 0.97'\n",
          colours[0], colours[1]),
      .data = {{"cluster-binary.csv", csv}},
      .width = 700,
      .height = 430,
      .finding = fmt::format("From the softest to the stiffest k the share falls from {:.0f} to {:.0f} % under "
                             "strong and goes from {:.0f} to {:.0f} % under weak repulsion.",
                             shared(strong.front()), shared(strong.back()), shared(weak.front()), shared(weak.back()))};
}

}  // namespace ricochet::verify::cluster
