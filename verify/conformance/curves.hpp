#pragma once

#include "groups.hpp"

#include <console/plot.hpp>

#include <optional>
#include <vector>

namespace ricochet::verify::conformance {

/// The greatest error in two families of cases, head-on and oblique impacts, against the steps in a collision, a curve
/// a group of engines; nothing where there is no error to draw.
std::optional<console::Figure> error_curves(const std::vector<EngineGroup>& groups);

}  // namespace ricochet::verify::conformance
