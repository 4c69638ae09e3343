#include "cleanup.hpp"
#include "durable.hpp"
#include "leftovers.hpp"

#include <console/exit.hpp>
#include <console/output.hpp>
#include <console/scratch.hpp>

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace ricochet::console {

namespace {

/// TMPDIR where that is a folder, else the system's own.
std::string temporary_files() {
  std::error_code missing;
  const auto named = std::filesystem::temp_directory_path(missing);
  return missing ? "/tmp" : named.string();
}

}  // namespace

ScratchFolder::ScratchFolder() {
  if (const int error = make(temporary_files(), system_scratch)) throw CannotWrite(path_, error);
}

ScratchFolder::ScratchFolder(const std::string& inside) {
  if (const int error = make(inside, hidden_scratch)) throw_cannot_create(inside, error);
}

/// Returns the system's error, 0 for none.
int ScratchFolder::make(const std::string& inside, std::string_view prefix) {
  remove_leftovers(inside, prefix);
  path_ = inside + "/" + scratch_name(prefix);
  const SignalsHeld held;
  if (!::mkdtemp(path_.data())) return errno;
  held_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (held_ >= 0) hold(held_);
  passing_ = std::make_unique<Passing>(Passing::Kind::folder, std::filesystem::absolute(path_).string());
  return 0;
}

ScratchFolder::~ScratchFolder() {
  remove_folder(path_.c_str());
  if (held_ >= 0) ::close(held_);
}

void ScratchFolder::write(const std::string& name, std::string_view bytes) const {
  const std::string path = path_ + "/" + name;
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw CannotWrite(path, errno);
  const Descriptor closed_at_the_end(file);
  write_all(file, bytes, path);
}

std::string ScratchFolder::read(const std::string& name) const {
  std::ifstream in(path_ + "/" + name, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace ricochet::console
