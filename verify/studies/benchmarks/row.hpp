#pragma once

#include <verify/gate.hpp>

#include <console/json.hpp>
#include <console/table.hpp>

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify::benchmarks {

/// What is asked of the error.
enum class Check {
  order,    ///< both its order and its size
  size,     ///< its size; terms of both signs make the order what it may be at these meshes
  rounding  ///< the scheme is exact
};

/// One number that a benchmark asks for, with all that is claimed of it before it is measured.
struct Asked {
  std::string test;      ///< "Chung & Ooi 1, glass"
  std::string quantity;  ///< "greatest overlap"
  std::string unit = {};
  double exact = 0;                       ///< by a closed form, or integrated to far more digits
  double scale = 0;                       ///< errors count relative to it
  std::pair<double, double> order{2, 2};  ///< that the error falls with, least and greatest
  Check check = Check::order;
  std::optional<double> published = {};
  double reading = 0;  ///< half of the published number's last digit, or what reading it off a curve may be wrong by
};

/// What the cluster makes of it.
struct Row {
  Asked asked;
  double ours = 0;                 ///< on the finest mesh
  std::array<double, 3> errors{};  ///< relative; means over meshes of n, 2n and 4n steps a collision
  double noise = 0;                ///< three standard errors of the observed order

  double order() const;  ///< from n to 4n
};

/// All numbers of a run with that step [s], in the order of what was asked.
using Measurement = std::function<std::vector<double>(double step)>;

inline constexpr int coarsest = 100;  ///< steps a collision

/// Where a touch falls between two steps moves every error by tens of percent, so each is the mean over four
/// dozen of meshes a little apart.
std::vector<Row> measure(const std::vector<Asked>& asked, double tcol, const Measurement& values);

/// Orders from both sides; the error on the finest mesh, at most (π/N)^p with the least order p (at p = 2 some twenty
/// times what a leapfrog's phase is off after half a swing); and the published number within its reading.
void add_gates(std::vector<Gate>& gates, const std::vector<Row>& rows);

console::Table table(const std::vector<Row>& rows);
console::Json to_json(const Row& row);

}  // namespace ricochet::verify::benchmarks
