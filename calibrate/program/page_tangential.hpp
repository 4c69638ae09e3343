#pragma once

#include "report.hpp"

#include <string>

namespace ricochet::calibration {

/// The page's section on oblique impacts: e_t over the angle under every law and for other β₀ and μ, and what one
/// percent of each input does to it. "" where the report has no tangential law or no friction.
std::string oblique_section(const Report& report);

}  // namespace ricochet::calibration
