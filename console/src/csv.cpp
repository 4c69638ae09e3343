#include <console/csv.hpp>
#include <console/exit.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace ricochet::console {

namespace {

constexpr std::string_view blanks = " \t";

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string reason() { return std::generic_category().message(errno); }

}  // namespace

std::optional<std::size_t> split_csv(std::string_view line, std::span<std::string_view> fields) {
  for (std::size_t count = 0; count < fields.size(); ++count) {
    const auto start = line.find_first_not_of(blanks);
    const bool quoted = start != std::string_view::npos && line[start] == '"';
    const auto close = quoted ? line.find('"', start + 1) : 0;
    if (close == std::string_view::npos) return std::nullopt;
    const auto comma = line.find(',', close);
    const auto raw = trimmed(line.substr(0, comma));
    if (quoted && raw.back() != '"') return std::nullopt;
    fields[count] = quoted ? raw.substr(1, raw.size() - 2) : raw;
    if (comma == std::string_view::npos) return count + 1;
    line.remove_prefix(comma + 1);
  }
  return std::nullopt;
}

bool is_csv_remark(std::string_view line) {
  const auto first = line.find_first_not_of(blanks);
  return first == std::string_view::npos || line[first] == '#';
}

std::string_view take_line(std::string_view& text) {
  const auto end = text.find('\n');
  auto line = text.substr(0, end);
  text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

LineBlocks::LineBlocks(std::string path, std::size_t block_size)
    : path_(std::move(path)),
      block_size_(block_size),
      file_(path_ == "-" ? ::dup(STDIN_FILENO) : ::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (file_ < 0) throw BadInput(path_ + ": cannot be read: " + reason());
  struct stat about {};
  if (::fstat(file_, &about) == 0 && S_ISDIR(about.st_mode)) {
    ::close(file_);
    throw BadInput(path_ + ": cannot be read: is a directory");
  }
  if (S_ISREG(about.st_mode)) size_ = static_cast<std::size_t>(about.st_size);
}

LineBlocks::~LineBlocks() { ::close(file_); }

/// Appends up to `wanted` bytes; fewer only at the end of the file.
std::size_t LineBlocks::fill(std::string& text, std::size_t wanted) {
  const std::size_t before = text.size();
  text.resize(before + wanted);
  std::size_t got = 0;
  while (got < wanted) {
    const auto n = ::read(file_, text.data() + before + got, wanted - got);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw Failed(path_ + ": cannot be read: " + reason());
    if (n == 0) break;
    got += static_cast<std::size_t>(n);
  }
  text.resize(before + got);
  return got;
}

bool LineBlocks::next(Block& block) {
  block.text = std::exchange(rest_, {});
  block.first_line = next_line_;
  while (fill(block.text, block_size_) == block_size_) {
    const auto end = block.text.rfind('\n');
    if (end != std::string::npos) {
      rest_ = block.text.substr(end + 1);
      block.text.resize(end + 1);
      break;
    }
    if (block.text.size() > longest_line)
      throw BadInput(path_ + ":" + std::to_string(next_line_) + ": line of more than " + std::to_string(longest_line) +
                     " bytes: must be a row of a CSV file");
  }
  next_line_ += static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
  return !block.text.empty();
}

}  // namespace ricochet::console
