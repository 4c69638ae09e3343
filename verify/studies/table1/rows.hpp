#pragma once

#include "variants.hpp"

#include <console/json.hpp>
#include <console/table.hpp>
#include <ricochet/collision/solvers/fractional_solvers.hpp>

#include <vector>

namespace ricochet::verify::table1 {

/// A line of the printed table: the state at the end of the collision of Fig. 2, by that many steps.
struct Line {
  int steps = 0;  ///< dN; 0 for the limit
  Instant printed;
};

/// Throws console::Failed where the file cannot be read.
std::vector<Line> printed_lines();

// The law of Fig. 2, and its closed form for a density [kg/m³].
Fractional law();
double exact_tcol(double density);  ///< [s]
Instant exact_state(double density, double time);

/// The state after `steps` steps of a solver of the library that end at `time`.
Instant stepped_state(FractionalScheme scheme, double density, double time, int steps);

/// (59) with step means by RK4: of the variants the nearest to the printed overlaps at 20 and 40 steps.
inline constexpr Variant step_means{Held::mean, Stepper::rk4};
/// (59) as written, in a predictor-corrector.
inline constexpr Variant left_values{Held::left, Stepper::heun};

/// A density, a time at which the run stops, a line of the printed table and what is computed beside it.
struct Row {
  double density = 0, time = 0;
  bool rounded_end = false;  ///< the time as printed, else the exact collision time of this density
  Line line;
  Instant left, means, arms, exact;
};
std::vector<Row> rows_of(const std::vector<Line>& lines);
console::Table table_of(const std::vector<Row>& rows);
console::Json rows_json(const std::vector<Row>& rows);

/// One variant of (59) with one density and end, and its last velocity for each number of steps that is printed.
struct Trial {
  Variant variant;
  double density = 0, time = 0;
  std::vector<double> velocities;
  double farthest = 0;  ///< from the printed ones, in units of their last digit
};
std::vector<Trial> trials_of(const std::vector<Line>& lines);
console::Table table_of(const std::vector<Trial>& trials, const std::vector<Line>& lines);

}  // namespace ricochet::verify::table1
