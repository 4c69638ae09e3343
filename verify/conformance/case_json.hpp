#pragma once

#include "case.hpp"

#include <console/json.hpp>

namespace ricochet::verify::conformance {

/// "ricochet/case/1", see docs/conformance.md. Answers are computed anew.
console::Json to_json(const Case& of);
console::Json to_json(const Orders& expected);

}  // namespace ricochet::verify::conformance
