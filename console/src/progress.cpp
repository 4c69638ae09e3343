#include <console/number.hpp>
#include <console/progress.hpp>

#include <fmt/format.h>

#include <unistd.h>

#include <algorithm>
#include <utility>

namespace ricochet::console {

namespace {

constexpr std::chrono::seconds first_shown{1};
constexpr std::chrono::milliseconds renewed_every{200};

void to_stderr(const std::string& text) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, text.data(), text.size());
}

}  // namespace

Progress::Progress(std::string what, std::uint64_t total, std::chrono::milliseconds line_every)
    : what_(std::move(what)),
      total_(total),
      terminal_(::isatty(STDERR_FILENO) == 1),
      between_(terminal_ ? renewed_every : line_every),
      start_(Clock::now()),
      next_(std::chrono::duration_cast<Clock::duration>(terminal_ ? first_shown : line_every).count()) {}

Progress::~Progress() {
  if (shown_ && terminal_) to_stderr("\r\033[K");
}

void Progress::advance(std::uint64_t units) {
  const std::uint64_t done = done_.fetch_add(units) + units;
  const auto elapsed = Clock::now() - start_;
  auto due = next_.load();
  if (elapsed.count() < due) return;
  // Of several threads that find the line due, the one that moves the mark shows it.
  const auto following = (elapsed + std::chrono::duration_cast<Clock::duration>(between_)).count();
  if (next_.compare_exchange_strong(due, following)) show(done, elapsed);
}

void Progress::show(std::uint64_t done, Clock::duration elapsed) {
  shown_ = true;
  to_stderr(terminal_ ? "\r\033[K" + text(done, elapsed) : text(done, elapsed) + "\n");
}

std::string Progress::text(std::uint64_t done, Clock::duration elapsed) const {
  if (total_ == 0 || done == 0) return fmt::format("{}: {}", what_, done);
  const double share = std::min(1.0, static_cast<double>(done) / static_cast<double>(total_));
  const double seconds = std::chrono::duration<double>(elapsed).count();
  return fmt::format("{}: {} %, {} s left", what_, fixed(100 * share, 0), fixed(seconds * (1 - share) / share, 0));
}

}  // namespace ricochet::console
