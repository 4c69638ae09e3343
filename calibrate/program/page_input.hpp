#pragma once

#include "report.hpp"

#include <string>

namespace ricochet::calibration {

/// For a section of a page: each law in each engine's language, with a button to copy it; "" without laws.
std::string input_section(const Report& report);

}  // namespace ricochet::calibration
