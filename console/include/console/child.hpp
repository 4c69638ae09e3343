#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ricochet::console {

struct Command {
  std::vector<std::string> arguments;         ///< the program first, which is looked for on the PATH
  std::string folder = {};                    ///< it runs in; empty: this process's
  std::string_view input = {};                ///< its stdin
  std::vector<std::string> environment = {};  ///< "NAME=value", beside this process's
};

struct Ran {
  bool found;  ///< false: there is no such program
  int status;  ///< as waitpid() tells it
  std::string out, err;
};

/// Runs a program to its end. It speaks English and decimal points whatever the locale is (C.UTF-8), and does not
/// outlive this process's SIGINT, SIGTERM or SIGHUP. Throws Failed when it cannot be started.
Ran run(const Command& command);

}  // namespace ricochet::console
