#include <console/csv.hpp>
#include <console/exit.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

namespace ricochet::console {

namespace {

std::string unreadable(const std::string& path, int error) {
  return fmt::format("{}: cannot be read: {}", path, std::generic_category().message(error));
}

}  // namespace

LineBlocks::LineBlocks(std::string path, std::size_t block_size)
    : path_(std::move(path)),
      block_size_(block_size),
      file_(path_ == "-" ? ::dup(STDIN_FILENO) : ::open(path_.c_str(), O_RDONLY | O_CLOEXEC)) {
  if (file_ < 0) throw BadInput(unreadable(path_, errno));
  struct stat about {};
  if (::fstat(file_, &about) == 0 && S_ISDIR(about.st_mode)) {
    ::close(file_);
    throw BadInput(fmt::format("{}: cannot be read: is a directory", path_));
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
    if (n < 0) throw Failed(unreadable(path_, errno));
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
      throw BadInput(fmt::format("{}:{}: line of more than {} bytes: must be a row of a CSV file", path_, next_line_,
                                 std::size_t{longest_line}));
  }
  next_line_ += static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
  return !block.text.empty();
}

}  // namespace ricochet::console
