#pragma once

#include <string>
#include <string_view>

namespace ricochet::simulate {

/// FNV-1a of 64 bits (Fowler, Noll and Vo), as a decimal number. It tells texts apart that chance or a hand changed,
/// not those that somebody made to have the same.
std::string fingerprint(std::string_view text);

}  // namespace ricochet::simulate
