#pragma once

#include <cstddef>
#include <string>

namespace ricochet::console {

/// More than a scene of ten million spheres.
inline constexpr std::size_t largest_input = std::size_t{1} << 30;  ///< bytes

/// All of a file of at most `largest_input` bytes. Throws BadInput naming path and reason.
std::string read_input(const std::string& path);

/// The same of a text, which goes on to terminals, JSON and pages: throws BadInput "file:line: byte 0xe4 is not UTF-8:
/// must be …" for the first that is none.
std::string read_text(const std::string& path);

}  // namespace ricochet::console
