#pragma once

#include "shares.hpp"

#include <console/plot.hpp>

#include <cstddef>
#include <vector>

namespace ricochet::verify::column {

/// Dissipated share against the number of beads (Fig. 6).
console::Figure share_figure(const std::vector<std::size_t>& beads, const std::vector<ShareCurve>& curves);

/// Dissipated share of `beads` beads against their gap [m].
console::Figure gap_figure(std::size_t beads, const std::vector<double>& gaps, const std::vector<ShareCurve>& curves);

}  // namespace ricochet::verify::column
