#pragma once

#include <verify/gate.hpp>

#include <console/table.hpp>

#include <vector>

namespace ricochet::verify::figures {

/// The motion of Figs. 3 and 4 for α ≥ 1 by time steps, n = 2 in (32), against the closed form that draws it: errors of
/// the rate at the time up to which it is shown, on uniform and on graded meshes, and their orders.
struct ThirdGroup {
  double alpha;
  std::vector<int> steps;
  std::vector<double> uniform, graded;  ///< |error| in v₀
  double distance;                      ///< greatest at any node of the finest graded mesh, in v₀
};

std::vector<ThirdGroup> third_group();
console::Table table(const std::vector<ThirdGroup>& groups);
/// Orders from both sides: 3−α on uniform meshes, 2 on graded ones.
std::vector<Gate> gates(const std::vector<ThirdGroup>& groups);

}  // namespace ricochet::verify::figures
