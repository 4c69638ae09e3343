#pragma once

#include <console/plot.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify {

/// One curve of shares; nothing where there is none.
struct ShareCurve {
  std::string id;
  std::vector<std::optional<double>> share;
};

/// Dissipated share against the number of beads (Fig. 6).
console::Figure share_figure(const std::vector<std::size_t>& beads, const std::vector<ShareCurve>& curves);

/// Dissipated share of `beads` beads against their gap [m].
console::Figure gap_figure(std::size_t beads, const std::vector<double>& gaps, const std::vector<ShareCurve>& curves);

}  // namespace ricochet::verify
