#pragma once

#include "job.hpp"

#include <calibrate/materials.hpp>
#include <console/exit.hpp>

#include <string>
#include <vector>

namespace ricochet::calibration {

/// Reads the text of a file of materials: docs/materials.md says what it holds. `file` only names it in messages.
/// Throws console::BadInput with one line "file:line:column: /path = value: must be …" for a syntax error, a repeated
/// or unknown key, a wrong type, a number out of range, and a pair that is missing, given twice or without a scale.
Materials read_materials(const std::string& file, const std::string& text);

/// `calibrate --materials`: reads, calibrates every pair and writes tables, JSON or an engine's contact block.
console::Exit run_materials(const Options& options);

}  // namespace ricochet::calibration
