#pragma once

#include <array>
#include <csignal>
#include <cstddef>

namespace ricochet::console {

/// Of SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1, SIGUSR2 and SIGALRM: a terminal, a scheduler or a limit asks to end.
inline constexpr std::size_t stopping_signals = 7;

/// While it lives, the first of these signals is only noted, for work that can be stopped at a good place and
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
  std::array<struct sigaction, stopping_signals> before_{};
};

/// Holds every signal that ends a program back until the end of the scope: for files that are put in their places
/// together.
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
