#pragma once

#include <verify/study.hpp>

namespace ricochet::verify {

/// The JSON document of a study: {"schema", "claim", "verdict", <extra>, "gates", "remarks", "rows"}.
console::Json study_json(const Study& study, const StudyResult& result);

/// What `verify <study> --format …` prints.
std::string study_text(const Study& study, const StudyResult& result, console::Format format);

}  // namespace ricochet::verify
