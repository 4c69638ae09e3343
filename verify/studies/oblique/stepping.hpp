#pragma once

#include "../benchmarks/row.hpp"

namespace ricochet::verify::oblique {

/// Velocity and spin after the impact of the measured grain as a cluster steps it, against the oblique collision with
/// the cluster's contact point: contacts that stick for most of the time, that slide, and that do both.
std::vector<benchmarks::Row> stepping_rows();

}  // namespace ricochet::verify::oblique
