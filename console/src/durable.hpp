#pragma once

#include <console/exit.hpp>

#include <fmt/format.h>

#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

namespace ricochet::console {

/// Closes a file at the end of the scope.
class Descriptor {
 public:
  explicit Descriptor(int file) : file_(file) {}
  ~Descriptor() { ::close(file_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

 private:
  int file_;
};

/// A disk without room, or a system without free descriptors, is no fault of the user's path.
[[noreturn]] inline void throw_cannot_create(const std::string& path, int error) {
  if (error == ENOSPC || error == EDQUOT || error == EIO || error == EMFILE || error == ENFILE || error == ENOMEM)
    throw CannotWrite(path, error);
  throw BadInput(fmt::format("{}: cannot write: {}", path, std::generic_category().message(error)));
}

}  // namespace ricochet::console
