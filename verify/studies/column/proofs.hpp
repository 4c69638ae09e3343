#pragma once

#include <verify/gate.hpp>

#include <console/table.hpp>

#include <vector>

namespace ricochet::verify::column {

/// What the column engine must do whatever the paper says: one bead, known energies, wide gaps, observed orders.
struct ColumnProofs {
  std::vector<Gate> gates;
  console::Table known;   ///< touching linear beads against the energies of an independent calculation
  console::Table orders;  ///< differences of E/E0 under halving of the step, and the order that they show
};

ColumnProofs column_proofs();

}  // namespace ricochet::verify::column
