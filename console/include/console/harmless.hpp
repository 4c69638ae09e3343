#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace ricochet::console {

// Words of somebody's files on their way to terminals, tables and the lines of other files.

/// How many of its first bytes are a character that a terminal or a line of a file would take as a command: of ASCII's
/// and, in UTF-8, of Latin-1's second set (U+0080 to U+009F); else 0.
std::size_t control_length(std::string_view text) noexcept;

bool has_controls(std::string_view text) noexcept;

/// With a question mark for each of them; line ends stay where `lines`.
std::string without_controls(std::string text, bool lines = false);

/// Whether a table may show the word: it has no such characters and does not begin like a spreadsheet's formula
/// (= + - @).
bool is_harmless(std::string_view word) noexcept;
inline constexpr std::string_view harmless_words = "of printable characters and begin with none of = + - @";

}  // namespace ricochet::console
