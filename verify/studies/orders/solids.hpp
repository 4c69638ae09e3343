#pragma once

#include "../convergence.hpp"
#include "../selection.hpp"

#include <string>
#include <vector>

namespace ricochet::verify {

/// The laws of real solids: their collisions by each method against another, and a bead on arms in the column engine
/// against them. docs/theory/orders.md says why each order.
std::vector<std::string> solid_schemes();
std::vector<Convergence> measure_solids(const Selection& wanted);

}  // namespace ricochet::verify
