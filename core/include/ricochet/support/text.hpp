#pragma once

#include <string>

namespace ricochet::support {

// Numbers as text, for the library's messages and all that the programs write. By std::to_chars: core needs no more for
// its few messages, so that whoever links it needs no formatting library; and fmt, by which the programs put sentences
// together, writes 0.0001 where the shortest text of a double is 1e-04, which every file and golden answer holds.

/// Shortest decimal text that reads back as exactly `value`; independent of the locale.
std::string shortest(double value);

/// The same, appended: for rows of which there are a million a second.
void append_shortest(std::string& text, double value);

/// `value` with `digits` significant digits, in fixed or scientific notation as printf's %g chooses.
std::string significant(double value, int digits);

/// `value` with `digits` digits after the point; what rounds to 0 has no sign.
std::string fixed(double value, int digits);

/// `value` as d.ddde±xx with `digits` digits after the point.
std::string scientific(double value, int digits);

}  // namespace ricochet::support
