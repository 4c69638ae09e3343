#pragma once

#include <verify/registry.hpp>

namespace ricochet::verify {

/// The JSON document of a study: {"schema", "claim", "verdict", <extra>, "gates", "rows"}.
console::Json study_json(const Study& study, const StudyResult& result);

/// The command line `verify <study>|all …`; returns the exit code.
int run_verify(const Studies& studies, int argc, const char* const* argv);

}  // namespace ricochet::verify
