#pragma once

#include <array>
#include <csignal>

namespace ricochet::console {

/// While it lives, the first SIGINT, SIGTERM or SIGHUP is only noted, for work that can be stopped at a good place and
/// continued later; a second one ends the program at once, as it ever does. Signals that are ignored (nohup) stay so.
class StopOnSignal {
 public:
  StopOnSignal();
  ~StopOnSignal();
  StopOnSignal(const StopOnSignal&) = delete;
  StopOnSignal& operator=(const StopOnSignal&) = delete;

  /// The signal that was noted, or 0.
  static int noted() noexcept;

 private:
  std::array<struct sigaction, 3> before_{};
};

/// Holds SIGINT, SIGTERM and SIGHUP back until the end of the scope: for files that are put in their places together.
class SignalsHeld {
 public:
  SignalsHeld() noexcept;
  ~SignalsHeld();
  SignalsHeld(const SignalsHeld&) = delete;
  SignalsHeld& operator=(const SignalsHeld&) = delete;
  /// What was held back before.
  const sigset_t& before() const { return before_; }

 private:
  sigset_t before_{};
};

/// Ends the program as the signal would, uncaught: shells report 128 + signal, and scripts stop at Ctrl-C.
[[noreturn]] void end_by(int signal) noexcept;

}  // namespace ricochet::console
