#pragma once

#include <console/node.hpp>
#include <ricochet/contact/laws.hpp>

namespace ricochet::simulate {

/// The law that an object names, with its parameters; "end" is left to the caller. Throws console::BadInput.
AnyLaw read_law(const console::Node& node);

}  // namespace ricochet::simulate
