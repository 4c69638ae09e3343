#pragma once

#include "grade.hpp"

#include <console/json.hpp>
#include <console/table.hpp>

#include <string>
#include <vector>

namespace ricochet::verify::conformance {

/// "LAMMPS 29 Sep 2021".
std::string label(const Results& results);

/// One row an engine, numbered: how many cases of each verdict.
console::Table engine_table(const std::vector<EngineGrade>& engines);
/// One row a case, one column an engine, called by its number in `engine_table`: a terminal has no room for names.
console::Table side_by_side(const std::vector<EngineGrade>& engines);
/// One row a case of each engine, for data.
console::Table grade_table(const std::vector<EngineGrade>& engines);
/// What is elsewhere, or does not converge, and why.
console::Table cause_table(const std::vector<EngineGrade>& engines);

console::Json to_json(const EngineGrade& engine);

/// "exact", "order 1.0", "elsewhere by 3.2 %", …
std::string in_short(const CaseGrade& grade);
/// The grade's causes, the note of what was not run, or that no known cause fits.
std::string cause_of(const CaseGrade& grade);
/// "✓ h^1.0", "✗ 3.2 %", …: as short as a column among many needs it, "–" for what was not run.
std::string sign_of(const CaseGrade& grade);
/// "5.3 % of the energy too much" for the answer, or too little; empty where it is neither, or not told.
std::string energy_of(const CaseGrade& grade);
/// The grade's causes, and what else is to be said of it.
std::string why(const CaseGrade& grade);

}  // namespace ricochet::verify::conformance
