#pragma once

#include <console/plot.hpp>
#include <console/table.hpp>

#include <vector>

namespace ricochet::verify::sphere {

/// e_n at one α: of the sphere in two ways, and of the laws that stand for it.
struct Row {
  double alpha;
  double ting, elements, doubt;    ///< the sphere; by elements with the difference of its last two limits
  double linear;                   ///< the paper's law
  double of_power, of_derivative;  ///< K D^α ζ^{3/2}, (3/2) K ζ^{1/2} D^α ζ

  double off(double law) const { return 100 * (law / ting - 1); }  ///< [%]
};

std::vector<Row> rows();
console::Table table(const std::vector<Row>& rows);
/// e_n over α, and what each law misses.
console::Figure figure();

/// What the paper's law misses at the α of a tan δ [%], α from 0.05 to 0.8.
struct Worst {
  double alpha, percent;
};
Worst worst_of_linear();

}  // namespace ricochet::verify::sphere
