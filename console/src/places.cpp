#include "places.hpp"

#include "cleanup.hpp"
#include "durable.hpp"

#include <console/exit.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <set>
#include <system_error>

namespace ricochet::console {

namespace {

/// A rename survives a crash once the folder is on disk; not every file system offers that.
void sync_folder(const std::string& path) {
  if (const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); folder >= 0) {
    const Descriptor closed_at_the_end(folder);
    ::fsync(folder);
  }
}

void require_places_of_their_own(const std::vector<Waiting*>& files) {
  std::set<std::filesystem::path> taken;
  for (const Waiting* const file : files) {
    std::error_code error;
    const auto whole = std::filesystem::weakly_canonical(file->target, error);
    if (!taken.insert(error ? std::filesystem::path(file->target) : whole).second)
      throw BadInput(fmt::format("{}: would be written twice: each output must have a name of its own", file->shown));
  }
}

/// What the target is stays beside it, by a second name or, where a file system has none, by another; the system's
/// error, 0 for none.
int keep(const Waiting& file) noexcept {
  struct stat at = {};
  if (::lstat(file.target.c_str(), &at) == 0 && S_ISDIR(at.st_mode)) return EISDIR;
  ::unlink(file.kept.c_str());
  if (::link(file.target.c_str(), file.kept.c_str()) == 0 || errno == ENOENT) return 0;
  return ::rename(file.target.c_str(), file.kept.c_str()) == 0 ? 0 : errno;
}

int put(const Waiting& file) noexcept { return ::rename(file.staged.c_str(), file.target.c_str()) == 0 ? 0 : errno; }

void take_back(const Waiting& file) noexcept {
  if (::rename(file.kept.c_str(), file.target.c_str()) != 0) ::unlink(file.target.c_str());  // there was nothing
}

}  // namespace

void throw_cannot_create(const std::string& path, int error) {
  if (error == ENOSPC || error == EDQUOT || error == EIO || error == EMFILE || error == ENFILE || error == ENOMEM)
    throw CannotWrite(path, error);
  throw BadInput(fmt::format("{}: cannot write: {}", path, std::generic_category().message(error)));
}

std::string folder_of(const std::string& path) {
  const auto slash = path.find_last_of('/');
  return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

void put_in_place(const std::vector<Waiting*>& files) {
  require_places_of_their_own(files);
  const SignalsHeld held;
  const bool alone = files.size() == 1;
  for (std::size_t done = 0; done < files.size(); ++done) {
    int error = alone ? 0 : keep(*files[done]);
    if (error == 0) error = put(*files[done]);
    if (error == 0) continue;
    ::rename(files[done]->kept.c_str(), files[done]->target.c_str());
    ::unlink(files[done]->kept.c_str());  // which is still there where it is a second name
    for (std::size_t k = done; k-- > 0;) take_back(*files[k]);
    throw CannotWrite(files[done]->shown, error);
  }
  for (Waiting* const file : files) {
    if (!alone) ::unlink(file->kept.c_str());
    file->staged.clear();
    file->passing.reset();
    sync_folder(folder_of(file->target));
  }
}

}  // namespace ricochet::console
