#pragma once

#include "forward.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <mutex>

namespace ricochet::calibration {

/// The fractional-hertz law at k = m = v₀ = 1 as a function of α and ln g, g = c there, for 0 < α < 1: products of
/// Chebyshev polynomials in α^{1/3} and ln g through numerical collisions. A collision that ends by force at small α
/// has ζ^{3/2} of the order of α left, so that α^{2/3} shows in t_col and α^{5/3} in e_n; in α^{1/3} both are smooth.
/// The plane is cut into cells, each made when it is first asked for, by 120 collisions, which take a quarter of a
/// second. Outside, and where a springpot close to a dashpot has nearly all of the force (α > 0.86 with g > 4), the
/// collision itself. Error: 1e-10, in t_col 2e-9 relative. Thread-safe.
class ForwardHertz {
 public:
  ForwardHertz() = default;
  Reduced operator()(double alpha, double log_group) const;

 private:
  static constexpr std::size_t across = 10, along = 12;                               // degrees of α^{1/3} and ln g
  static constexpr std::array roots{0.1, 0.3, 0.5, 0.7, 0.82, 0.9, 0.95, 0.98, 1.0};  // edges of cells in α^{1/3}
  static constexpr double low = -12, width = 1.5;                                     // of cells in ln g
  static constexpr std::size_t count = 15, few = 9;  // cells in ln g, and those where α^{1/3} > 0.95
  static constexpr double dashpot_like = 0.95;
  /// Values at the points of one cell.
  struct Cell {
    std::array<std::array<double, along>, across> en, log_tcol;
  };
  struct Place {
    std::once_flag made;
    std::unique_ptr<const Cell> cell;
  };
  const Cell& cell(std::size_t column, std::size_t row) const;

  mutable std::array<std::array<Place, count>, roots.size() - 1> cells_;
};

}  // namespace ricochet::calibration
