#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace ricochet::console {

/// The exit codes that all programs promise.
enum class Exit : int {
  done = 0,
  gate_failed = 1,  ///< a verification gate failed, or a row of many
  bad_input = 2,    ///< the user gave something unusable; one line on stderr says what is accepted
  unreachable = 3,  ///< the target lies outside what the law can reach
  failed = 4,       ///< the computation, or writing its result, failed
};

/// Unusable input. `BadInput("--en", "1.5", "in (0, 1]")` reads "--en = 1.5: must be in (0, 1]".
class BadInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
  BadInput(std::string_view flag, std::string_view value, std::string_view accepted);
};

/// A target that a law cannot reach; the message names the reachable range.
class Unreachable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A computation that failed.
class Failed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A result that could not be written: "out.csv: cannot write: No space left on device". `error` is the system's.
class CannotWrite : public Failed {
 public:
  CannotWrite(std::string_view path, int error);
};

/// The exit code that an exception stands for: BadInput and std::invalid_argument (the library's answer to misuse)
/// are bad input, Unreachable is unreachable, everything else failed.
Exit exit_code(const std::exception& error);

/// Prints "<program>: <message>" as a single line on stderr.
void complain(std::string_view program, std::string_view message);

}  // namespace ricochet::console
