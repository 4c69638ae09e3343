#pragma once

#include <console/node.hpp>
#include <ricochet/motion/normal_law.hpp>

namespace ricochet::simulate {

/// The law that an object names, with its parameters; "end" is left to the caller. Throws console::BadInput.
NormalLaw read_law(const console::Node& node);

}  // namespace ricochet::simulate
