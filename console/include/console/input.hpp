#pragma once

#include <cstddef>
#include <string>

namespace ricochet::console {

/// More than a scene of ten million spheres.
inline constexpr std::size_t largest_input = std::size_t{1} << 30;  ///< bytes

/// All of a file of at most `largest_input` bytes. Throws BadInput naming path and reason.
std::string read_input(const std::string& path);

}  // namespace ricochet::console
