#pragma once

#include "grade.hpp"

#include <verify/report.hpp>

#include <string>
#include <vector>

namespace ricochet::verify::conformance {

/// The page of all engines beside each other: how many cases of each verdict, the verdicts of all cases, the errors of
/// two families against the steps, each cause once with its cases and engines; the grades of each engine, versions of
/// the same grades together; and the sources of the cases. It loads nothing. Throws as console::svg_of does.
std::string conformance_page(const std::vector<EngineGrade>& engines, const Facts& made_by);

}  // namespace ricochet::verify::conformance
