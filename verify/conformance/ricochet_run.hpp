#pragma once

#include "results.hpp"

namespace ricochet::verify::conformance {

/// Every case by our own stepping of many bodies, `Cluster`, from the same start and with as many steps as an engine:
/// another way than that of the answers.
Results run_ricochet(const std::vector<Case>& cases);

/// One run.
Run run_ricochet(const Case& of, int steps);

}  // namespace ricochet::verify::conformance
