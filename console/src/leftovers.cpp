#include "leftovers.hpp"

#include "cleanup.hpp"
#include "durable.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <filesystem>
#include <optional>

namespace ricochet::console {

namespace {

namespace fs = std::filesystem;

std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && value > 0 ? std::optional(value) : std::nullopt;
}

/// Whose temporary file that is.
std::optional<pid_t> owner_of_file(std::string_view name) {
  constexpr std::string_view ending = ".part";
  if (!name.starts_with('.') || !name.ends_with(ending)) return std::nullopt;
  name.remove_suffix(ending.size());
  const auto attempt = name.rfind('.');
  if (attempt == std::string_view::npos || attempt == 0) return std::nullopt;
  const auto pid = name.rfind('.', attempt - 1);
  if (pid == std::string_view::npos || pid == 0) return std::nullopt;
  return number(name.substr(pid + 1, attempt - pid - 1));
}

std::optional<pid_t> owner_of_folder(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix)) return std::nullopt;
  name.remove_prefix(prefix.size());
  const auto dash = name.find('-');
  return dash == std::string_view::npos ? std::nullopt : number(name.substr(0, dash));
}

/// Not of a process of this machine, and not locked by one of another that shares the folder.
bool is_nobodys(pid_t owner, const std::string& path) {
  if (::kill(owner, 0) == 0 || errno != ESRCH) return false;
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
  if (file < 0) return false;
  const Descriptor closed_at_the_end(file);
  return ::flock(file, LOCK_EX | LOCK_NB) == 0;
}

}  // namespace

std::string temporary_name(std::string_view name, int attempt) {
  // A name is at most 255 bytes long; the temporary one keeps as much of the target's as fits.
  return fmt::format(".{}.{}.{}.part", name.substr(0, 200), ::getpid(), attempt);
}

std::string scratch_name(std::string_view prefix) { return fmt::format("{}{}-XXXXXX", prefix, ::getpid()); }

void hold(int descriptor) noexcept { ::flock(descriptor, LOCK_EX | LOCK_NB); }

void remove_leftovers(const std::string& folder, std::string_view scratch_prefix) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string(), path = at->path().string();
    if (const auto owner = owner_of_file(name); owner && is_nobodys(*owner, path)) ::unlink(path.c_str());
    if (const auto owner = owner_of_folder(name, scratch_prefix); owner && is_nobodys(*owner, path))
      remove_folder(path.c_str());
  }
}

}  // namespace ricochet::console
