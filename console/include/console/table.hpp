#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ricochet::console {

/// latex and junit are for programs that offer them: see add_output_options.
enum class Format { table, json, csv, markdown, latex, junit };

/// How a column's numbers are shown in text and markdown; CSV always carries full double precision.
struct Notation {
  enum class Kind { significant, fixed, scientific } kind = Kind::significant;
  int digits = 6;
};

enum class Align { automatic, left, right };  ///< automatic: numbers right, everything else left

struct Column {
  std::string name;
  std::string unit = {};  ///< empty when there is none
  Notation notation = {};
  Align align = Align::automatic;
};

/// A value in a table; std::monostate is "no value": "-" in text, an empty field in CSV, null in JSON.
using Cell = std::variant<std::monostate, std::string, double, std::int64_t, bool>;

/// Short ways to write a cell. A number must be finite; `number_or_blank` turns one that is not into "no value".
Cell blank();
Cell number_or_blank(double value);

/// A captioned table with typed columns, rendered in several formats.
class Table {
 public:
  explicit Table(std::vector<Column> columns, std::string caption = {});

  /// Appends a row. Throws std::logic_error unless there is one cell a column and every number is finite:
  /// a NaN or an infinity never reaches the user.
  Table& row(std::vector<Cell> cells);
  /// Appends a line shown under the table (not in CSV).
  Table& note(std::string text);

  const std::string& caption() const { return caption_; }
  const std::vector<Column>& columns() const { return columns_; }
  const std::vector<std::vector<Cell>>& rows() const { return rows_; }
  const std::vector<std::string>& notes() const { return notes_; }

  bool right_aligned(std::size_t column) const;  ///< as the renderings align it

  /// Aligned columns, units in a line of their own under the names; where that is wider than a terminal, names and
  /// then texts go over several lines, as caption and notes do.
  std::string text() const;
  std::string csv() const;       ///< RFC 4180 with "\n" ends, header "name [unit]", numbers by shortest round trip
  std::string markdown() const;  ///< a pipe table
  std::string latex() const;     ///< a table environment with a tabular in the manner of booktabs
  /// One of the four; throws std::logic_error for the formats that are documents, not tables.
  std::string render(Format format) const;

 private:
  std::vector<Column> columns_;
  std::string caption_;
  std::vector<std::vector<Cell>> rows_;
  std::vector<std::string> notes_;
};

/// A cell as the renderings for people show it.
std::string shown(const Cell& cell, const Notation& notation);

/// Number of character cells that UTF-8 text takes on a terminal (one a code point; combining marks are not used).
std::size_t display_width(std::string_view utf8);

/// What the text of tables and what is said beside them keep to.
inline constexpr std::size_t terminal_width = 120;

/// The text broken at spaces into lines of at most `width` character cells, each after the first indented by `indent`.
/// A word that is longer stays whole.
std::vector<std::string> wrapped(std::string_view text, std::size_t width = terminal_width, std::size_t indent = 0);

/// Several tables one after the other, separated by a blank line; in CSV each after the first is preceded by
/// "# <caption>".
std::string render_all(const std::vector<Table>& tables, Format format);

}  // namespace ricochet::console
