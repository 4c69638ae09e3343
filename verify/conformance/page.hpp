#pragma once

#include "grade.hpp"

#include <verify/report.hpp>

#include <string>
#include <vector>

namespace ricochet::verify::conformance {

/// The page of all engines beside each other, each engine's grades with their causes, and the sources of the cases. It
/// loads nothing.
std::string conformance_page(const std::vector<EngineGrade>& engines, const Facts& made_by);

}  // namespace ricochet::verify::conformance
