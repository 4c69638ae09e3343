#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>

namespace ricochet::console {

/// "what: 42 %, 7 s left" on stderr while work lasts. On a terminal one line, after a second, renewed at most five
/// times a second, which the destructor wipes; elsewhere a line of its own each time that `line_every` has passed.
/// advance() may be called from several threads.
class Progress {
 public:
  /// `total` units of work; 0 when it is not known, then the count is shown.
  Progress(std::string what, std::uint64_t total, std::chrono::milliseconds line_every = std::chrono::seconds{10});
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance(std::uint64_t units = 1);

 private:
  using Clock = std::chrono::steady_clock;
  void show(std::uint64_t done, Clock::duration elapsed);
  std::string text(std::uint64_t done, Clock::duration elapsed) const;

  std::string what_;
  std::uint64_t total_;
  bool terminal_;
  std::chrono::milliseconds between_;
  Clock::time_point start_;
  std::atomic<std::uint64_t> done_{0};
  std::atomic<Clock::rep> next_;  // elapsed ticks at which the line is shown again
  std::atomic<bool> shown_{false};
};

}  // namespace ricochet::console
