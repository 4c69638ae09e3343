#include "../paper.hpp"

#include <verify/registry.hpp>

#include <console/exit.hpp>
#include <console/number.hpp>
#include <ricochet/collision/fractional_contact.hpp>
#include <ricochet/collision/solvers/fractional_solvers.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace ricochet::verify {

namespace {

using console::Json;
using console::Notation;
using console::Table;

using paper::steel;
const Fractional law(steel.k, steel.c, steel.alpha);
constexpr double densities[] = {steel.density, steel.other_density};

/// Overlap [m], rate [m/s] and force [N] at one time.
struct State {
  double overlap, rate, force;
};

struct Line {
  int steps;  ///< dN; 0 for the limit
  State paper;
};

/// The printed table; throws console::Failed where the file cannot be read.
std::vector<Line> printed_lines() {
  const std::string path = fmt::format("{}/table1.csv", data_folder());
  std::ifstream file(path);
  if (!file) throw console::Failed(fmt::format("{}: cannot read", path));
  std::vector<Line> lines;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#' || line.starts_with("dN")) continue;
    std::istringstream fields(line);
    double value[5];
    for (double& v : value) {
      std::string digits;
      std::getline(fields, digits, ',');
      const auto number = console::parse_number(digits);
      if (!number) throw console::Failed(fmt::format("{}: {}: not a number", path, line));
      v = *number;
    }
    lines.push_back({static_cast<int>(value[0]), {value[2], value[3], value[4]}});
  }
  return lines;
}

FractionalTrajectory trajectory(double density) {
  return {law.coefficient(), law.alpha(), steel.impact(density).mass_eff, steel.velocity};
}

double exact_tcol(double density) { return fractional_contact(law.alpha()).tau * trajectory(density).time_scale(); }

State exact_state(double density, double time) {
  const FractionalTrajectory motion = trajectory(density);
  return {motion.overlap(time), motion.rate(time), motion.force(time)};
}

/// The state after `steps` steps that end at `time`.
State stepped_state(FractionalScheme scheme, double density, double time, int steps) {
  const FractionalSolverOptions options{.step = time / steps, .end_time = time};
  const FractionalState end = solve_collision(scheme, law, steel.impact(density), options).path.back();
  return {end.overlap, end.rate, end.force};
}

/// One row: a density, a time at which the run stops, a number of steps.
struct Row {
  double density, time;
  bool printed;  ///< the time as printed, else the exact collision time of this density
  Line line;
  State literal, best, exact;
};

std::vector<Row> rows_of(const std::vector<Line>& lines) {
  std::vector<Row> rows;
  for (const double density : densities)
    for (const bool printed : {true, false}) {
      const double time = printed ? steel.tcol : exact_tcol(density);
      for (const Line& line : lines) {
        const State exact = exact_state(density, time);
        Row row{density, time, printed, line, exact, exact, exact};
        if (line.steps > 0) {
          row.literal = stepped_state(FractionalScheme::rectangle, density, time, line.steps);
          row.best = stepped_state(FractionalScheme::arms_exponential, density, time, line.steps);
        }
        rows.push_back(row);
      }
    }
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
    const auto add = [&](const char* source, const State& s) {
      table.row({row.density, row.time * 1e6,
                 row.line.steps > 0 ? console::Cell(std::int64_t{row.line.steps}) : "limit", source, s.overlap * 1e6,
                 s.rate, s.force});
    };
    if (row.printed) add("paper", row.line.paper);
    if (row.line.steps > 0) {
      add("(59) literally", row.literal);
      add("arms, exponential", row.best);
    } else {
      add("exact", row.exact);
    }
  }
  table.note(
      "The paper's runs end at the assumed 38.6e-6 s; its integrator is not named. Each density also ends at its own "
      "exact collision time.");
  return table;
}

Json to_json(const State& s) { return {{"overlap", s.overlap}, {"velocity", s.rate}, {"force", s.force}}; }

Json rows_json(const std::vector<Row>& rows) {
  Json all = Json::array();
  for (const Row& row : rows)
    all.push_back({{"density", row.density},
                   {"time", row.time},
                   {"printed_time", row.printed},
                   {"dN", row.line.steps},
                   {"paper", to_json(row.line.paper)},
                   {"ours", to_json(row.literal)},
                   {"best", to_json(row.best)},
                   {"exact", to_json(row.exact)}});
  return all;
}

/// Errors against the exact state at the same time, in units of the greatest overlap, v₀ and the greatest force.
double distance(const State& a, const State& b, double density) {
  const FractionalContact contact = fractional_contact(law.alpha());
  const double tcol = exact_tcol(density);
  return std::max(
      {std::fabs(a.overlap - b.overlap) / (contact.max_overlap * steel.velocity * tcol),
       std::fabs(a.rate - b.rate) / steel.velocity,
       std::fabs(a.force - b.force) / (contact.max_force * steel.impact(density).mass_eff * steel.velocity / tcol)});
}

/// Order of a scheme at the exact collision time: the distance to the exact state for 320 … 2560 steps.
double order_of(FractionalScheme scheme) {
  const double density = densities[0], time = exact_tcol(density);
  const State exact = exact_state(density, time);
  const auto error = [&](int n) { return distance(stepped_state(scheme, density, time, n), exact, density); };
  return std::log2(error(320) / error(2560)) / 3;
}

bool within(double value, double printed, double last_digit) { return std::fabs(value - printed) <= 0.5 * last_digit; }

/// Do a density's exact t_col and estimate (57) round to the printed 38.6 and 37.8 µs?
bool prints_times(double density) {
  const double coefficient = law.coefficient() / steel.impact(density).mass_eff;
  return within(exact_tcol(density), steel.tcol, steel.last_digit) &&
         within(tcol_estimate(coefficient, law.alpha()), steel.tcol_estimate, steel.last_digit);
}

/// Does its exact overlap and velocity at the end round to the printed limit?
bool prints_end(double density, const State& paper) {
  const State s = exact_state(density, exact_tcol(density));
  return within(s.overlap, paper.overlap, 1e-11) && within(s.rate, paper.rate, 1e-5);
}

struct Orders {
  double literal, best;  ///< of (59) as written and of the arms' exponential step
  double paper;          ///< of the paper's digits, from 5 to 20 steps
};

Orders orders_of(const std::vector<Line>& lines) {
  const State limit = lines.back().paper;
  const double at_20 = distance(lines[1].paper, limit, densities[0]);
  const double at_5 = distance(lines[0].paper, limit, densities[0]);
  return {order_of(FractionalScheme::rectangle), order_of(FractionalScheme::arms_exponential),
          std::log(at_5 / at_20) / std::log(4.0)};
}

std::vector<Gate> gates(const Orders& orders) {
  std::vector<Gate> all{holds("7850 kg/m3 prints t_col = 38.6e-6 s and (57) = 37.8e-6 s", prints_times(steel.density)),
                        holds("7680 kg/m3 does not", !prints_times(steel.other_density)),
                        near("order of (59) as written, at the exact t_col", orders.literal, 1, 0.1),
                        near("order of the arms' exponential step", orders.best, 2, 0.1)};
  for (const double density : densities) {
    const double rate = exact_state(density, exact_tcol(density)).rate;
    all.push_back(at_most(fmt::format("exact velocity at t_col is -e_n v0, {} kg/m3", density),
                          std::fabs(rate + steel.velocity * fractional_contact(law.alpha()).en), 1e-12));
  }
  return all;
}

std::string verdict(const Orders& orders) {
  const auto overlap = [](double density) { return 1e6 * exact_state(density, exact_tcol(density)).overlap; };
  std::string reproduces;
  for (const double density : densities)
    reproduces += fmt::format("{}{} {}", reproduces.empty() ? "" : ", ", density,
                              prints_times(density) ? "kg/m3 reproduces the printed times" : "kg/m3 does not");
  return fmt::format(
      "{}; the exact overlap at the exact t_col is {:.5f} (7850) and {:.5f} (7680), printed 3.94422 (1e-6 m). (59) as "
      "written is of order {:.2f}; the paper's own digits fall from 5 to 20 steps like order {:.1f}.",
      reproduces, overlap(steel.density), overlap(steel.other_density), orders.literal, orders.paper);
}

class Table1 : public Study {
 public:
  std::string name() const override { return "table1"; }
  std::string claim() const override {
    return "Table I: the paper chooses the number of steps from the end of the collision of Fig. 2, and calls (59) "
           "accurate to a high power of it";
  }
  StudyResult run(const RunOptions&) override {
    const std::vector<Line> lines = printed_lines();
    const std::vector<Row> rows = rows_of(lines);
    const Orders orders = orders_of(lines);
    StudyResult result;
    result.tables.push_back(table_of(rows));
    result.rows = rows_json(rows);
    result.gates = gates(orders);
    result.extra["order_of_59"] = orders.literal;
    result.extra["order_of_paper_digits_5_to_20"] = orders.paper;
    const State& limit = lines.back().paper;
    result.extra["end_rounds_to_print"] = {{"7850", prints_end(steel.density, limit)},
                                           {"7680", prints_end(steel.other_density, limit)}};
    result.verdict = verdict(orders);
    return result;
  }
};

}  // namespace

std::unique_ptr<Study> table1_study() { return std::make_unique<Table1>(); }

}  // namespace ricochet::verify
