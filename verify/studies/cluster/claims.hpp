#pragma once

#include "run.hpp"

#include <verify/study.hpp>

#include <vector>

namespace ricochet::verify::cluster {

/// What the text says of Figs. 8 and 9, held against runs at the printed k and c, one of each state.
struct Pair {
  const Run &strong, &weak;
};

/// Fig. 8: sphere 1 against sphere 5. The paper: smaller ω_ξ, ω_η and torsion with sliding in the strong state, larger
/// ones and rolling in the weak one. `stiff`: at the k at which its mechanism is found.
void spin_gates(std::vector<Gate>& gates, const Pair& printed, const Pair& stiff);
Remark spin_remark(const Pair& printed, const Pair& stiff);

/// Fig. 9: what a duration would ask of k and c. Runs of either state over both.
console::Table duration_table(const std::vector<Run>& runs);
/// Of the scanned runs: at the printed k and c every collision outlasts every legible duration; in the weak state no k
/// brings all into the printed axis, a greater c does.
void duration_gates(std::vector<Gate>& gates, const std::vector<Run>& runs);
Remark duration_remark(const std::vector<Run>& runs);

}  // namespace ricochet::verify::cluster
