#pragma once

#include <verify/study.hpp>

#include <ricochet/fractional/operators.hpp>

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify {

/// What a scheme is said to do, written down before it is measured.
struct Statement {
  std::string scheme;
  std::string function;
  double alpha = 0;
  std::optional<double> order;  ///< none: exact, the error being rounding only
  double allowed = 0.1;         ///< |observed − stated|
};

/// Largest error, relative to the scale, of what is said to be exact; what lies below is rounding.
inline constexpr double exact_bound = 1e-11;

/// Errors of one scheme on meshes of growing N, judged from both sides.
struct Convergence {
  Statement statement;
  std::vector<std::size_t> steps = {};
  std::vector<double> errors = {};  ///< |value − exact|; for solvers the mean over the offsets of the mesh
  std::vector<double> worst = {};   ///< over the offsets; empty where there is only one
  std::vector<double> values = {};  ///< signed errors, for the extrapolation; the mean over the offsets
  double rounding = exact_bound;    ///< errors below, relative to the scale, are left out of the observed order
  double scale = 1;                 ///< of the exact value, for "exact to rounding"
  double length = 1;                ///< N·Δt in the study's unit of time; 0: N counts no steps of one length

  /// Mean of the orders of the last three pairs of meshes whose errors stand above rounding, or of as many as there
  /// are.
  double observed() const;
  /// Order from mesh i − 1 to mesh i; NaN for the first.
  double pairwise(std::size_t i) const;
  /// The value extrapolated with the stated order from the last two meshes, less the exact one.
  double richardson_error() const;
  /// Roache's grid convergence index of the finest mesh, 1.25 |Δ|/(2^p − 1), relative to the scale.
  double grid_convergence_index() const;
  bool pass() const;
};

/// Rows as the interface promises them, with worst[], richardson_error, gci and allowed besides.
console::Json to_rows(const std::vector<Convergence>& all);
/// One gate a scheme, in the order of appearance: the largest |observed − stated|/allowed, and the largest error of
/// what is exact.
std::vector<Gate> to_gates(const std::vector<Convergence>& all);

/// A discrete operator under study: how to make it and what it is said to do.
struct Operator {
  enum class Samples { rate, values };
  std::string name;
  Samples samples = Samples::values;
  bool integral = false;  ///< I^β with β = the α of the row, else D^α
  using Make = ConvolutionRule(double alpha, double step, std::size_t steps);
  std::function<Make> make;
  /// Stated order on t^p with p = 1, 2, 3, on sin t (p = 0) and on the contact's own motion (p = −1).
  std::function<Statement(double alpha, int p)> statement;
};

std::vector<Operator> fractional_operators();

/// N = 16, 32, … `finest`.
std::vector<std::size_t> doubled_steps(std::size_t finest);

/// Error at t = 1 of one operator for one order and all five functions.
std::vector<Convergence> measure(const Operator& op, double alpha,
                                 const std::vector<std::size_t>& steps = doubled_steps(4096));

/// The α of all convergence studies.
inline constexpr double studied_orders[] = {0.1, 0.25, 0.5, 0.75, 0.9};

}  // namespace ricochet::verify
