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
/// What a column of the table by engines is called: in a page there is room for names, on a terminal for numbers.
enum class Heads { names, numbers };
/// One row a case, one column an engine.
console::Table side_by_side(const std::vector<EngineGrade>& engines, Heads heads);
/// One row a case of each engine, for data.
console::Table grade_table(const std::vector<EngineGrade>& engines);
/// What is elsewhere, or does not converge, and why.
console::Table cause_table(const std::vector<EngineGrade>& engines);

console::Json to_json(const EngineGrade& engine);

/// "exact", "order 1.0", "elsewhere by 3.2 %", …
std::string in_short(const CaseGrade& grade);
/// The grade's first cause, or what else is to be said of it.
std::string why(const CaseGrade& grade);

}  // namespace ricochet::verify::conformance
