#pragma once

#include "grade.hpp"

#include <string>
#include <vector>

namespace ricochet::verify::conformance {

/// Engines, or versions of one, of which a page shows the same of every case; in the order of their first.
using EngineGroup = std::vector<const EngineGrade*>;
std::vector<EngineGroup> grouped(const std::vector<EngineGrade>& engines);

/// "LAMMPS 29 Sep 2021, 4 Feb 2025; Yade 2025.2.0".
std::string labels(const EngineGroup& group);

/// What is said of cases, by engines of which all say it of the same ones.
struct Reason {
  std::string what;
  std::vector<std::string> cases = {};
  EngineGroup engines = {};
};
/// Why cases have one of these verdicts: `cause_of` or, of what was not run, the note.
std::vector<Reason> reasons(const std::vector<EngineGrade>& engines, const std::vector<Verdict>& taken);

}  // namespace ricochet::verify::conformance
