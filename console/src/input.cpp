#include "durable.hpp"

#include <console/exit.hpp>
#include <console/input.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

namespace ricochet::console {

std::string read_input(const std::string& path) {
  const auto unreadable = [&] {
    return BadInput(fmt::format("{}: cannot be read: {}", path, std::generic_category().message(errno)));
  };
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw unreadable();
  const Descriptor closed_at_the_end(file);
  const auto require_small = [&](std::size_t size) {
    if (size > largest_input) throw BadInput(fmt::format("{}: too large: must be at most 1 GiB", path));
  };
  struct stat status = {};
  if (::fstat(file, &status) == 0) require_small(static_cast<std::size_t>(status.st_size));  // before it takes memory
  std::string text;
  constexpr std::size_t least = 1 << 16;
  for (std::size_t got = 0;;) {
    if (got == text.size()) text.resize(std::max(least, 2 * got));
    const auto n = ::read(file, text.data() + got, text.size() - got);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw unreadable();
    got += static_cast<std::size_t>(n);
    require_small(got);
    if (n == 0) return text.resize(got), text;
  }
}

}  // namespace ricochet::console
