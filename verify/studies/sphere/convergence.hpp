#pragma once

#include <verify/study.hpp>

#include <cstddef>
#include <vector>

namespace ricochet::verify::sphere {

/// A value on meshes that are refined, and the orders from each to the next. NaN where there is none.
struct Refinement {
  double alpha;
  std::vector<int> meshes;
  std::vector<double> en, error, order;

  /// Mean of the last three orders.
  double observed() const;
};

/// By elements, one a step: errors against Ting's formulation.
Refinement joint(double alpha);
/// The same without the term h^{2−α}, extrapolated from each run and the one before.
Refinement without_leading_term(const Refinement& joint);
/// 512 steps, ever more elements: errors are differences to the next finer one.
Refinement in_space(double alpha);
/// Ting's formulation on ever more nodes: errors against 64 of them.
Refinement of_ting(double alpha);

}  // namespace ricochet::verify::sphere
