#pragma once

#include <cstddef>
#include <string>

namespace ricochet::console {

/// "line:column", both from 1, of byte `offset` of the text.
std::string line_and_column(const std::string& text, std::size_t offset);

/// Where the value at a JSON path ("/spheres/0/radius", keys as they are in the file) begins in the text of a valid
/// JSON document; where the path's last value that there is does, if it leads nowhere.
std::size_t place_of(const std::string& text, const std::string& path);

}  // namespace ricochet::console
