#pragma once

#include "grade.hpp"

#include <string>
#include <vector>

namespace ricochet::verify::conformance {

/// What a page that has `matrix` needs in its style.
extern const char* const matrix_style;

/// One row a case, by families, one narrow column an engine, numbered as in `engine_table`; each cell in its verdict's
/// colour and with a sign that does without it. As HTML.
std::string matrix(const std::vector<EngineGrade>& engines);

/// "right", "rule", …: the class of a verdict's colour.
const char* colour_class(Verdict verdict) noexcept;

}  // namespace ricochet::verify::conformance
