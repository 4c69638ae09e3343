#pragma once

#include <verify/registry.hpp>

namespace ricochet::verify {

/// The command line `verify <study>|all …`; returns the exit code. `checks` judge what the user gives: they are
/// commands like the studies, but no part of `all`.
int run_verify(const Studies& studies, const Studies& checks, int argc, const char* const* argv);

}  // namespace ricochet::verify
