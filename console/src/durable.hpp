#pragma once

#include <unistd.h>

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

}  // namespace ricochet::console
