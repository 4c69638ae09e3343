#pragma once

#include <ricochet/support/text.hpp>

#include <optional>
#include <string_view>

namespace ricochet::console {

using support::fixed;
using support::scientific;
using support::shortest;
using support::significant;

/// The finite number that the whole of `text` spells ("1e-4", "+0.5", "-3"), or nothing: no spaces, no trailing
/// text, no nan, no inf, no overflow. Independent of the locale. A number too small for double reads as nothing too.
std::optional<double> parse_number(std::string_view text);

}  // namespace ricochet::console
