#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::console {

/// A line that carries no row: empty, of blanks and separators alone, a comment that starts with '#', or "sep=;", by
/// which spreadsheets tell each other the separator.
bool is_csv_remark(std::string_view line);

/// The line up to its "\n" or "\r\n", which is taken from `text` together with it.
std::string_view take_line(std::string_view& text);

/// A piece of somebody's file, fit for a message of one line.
std::string excerpt(std::string_view text);

/// A large text file in blocks of whole lines: memory does not grow with the file.
class LineBlocks {
 public:
  struct Block {
    std::string text;
    std::size_t first_line = 1;  ///< number of its first line in the file
  };
  static constexpr std::size_t longest_line = 1 << 20;  ///< bytes

  /// "-" is standard input. Throws BadInput naming path and reason when the file cannot be opened, or is a directory.
  explicit LineBlocks(std::string path, std::size_t block_size = 1 << 18);
  ~LineBlocks();
  LineBlocks(const LineBlocks&) = delete;
  LineBlocks& operator=(const LineBlocks&) = delete;

  /// False at the end of the file. Throws BadInput naming file and line when a line is longer than longest_line, or
  /// Failed when the file cannot be read.
  bool next(Block& block);
  /// Bytes of the file, 0 where that is not known (a pipe).
  std::size_t size() const { return size_; }

 private:
  std::size_t fill(std::string& text, std::size_t wanted);

  std::string path_;
  std::size_t block_size_, size_ = 0, next_line_ = 1;
  int file_;
  std::string rest_;  // the begun last line of the block before
};

/// The head of a CSV file: its first line that is no remark.
struct CsvHead {
  std::string text;
  std::size_t line = 1;  ///< its number in the file
};

/// Takes the lines up to and including the head from the first block that has one, and a byte-order mark before it;
/// nothing where the file has none.
std::optional<CsvHead> take_csv_head(LineBlocks& source, LineBlocks::Block& block);

/// A column that a program takes from CSV files.
struct CsvColumn {
  std::string_view name;
  std::string_view unit = {};  ///< SI, in which numbers are handed on; empty: a text, or a number without unit
  bool needed = false;
  std::string_view aliases = {};  ///< other names that people give it, between commas: "v,speed"
};

/// What becomes of columns that a program does not know.
enum class Unknown {
  refused,
  ignored  ///< and told of by `CsvColumns::ignored`
};

/// The columns of one file as its head names them, and its rows read by them; shared by threads.
///
/// What a file may look like is decided here alone. Fields stand between commas, or between semicolons or tabs where
/// the head does; there a number may have a decimal comma, if the file's others have: the first rows tell which sign it
/// is, and a number with the other one, or with both, is refused, since it may mean thousands. Blanks around a field
/// and a pair of double quotes are taken off; a quoted field may hold separators, but neither quotes nor line ends. A
/// heading is a name as `CsvColumn` has it, in letters of any case and with blanks or dashes for its underscores, with
/// a unit after it in brackets or parentheses ("v [mm/s]", "Velocity (m/s)"): another decimal multiple of the column's
/// own is converted exactly,
/// without one the numbers are in the column's own.
class CsvColumns {
 public:
  static constexpr std::size_t most = 64;  ///< columns of a file

  /// `accepted` must outlive it. Throws BadInput "file:line: column = x: must be one of …" where a column is none of
  /// these, comes twice, has no known unit or is missing. Several of one name have different units, of which a file
  /// has one. `rows` are the first of the file.
  CsvColumns(const std::string& file, const CsvHead& head, std::span<const CsvColumn> accepted,
             Unknown unknown = Unknown::refused, std::string_view rows = {});

  /// The headings of columns that are not read, as they stand.
  const std::vector<std::string>& ignored() const { return ignored_; }
  bool has(std::size_t column) const { return exponents_[column].has_value(); }
  /// Has the head a unit for it?
  bool states_unit(std::size_t column) const { return stated_[column]; }

  /// The fields of one row by the order of `accepted`, which is the size of `fields`; one whose column the file does
  /// not have is empty. Throws BadInput "fields = 3: must be 2, one a column", without a place.
  void split(std::string_view line, std::span<std::string_view> fields) const;

  /// The finite number that a field of that column spells, in the column's unit, rounded once.
  std::optional<double> number(std::size_t column, std::string_view field) const;
  /// What of its signs is in doubt, to be said behind what is accepted: ", with a decimal comma as …"; else nothing.
  std::string_view doubt(std::string_view field) const;

 private:
  char sign_in(std::string_view rows) const;
  std::string units_of(std::string_view name) const;
  std::optional<std::size_t> fields_of(std::string_view line, std::span<std::string_view> fields) const;
  std::optional<std::size_t> take(std::string_view heading, Unknown unknown);
  [[noreturn]] void refuse(std::string_view heading, std::size_t count) const;

  std::span<const CsvColumn> accepted_;
  char separator_, decimal_sign_ = 0;
  std::vector<std::optional<std::size_t>> order_;  // the file's columns, without those that are ignored
  std::vector<std::string> ignored_;
  std::vector<std::optional<int>> exponents_;  // of ten, from the file's unit to the column's, where it has the column
  std::vector<bool> stated_;                   // of each accepted column: has it a unit in the head?
};

/// A CSV file row by row. What is wrong with it is BadInput that begins "file:line: ".
class CsvReader {
 public:
  /// Reads the head; what `accepted` refers to must outlive the reader.
  CsvReader(std::string path, std::span<const CsvColumn> accepted, Unknown unknown = Unknown::refused);
  CsvReader(const CsvReader&) = delete;
  CsvReader& operator=(const CsvReader&) = delete;

  bool has(std::size_t column) const { return columns_ && columns_->has(column); }
  /// The headings of columns that are not read.
  std::vector<std::string> ignored() const { return columns_ ? columns_->ignored() : std::vector<std::string>(); }

  bool states_unit(std::size_t column) const { return columns_ && columns_->states_unit(column); }
  /// Has the file a head?
  bool any() const { return columns_.has_value(); }
  /// Number of the line that was read last.
  std::size_t line() const { return line_; }

  /// To the next row; false after the last, and where there is not even a head.
  bool next();

  std::string_view text(std::size_t column) const { return fields_[column]; }
  /// The finite number, in the column's unit; else throws "name = text: must be <accepted>".
  double number(std::size_t column, std::string_view accepted = "a finite number") const;

  [[noreturn]] void reject(std::size_t column, std::string_view accepted) const;
  /// Throws BadInput "file:line: <what>", of the head before the first row, then of the row.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  std::string path_;
  std::span<const CsvColumn> accepted_;
  LineBlocks source_;
  LineBlocks::Block block_;
  std::string_view rest_;  // of the block
  std::size_t line_ = 1;
  std::optional<CsvColumns> columns_;
  std::vector<std::string_view> fields_;
};

}  // namespace ricochet::console
