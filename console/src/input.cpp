#include "durable.hpp"

#include <console/exit.hpp>
#include <console/input.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <string_view>
#include <system_error>

namespace ricochet::console {

namespace {

/// Bytes of the character that begins here, 0 where none does: no surrogates, nothing longer than it need be.
std::size_t character_at(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first < 0xc2 ? 0 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : first < 0xf5 ? 4 : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool longer = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
  const bool none = (first == 0xed && byte(1) >= 0xa0) || (first == 0xf4 && byte(1) >= 0x90);
  return longer || none ? 0 : length;
}

}  // namespace

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

std::string read_text(const std::string& path) {
  std::string text = read_input(path);
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = character_at(std::string_view(text).substr(at));
    if (length == 0)
      throw BadInput(fmt::format("{}:{}: byte 0x{:02x} is not UTF-8: must be a text in UTF-8", path,
                                 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'),
                                 static_cast<unsigned char>(text[at])));
    at += length;
  }
  return text;
}

}  // namespace ricochet::console
