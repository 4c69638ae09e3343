#pragma once

#include <console/plot.hpp>

namespace ricochet::console {

/// The same figure for a screen as narrow as a phone's: its panels one below another, each with both its axes and its
/// key under it.
Figure stacked(const Figure& figure);

}  // namespace ricochet::console
