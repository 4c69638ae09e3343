#pragma once

#include <calibrate/fit.hpp>
#include <console/csv.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet::calibration {

/// A file of measurements.
struct Measured {
  std::vector<Measurement> data;
  std::vector<std::string> notes = {};  ///< what was assumed, and which columns were not read, in words
};

/// What the flags say of the bodies of every row.
struct Shots {
  std::optional<double> density = {};  ///< [kg/m³], for rows with a radius and no mass
  bool wall = false;                   ///< the sphere hits a wall; else one like it
};

/// Has the head a restitution, or what makes one?
bool states_restitution(const std::string& path, const console::CsvHead& head);

/// The rows of a CSV file, in any of the dialects of console/csv.hpp. Columns, with the names that people give them:
///
///   velocity [m/s] (v, speed, …) or drop_height [m] (h, h0): v = √(2 g h), g = 9.80665 m/s²
///   en (e, COR, …) or rebound_height [m] (h1): e = √(h₁/h₀), or rebound_velocity [m/s] (v1): e = v₁/v₀
///   en_sigma, tcol [s] and tcol_sigma [s]; mass [kg], radius [m] or diameter [m] of the sphere
///
/// or those of a bouncing ball, of which each two rows that follow each other make one impact (calibrate/flights.hpp):
///
///   flight_time [s], a row a flight; or bounce_start [s], bounce_end [s] and bounces: from one impact to the one so
///   many later; time_sigma [s], the standard error of the flight or of either instant; series: rows that belong
///   together, where there are several
///
/// and others, which are left and told of. Throws console::BadInput naming file and line, column, value and what is
/// accepted.
Measured read_measurements(const std::string& path, const Shots& shots = {});

}  // namespace ricochet::calibration
