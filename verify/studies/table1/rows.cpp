#include "rows.hpp"

#include "../paper.hpp"

#include <verify/study.hpp>

#include <console/csv.hpp>
#include <console/number.hpp>
#include <ricochet/collision/fractional_contact.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace ricochet::verify::table1 {

namespace {

using console::Json;
using console::Notation;
using console::Table;

using paper::steel;
constexpr double densities[] = {steel.density, steel.other_density};

FractionalTrajectory trajectory(double density) {
  return {law().coefficient(), law().alpha(), steel.impact(density).mass_eff, steel.velocity};
}

Row row_of(double density, bool rounded_end, const Line& line) {
  const double time = rounded_end ? steel.tcol : exact_tcol(density);
  const Instant exact = exact_state(density, time);
  Row row{density, time, rounded_end, line, exact, exact, exact, exact};
  if (line.steps == 0) return row;
  row.left = stepped_state(FractionalScheme::rectangle, density, time, line.steps);
  row.means = end_of(step_means, law(), steel.impact(density), time, line.steps);
  row.arms = stepped_state(FractionalScheme::arms_exponential, density, time, line.steps);
  return row;
}

Json to_json(const Instant& s) { return {{"overlap", s.overlap}, {"velocity", s.rate}, {"force", s.force}}; }

}  // namespace

std::vector<Line> printed_lines() {
  constexpr std::array columns{console::CsvColumn{"dN", "", true}, console::CsvColumn{"dt", "s", true},
                               console::CsvColumn{"overlap", "m", true}, console::CsvColumn{"velocity", "m/s", true},
                               console::CsvColumn{"force", "N", true}};
  console::CsvReader file(data_folder() + "/table1.csv", columns);
  std::vector<Line> lines;
  while (file.next())
    lines.push_back({static_cast<int>(file.number(0)), {0, file.number(2), file.number(3), file.number(4)}});
  return lines;
}

Fractional law() { return {steel.k, steel.c, steel.alpha}; }

double exact_tcol(double density) { return fractional_contact(steel.alpha).tau * trajectory(density).time_scale(); }

Instant exact_state(double density, double time) {
  const FractionalTrajectory motion = trajectory(density);
  return {time, motion.overlap(time), motion.rate(time), motion.force(time)};
}

Instant stepped_state(FractionalScheme scheme, double density, double time, int steps) {
  const FractionalSolverOptions options{.step = time / steps, .end_time = time};
  return solve_collision(scheme, law(), steel.impact(density), options).path.back();
}

std::vector<Row> rows_of(const std::vector<Line>& lines) {
  std::vector<Row> rows;
  for (const double density : densities)
    for (const bool rounded_end : {false, true})
      for (const Line& line : lines) rows.push_back(row_of(density, rounded_end, line));
  return rows;
}

Table table_of(const std::vector<Row>& rows) {
  Table table({{"density", "kg/m3"},
               {"ends at", "1e-6 s", {Notation::Kind::fixed, 4}},
               {"dN"},
               {"source"},
               {"overlap", "1e-6 m", {Notation::Kind::fixed, 5}},
               {"velocity", "m/s", {Notation::Kind::fixed, 5}},
               {"force", "N", {Notation::Kind::fixed, 5}}},
              "Table I: the collision of Fig. 2 at its end, by dN steps");
  for (const Row& row : rows) {
    const bool limit = row.line.steps == 0;
    const std::string steps = limit ? "limit" : fmt::format("{}", row.line.steps);
    const auto add = [&](const char* source, const Instant& s) {
      table.row({row.density, row.time * 1e6, steps, source, s.overlap * 1e6, s.rate, s.force});
    };
    if (!row.rounded_end && row.density == steel.density) add("paper", row.line.printed);
    if (limit) {
      add("exact", row.exact);
    } else {
      add("(59), left values", row.left);
      add("(59), step means", row.means);
      add("arms, exponential", row.arms);
    }
  }
  table.note(
      "The paper's rows stand beside the end at the unrounded collision time, where its limit of the force, 0, "
      "belongs. "
      "Left values: predictor-corrector; step means: RK4; the paper names neither.");
  return table;
}

Json rows_json(const std::vector<Row>& rows) {
  Json all = Json::array();
  for (const Row& row : rows)
    all.push_back({{"density", row.density},
                   {"time", row.time},
                   {"printed_time", row.rounded_end},
                   {"dN", row.line.steps},
                   {"paper", to_json(row.line.printed)},
                   {"ours", to_json(row.left)},
                   {"step_means", to_json(row.means)},
                   {"best", to_json(row.arms)},
                   {"exact", to_json(row.exact)}});
  return all;
}

std::vector<Trial> trials_of(const std::vector<Line>& lines) {
  std::vector<Trial> trials;
  for (const double density : densities)
    for (const double time : {exact_tcol(density), steel.tcol})
      for (const Held held : {Held::left, Held::mean, Held::chord})
        for (const Stepper stepper : {Stepper::heun, Stepper::rk4}) {
          Trial trial{{held, stepper}, density, time, {}};
          for (const Line& line : lines) {
            if (line.steps == 0) continue;
            const double velocity = end_of(trial.variant, law(), steel.impact(density), time, line.steps).rate;
            trial.velocities.push_back(velocity);
            const double digits = std::fabs(velocity - line.printed.rate) / steel.last_digit_velocity;
            trial.farthest = std::max(trial.farthest, digits);
          }
          trials.push_back(trial);
        }
  return trials;
}

Table table_of(const std::vector<Trial>& trials, const std::vector<Line>& lines) {
  const Notation velocity{Notation::Kind::fixed, 5};
  std::vector<console::Column> columns{
      {"(59) by"}, {"density", "kg/m3"}, {"ends at", "1e-6 s", {Notation::Kind::fixed, 4}}};
  std::vector<console::Cell> printed{"paper", console::blank(), console::blank()};
  for (const Line& line : lines) {
    if (line.steps == 0) continue;
    columns.push_back({fmt::format("dN = {}", line.steps), "m/s", velocity});
    printed.push_back(line.printed.rate);
  }
  columns.push_back({"farthest from print", "1e-5 m/s", {Notation::Kind::fixed, 1}});
  printed.push_back(console::blank());
  Table table(columns, "What the paper may have run: the last velocity by every variant tried");
  table.row(printed);
  for (const Trial& t : trials) {
    std::vector<console::Cell> cells{name(t.variant), t.density, 1e6 * t.time};
    cells.resize(columns.size(), t.farthest);
    std::copy(t.velocities.begin(), t.velocities.end(), cells.begin() + 3);
    table.row(cells);
  }
  return table;
}

}  // namespace ricochet::verify::table1
