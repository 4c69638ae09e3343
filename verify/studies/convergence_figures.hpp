#pragma once

#include "convergence.hpp"

#include <console/plot.hpp>

#include <string>
#include <vector>

namespace ricochet::verify {

/// Error against N, log-log: one figure a scheme, one panel an α, one curve a function, and under the curves of each
/// stated order a triangle of that slope. What is exact is left out; so is a scheme of nothing else. The files are
/// named <prefix>-<scheme>.
std::vector<console::Figure> convergence_figures(const std::vector<Convergence>& all, const std::string& prefix);

}  // namespace ricochet::verify
