#pragma once

#include <verify/registry.hpp>

namespace ricochet::verify {

/// The command line `verify <study>|all …`; returns the exit code.
int run_verify(const Studies& studies, int argc, const char* const* argv);

}  // namespace ricochet::verify
