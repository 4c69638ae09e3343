#pragma once

#include "case.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ricochet::verify::conformance {

/// Half a unit of the last place of each number of a run, as it was printed.
struct Rounded {
  std::vector<Body> bodies = {};  ///< none: nothing was rounded
  double contact_time = 0, max_overlap = 0;
};

/// One run of a case: the state at its end.
struct Run {
  int steps = 0;             ///< in the case's time scale
  std::vector<Body> bodies;  ///< of the case's radii and masses
  std::optional<double> contact_time = {}, max_overlap = {};
  Rounded rounded = {};
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
/// that come twice and runs without all bodies, and for a file that is not UTF-8.
///
/// What printing took of the numbers is read off the file: where all have as many places behind the point and none an
/// exponent ("%.6f"), half a unit of the last; else ("%g") each is known to as many digits as its longest has, since
/// trailing zeros may be left out.
Results read_results(const std::string& path, const std::vector<Case>& cases);

/// The same as text.
std::string results_text(const Results& results);

}  // namespace ricochet::verify::conformance
