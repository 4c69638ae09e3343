#pragma once

#include <console/signals.hpp>

#include <sys/types.h>

#include <cstddef>
#include <string>

namespace ricochet::console {

/// Removes the folder and the files in it; folders inside stay, and then so does it. Fit for signal handlers.
void remove_folder(const char* path) noexcept;

/// Removes the folder and those around it, `levels` in all, as far as they are empty.
void remove_empty_folders(std::string path, std::size_t levels) noexcept;

/// A temporary file or folder that every signal that can be caught removes before it ends the program. To be made
/// together with the file while SignalsHeld, so that no signal falls in between.
class Passing {
 public:
  enum class Kind {
    file,
    folder,         ///< with the files in it
    empty_folders,  ///< `levels` of them, each in the next, where nothing has come into them
  };
  Passing() = default;
  Passing(Kind kind, const std::string& path, std::size_t levels = 1);
  ~Passing() { forget(); }
  Passing(Passing&& other) noexcept;
  Passing& operator=(Passing&& other) noexcept;

  /// It is gone, or has become what stays.
  void forget() noexcept;

 private:
  int slot_ = -1;
};

/// The process group that a deadly signal kills as well; 0: none.
void set_passing_child(pid_t group) noexcept;

}  // namespace ricochet::console
