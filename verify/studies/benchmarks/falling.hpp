#pragma once

#include "row.hpp"

namespace ricochet::verify::benchmarks {

/// MFiX's DEM01–DEM04 (R. Garg, J. Galvin, T. Li, S. Pannala, Documentation of open-source MFIX-DEM software for
/// gas-solids flows, 2012; set-ups as in tests/dem of its repository): a sphere that falls on a wall, one that goes on
/// bouncing, two that are pressed together between two walls, and one that slides on a rough floor until it rolls.
std::vector<Row> falling_rows();

}  // namespace ricochet::verify::benchmarks
