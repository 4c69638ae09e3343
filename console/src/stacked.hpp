#pragma once

#include <console/plot.hpp>

namespace ricochet::console {

/// The same figure for a screen as narrow as a phone's: its panels one below another, each with both its axes, and keys
/// that stood beside or below the panels under all of them.
Figure stacked(const Figure& figure);

}  // namespace ricochet::console
