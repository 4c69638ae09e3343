#pragma once

#include "case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify::conformance {

/// One run of a case: the state at its end.
struct Run {
  int steps = 0;             ///< in the case's time scale
  std::vector<Body> bodies;  ///< of the case's radii and masses
  std::optional<double> contact_time = {}, max_overlap = {};
};

/// What an engine gave for a case.
struct CaseResult {
  std::string name;
  std::vector<Run> runs = {};  ///< the coarsest first
  std::string note = {};       ///< why there is no run, or what is to be said of them
};

/// A results file: one engine.
struct Results {
  std::string engine, version, date, by;
  std::vector<CaseResult> cases = {};  ///< in the order of the file

  const CaseResult* find(const std::string& name) const;
};

/// Comment lines "# engine: …", "# version: …", "# date: …", "# by: …" and the rows, see docs/conformance.md. Throws
/// console::BadInput "file:line: column = value: must be …" for a case that is none, numbers that are not finite, rows
/// that come twice and runs without all bodies.
Results read_results(const std::string& path, const std::vector<Case>& cases);

/// The same as text.
std::string results_text(const Results& results);

}  // namespace ricochet::verify::conformance
