#pragma once

#include <ricochet/collision/power_law_sphere.hpp>

#include <cstddef>
#include <vector>

namespace ricochet {

/// The mesh of one run of `impact_by_elements`.
struct ElementMesh {
  int steps = 256;  ///< up to the turning point, at t_n ∝ (n/steps)²; the return's are of one size, the mean of these
  int every = 1;    ///< an element is touched at the end of every so many steps; divides `steps`
};

/// The impact of power_law_sphere as the model is told: elements are touched, each then keeps its own history of the
/// motion, is followed until its force is 0, and leaves for good. For studies; knows neither Ting's t₁ nor a series.
///
/// In a step ζ' is linear, each element's integral over it exact, the mass's momentum by the implicit trapezoid.
/// Between elements f is linear in the depth y at which they are touched, and integrated exactly with the weight
/// y^{−1/2} that dx = ½√R y^{−1/2} dy brings. The turning point is the last point of its mesh, whose length is solved
/// for; the end lies inside the last step. Order 2−α in both meshes, with a term of order 2 beside it
/// (docs/theory/sphere.md). Domain: 0 ≤ α ≤ 0.8, 8 ≤ steps ≤ 8192, every ≥ 1 a divisor of it; throws
/// std::invalid_argument otherwise. steps² powers, times about four.
SphereImpact impact_by_elements(double alpha, const ElementMesh& mesh);

/// e_n by elements, steps doubled from 32 on with an element for each, the terms h^{2−α} and h² taken out of three runs
/// in a row, until two such limits differ by no more than `tolerance` (or there are 2048 steps).
struct ElementsLimit {
  std::vector<int> steps;
  std::vector<double> en;       ///< of each run
  std::vector<double> without;  ///< of two runs, without h^{2−α}; starts with the second
  std::vector<double> limit;    ///< of three, without h² too; starts with the third
  double doubt;                 ///< difference of the last two limits
};
ElementsLimit limit_by_elements(double alpha, double tolerance = 1e-6);

}  // namespace ricochet
