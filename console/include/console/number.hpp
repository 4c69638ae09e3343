#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace ricochet::console {

/// Shortest decimal text that reads back as exactly `value`; independent of the locale.
std::string shortest(double value);

/// `value` with `digits` significant digits, in fixed or scientific notation, whichever is shorter.
std::string significant(double value, int digits);

/// `value` with `digits` digits after the point.
std::string fixed(double value, int digits);

/// `value` as d.ddde±xx with `digits` digits after the point.
std::string scientific(double value, int digits);

/// The finite number that the whole of `text` spells ("1e-4", "+0.5", "-3"), or nothing: no spaces, no trailing
/// text, no nan, no inf, no overflow. Independent of the locale. A number too small for double reads as nothing too.
std::optional<double> parse_number(std::string_view text);

}  // namespace ricochet::console
