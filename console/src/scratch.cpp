#include "cleanup.hpp"
#include "durable.hpp"

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

ScratchFolder::ScratchFolder() : path_((std::filesystem::temp_directory_path() / "ricochet-XXXXXX").string()) {
  if (const int error = make()) throw CannotWrite(path_, error);
}

ScratchFolder::ScratchFolder(const std::string& inside) : path_(inside + "/.ricochet-XXXXXX") {
  if (const int error = make()) throw_cannot_create(inside, error);
}

/// Returns the system's error, 0 for none.
int ScratchFolder::make() noexcept {
  const SignalsHeld held;
  if (!::mkdtemp(path_.data())) return errno;
  passing_ = std::make_unique<Passing>(Passing::Kind::folder, std::filesystem::absolute(path_).string());
  return 0;
}

ScratchFolder::~ScratchFolder() { remove_folder(path_.c_str()); }

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
