#include "figures.hpp"

#include <console/number.hpp>

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
  for (double c : {v.x, v.y, v.z}) row += "," + shortest(c);
}

// All samples: time, then position, velocity and spin of spheres 1 to 5.
DataFile samples(const Run& run, const std::string& name) {
  std::string csv = "t [s]";
  for (int i = 1; i <= 5; ++i)
    for (const char* what : {"x", "y", "z", "vx", "vy", "vz", "wx", "wy", "wz"}) {
      const char first = what[0];
      csv += "," + std::string(what) + std::to_string(i) + (what[1] == 0 ? " [m]" : first == 'v' ? " [m/s]" : " [1/s]");
    }
  csv += "\n";
  for (const Sample& s : run.samples) {
    csv += shortest(s.time);
    for (std::size_t i = 0; i < 5; ++i) add(csv, s.position[i]), add(csv, s.velocity[i]), add(csv, s.spin[i]);
    csv += "\n";
  }
  return {name, csv};
}

std::string column(int sphere, int quantity) { return std::to_string(2 + 9 * (sphere - 1) + quantity); }

DataFile circles(const Run& run) {
  std::string csv = "y [m],z [m],r [m],sphere\n";
  const ClusterSetup setup = five_spheres(run.alpha, run.k);
  for (std::size_t i = 0; i < 5; ++i)
    csv += shortest(setup.spheres[i].position.y) + "," + shortest(setup.spheres[i].position.z) + "," +
           shortest(setup.spheres[i].radius) + "," + std::to_string(i + 1) + "\n";
  return {"cluster-start.csv", csv};
}

std::string pair_name(const Encounter& e) { return std::to_string(e.i + 1) + "-" + std::to_string(e.j + 1); }

/// How far the sphere that travels farthest gets, in words.
std::string farthest(const Run& run) {
  double most = 0;
  std::size_t sphere = 0;
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec3 way = run.samples.back().position[i] - run.samples.front().position[i];
    const double length = std::hypot(way.x, way.y, way.z);
    if (length > most) most = length, sphere = i + 1;
  }
  return "sphere " + std::to_string(sphere) + " goes farthest, " + console::significant(100 * most, 3) + " cm,";
}

/// |v| of sphere 1 at the end, in words.
std::string last_speed(const Run& run) {
  const Vec3 v = run.samples.back().velocity[0];
  return console::significant(std::hypot(v.x, v.y, v.z), 3) + " m/s";
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
    script += std::string(z) + "set title '" + title + "'\nplot ";
    script += "'cluster-start.csv' skip 1 using 1:2:3 with circles lc rgb '#767676' fs empty notitle";
    script +=
        ", \\\n  '' skip 1 using ($1+($4==3||$4==5?-1:1)*($3+0.006)):2:4 with labels font ',12' tc rgb '#767676' "
        "notitle";
    for (int i = 1; i <= 5; ++i)
      script += ", \\\n  '" + std::string(file) + "' skip 1 using " + column(i, 1) + ":" + column(i, 2) +
                " with lines lw 2.2 lc rgb '" + colours[i - 1] + "' title 'sphere " + std::to_string(i) + "'";
    script += "\n";
  }
  return {.name = "cluster-trajectories",
          .caption = "Fig. 7: trajectories of the five spheres, seen along x; circles: where they start.",
          .script = script + "unset multiplot\n",
          .data = {samples(strong, "cluster-strong.csv"), samples(weak, "cluster-weak.csv"), circles(strong)},
          .width = 900,
          .height = 560,
          .finding = "Sphere 1 comes from above and drives the others apart: " + farthest(strong) + " under strong, " +
                     farthest(weak) + " under weak repulsion."};
}

Figure velocities(const Run& strong, const Run& weak) {
  std::string script =
      "set multiplot layout 2,1 margins 0.09,0.78,0.10,0.97 spacing 0.1,0.04\n"
      "set key outside right center samplen 2\n";
  const auto panel = [&](const char* unit, const std::array<std::string, 3>& names, const Vec3& from, int first) {
    script += "set ylabel '" + std::string(unit) + "'\n";
    std::string separator = "plot ";
    for (int c = 0; c < 3; ++c)
      for (const auto& [file, dash, word] :
           {std::tuple("cluster-strong.csv", "dt (6,4)", "strong"), std::tuple("cluster-weak.csv", "dt 1", "weak")}) {
        script += separator + "'" + file + "' skip 1 using (1000*$1):($" + column(1, first + c) + "-(" +
                  shortest(std::array{from.x, from.y, from.z}[c]) + ")) with lines lw 2 " + dash + " lc rgb '" +
                  colours[c] + "' title '" + names[c] + ", " + word + "'";
        separator = ", \\\n  ";
      }
    script += "\n";
  };
  // Next to its first velocity, along z, what the collisions change would be lines on top of each other.
  script += "set format x ''\n";
  panel("velocity of sphere 1, less its first [m/s]", {"Δv_x", "Δv_y", "Δv_z"}, strong.samples.front().velocity[0], 3);
  script += "set format x '%g'\nset xlabel 't [ms]'\n";
  panel("spin of sphere 1 [1/s]", {"ω_x", "ω_y", "ω_z"}, {}, 6);
  return {.name = "cluster-velocities",
          .caption =
              "Fig. 8: velocity of sphere 1, less its first, and spin; dashed: strong repulsion (α = 0.01), solid: "
              "weak (α = 0.97).",
          .script = script + "unset multiplot\n",
          .data = {samples(strong, "cluster-strong.csv"), samples(weak, "cluster-weak.csv")},
          .width = 900,
          .height = 680,
          .finding = "Sphere 1 leaves at " + last_speed(strong) + " after strong and at " + last_speed(weak) +
                     " after weak collisions."};
}

Figure sequence(const Run& strong, const Run& weak, double until) {
  // One line a pair, in the order of the first touch; strong above weak.
  std::map<std::string, int> rows;
  std::string tics;
  for (const Run* run : {&strong, &weak})
    for (const Encounter& e : run->collisions)
      if (rows.emplace(pair_name(e), static_cast<int>(rows.size())).second)
        tics += (tics.empty() ? "'" : ", '") + pair_name(e) + "' " + std::to_string(rows.size() - 1);
  std::string csv = "pair,row,t_begin [s],t_end [s],weak\n";
  for (const Run* run : {&strong, &weak})
    for (const Encounter& e : run->collisions)
      csv += pair_name(e) + "," + shortest(rows[pair_name(e)] + (run == &strong ? -0.13 : 0.13)) + "," +
             shortest(e.begin) + "," + shortest(std::min(e.end, until)) + "," + (run == &strong ? "0" : "1") + "\n";
  const auto line = [](const char* which, const char* colour, const char* title) {
    return std::string("'cluster-sequence.csv' skip 1 using ($5==") + which +
           "?1000*$3:NaN):2:(1000*($4-$3)):(0) with vectors nohead lw 7 lc rgb '" + colour + "' title '" + title + "'";
  };
  return {
      .name = "cluster-sequence",
      .caption = "Fig. 9: when each pair collides, from the first touch to the first zero of the force.",
      .script = "set xlabel 't [ms]'\nset ylabel 'pair'\nset yrange [" + std::to_string(rows.size()) + "-0.4:-0.6]\n" +
                "set ytics (" + tics + ")\nset grid x\nset xrange [0:*]\nset key top right samplen 2\nplot " +
                line("0", colours[0], "strong, α = 0.01") + ", \\\n  " + line("1", colours[1], "weak, α = 0.97") + "\n",
      .data = {{"cluster-sequence.csv", csv}},
      .width = 800,
      .height = 400,
      .finding = "Several pairs collide at once for " +
                 console::fixed(100 * overlap(strong.collisions, until).shared, 0) +
                 " % of the collision time under strong and " +
                 console::fixed(100 * overlap(weak.collisions, until).shared, 0) + " % under weak repulsion."};
}

Figure binary(const std::vector<Run>& strong, const std::vector<Run>& weak, double until) {
  std::string csv = "k [kg/s^2],shared strong,pairs strong,shared weak,pairs weak\n";
  for (std::size_t n = 0; n < strong.size(); ++n) {
    const Overlap s = overlap(strong[n].collisions, until), w = overlap(weak[n].collisions, until);
    csv += shortest(strong[n].k) + "," + shortest(s.shared) + "," + shortest(s.mean_pairs) + "," + shortest(w.shared) +
           "," + shortest(w.mean_pairs) + "\n";
  }
  return {
      .name = "cluster-binary",
      .caption = "Share of the collision time during which more than one pair collides, against the stiffness k.",
      .script =
          "set logscale x\nset xrange [500:2e7]\nset xlabel 'k [kg/s²]'\nset format x '10^{%T}'\n"
          "set ylabel 'collision time shared by several pairs [%]'\nset yrange [-3:100]\n"
          "set key top right\nplot 'cluster-binary.csv' skip 1 using 1:(100*$2) with linespoints lw 2 pt 7 lc rgb '" +
          std::string(colours[0]) +
          "' title 'strong, α = 0.01', '' skip 1 using 1:(100*$4) with linespoints lw 2 pt 5 lc rgb '" + colours[1] +
          "' title 'weak, α = 0.97'\n",
      .data = {{"cluster-binary.csv", csv}},
      .width = 700,
      .height = 430,
      .finding = "From the softest to the stiffest k the share falls from " +
                 console::fixed(100 * overlap(strong.front().collisions, until).shared, 0) + " to " +
                 console::fixed(100 * overlap(strong.back().collisions, until).shared, 0) +
                 " % under strong and goes from " +
                 console::fixed(100 * overlap(weak.front().collisions, until).shared, 0) + " to " +
                 console::fixed(100 * overlap(weak.back().collisions, until).shared, 0) + " % under weak repulsion."};
}

}  // namespace ricochet::verify::cluster
