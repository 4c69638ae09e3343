#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ricochet::console {

/// Splits one line of CSV at its commas into `fields`, blanks around a field and a pair of double quotes taken off; a
/// quoted field may hold commas, but neither quotes nor line ends. Returns how many there are, or nothing where a quote
/// is not closed or there are more than `fields` holds.
std::optional<std::size_t> split_csv(std::string_view line, std::span<std::string_view> fields);

/// A line that carries no row: empty, blanks, or a comment that starts with '#'.
bool is_csv_remark(std::string_view line);

/// The line up to its "\n" or "\r\n", which is taken from `text` together with it.
std::string_view take_line(std::string_view& text);

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

}  // namespace ricochet::console
