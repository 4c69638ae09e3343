#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ricochet::console {

struct Command {
  std::vector<std::string> arguments;         ///< the program first, which is looked for on the PATH
  std::string folder = {};                    ///< it runs in; empty: this process's
  std::string_view input = {};                ///< its stdin
  std::vector<std::string> environment = {};  ///< "NAME=value", see `run`
};

struct Ran {
  bool found;  ///< false: there is no such program
  int status;  ///< as waitpid() tells it
  std::string out, err;
};

/// Runs a program to its end, in an environment of ours: PATH, LD_LIBRARY_PATH, TMPDIR and Open MPI's variables are
/// this process's, the locale is C.UTF-8 and there is no home, so that no user's settings change what it does. It does
/// not outlive a signal that ends this process. Throws Failed when it cannot be started.
Ran run(const Command& command);

}  // namespace ricochet::console
