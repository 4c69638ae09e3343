#pragma once

#include <optional>
#include <string>

namespace ricochet::console {

/// The decimal number of the text times a power of ten, rounded once: the exponent is changed before it is read.
std::optional<double> scaled(const std::string& number, int exponent);

}  // namespace ricochet::console
