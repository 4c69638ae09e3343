#pragma once

// LAMMPS's headers of 2021 hand their format strings to fmt::make_args_checked, which libfmt has no more from version 9
// on. Nothing here calls those overloads: messages are made by fmt::format and handed over as std::string.
#include <fmt/format.h>

#if FMT_VERSION >= 90000
namespace fmt {
template <class... Args, class Text>
format_args make_args_checked(const Text&, const Args&...);
}
#endif

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "input.h"
#include "lammps.h"
#include "memory.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"
#include "utils.h"
