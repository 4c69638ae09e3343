#include "cleanup.hpp"

#include <console/signals.hpp>

#include <dirent.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <climits>
#include <cstring>
#include <utility>

namespace ricochet::console {

namespace {

// Asked to end, by a terminal, a scheduler or a limit: what can be stopped at a good place is.
constexpr std::array<int, stopping_signals> asking_signals{SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1, SIGUSR2, SIGALRM};
// Whatever else ends a program and can be caught.
constexpr std::array dying_signals{SIGQUIT, SIGVTALRM, SIGPROF, SIGPOLL, SIGPWR, SIGSTKFLT, SIGSYS,
                                   SIGABRT, SIGSEGV,   SIGBUS,  SIGFPE,  SIGILL, SIGTRAP};

// A signal handler may only reach what is static.
struct Slot {
  std::atomic<bool> used{false};
  Passing::Kind kind = Passing::Kind::file;
  std::size_t levels = 1;
  std::array<char, PATH_MAX> path{};
};
std::array<Slot, 16> passing;
std::atomic<pid_t> passing_child{0};
volatile std::sig_atomic_t noted_signal = 0;

/// Cuts the path.
void remove_upwards(char* path, std::size_t levels) noexcept {
  for (; levels > 0; --levels) {
    ::rmdir(path);
    char* end = std::strrchr(path, '/');
    if (!end) return;
    while (end > path && end[-1] == '/') --end;
    *end = '\0';
  }
}

void remove_what_passes() noexcept {
  // The child first: it could make files in a folder that is being emptied.
  if (const pid_t child = passing_child.load(); child > 0) {
    ::kill(-child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  const auto each = [](Passing::Kind kind, auto&& remove) {
    for (Slot& slot : passing)
      if (slot.used.load() && slot.path[0] != '\0' && slot.kind == kind) remove(slot);
  };
  each(Passing::Kind::file, [](Slot& slot) { ::unlink(slot.path.data()); });
  each(Passing::Kind::folder, [](Slot& slot) { remove_folder(slot.path.data()); });
  // Last those that the others may have been in.
  each(Passing::Kind::empty_folders, [](Slot& slot) { remove_upwards(slot.path.data(), slot.levels); });
}

sigset_t deadly_set() noexcept {
  sigset_t set;
  ::sigemptyset(&set);
  for (const int signal : asking_signals) ::sigaddset(&set, signal);
  for (const int signal : dying_signals) ::sigaddset(&set, signal);
  return set;
}

extern "C" void clean_up_and_die(int signal) {
  remove_what_passes();
  // The signal is held back while its handler runs: raised again, it ends the program as the handler returns.
  ::signal(signal, SIG_DFL);
  ::raise(signal);
}

extern "C" void note_or_die(int signal) {
  if (noted_signal != 0) return clean_up_and_die(signal);
  noted_signal = signal;
}

void handle(int signal, void (*handler)(int)) noexcept {
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_mask = deadly_set();
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

// Only signals that would kill the program are caught: one that is noted (StopOnSignal) or ignored (nohup) stays as is.
void catch_deadly() noexcept {
  const auto catch_all = [](const auto& signals) {
    for (const int signal : signals) {
      struct sigaction now = {};
      ::sigaction(signal, nullptr, &now);
      if (now.sa_handler == SIG_DFL) handle(signal, clean_up_and_die);
    }
  };
  catch_all(asking_signals);
  catch_all(dying_signals);
}

// Entries as the system hands them out, without opendir(), which allocates.
bool remove_some(int folder) noexcept {
  alignas(dirent64) std::array<char, 4096> entries{};
  bool removed = false;
  ::lseek(folder, 0, SEEK_SET);
  for (long n = 0; (n = ::syscall(SYS_getdents64, folder, entries.data(), entries.size())) > 0;)
    for (long at = 0; at < n;) {
      const auto* entry = reinterpret_cast<const dirent64*>(entries.data() + at);
      if (::unlinkat(folder, entry->d_name, 0) == 0) removed = true;
      at += entry->d_reclen;
    }
  return removed;
}

}  // namespace

void remove_folder(const char* path) noexcept {
  if (const int folder = ::open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC); folder >= 0) {
    while (remove_some(folder)) {
    }
    ::close(folder);
  }
  ::rmdir(path);
}

void remove_empty_folders(std::string path, std::size_t levels) noexcept { remove_upwards(path.data(), levels); }

Passing::Passing(Kind kind, const std::string& path, std::size_t levels) {
  catch_deadly();
  for (std::size_t i = 0; i < passing.size() && path.size() < PATH_MAX; ++i) {
    bool expected = false;
    Slot& slot = passing[i];
    if (!slot.used.compare_exchange_strong(expected, true)) continue;
    slot.kind = kind;
    slot.levels = levels;
    // The first letter comes last: a signal before it finds an empty name.
    std::memcpy(slot.path.data() + 1, path.data() + 1, path.size());
    std::atomic_signal_fence(std::memory_order_seq_cst);
    slot.path[0] = path[0];
    slot_ = static_cast<int>(i);
    return;
  }
  // More than 16 at once: only not tidied up after a signal.
}

Passing::Passing(Passing&& other) noexcept : slot_(std::exchange(other.slot_, -1)) {}

Passing& Passing::operator=(Passing&& other) noexcept {
  forget();
  slot_ = std::exchange(other.slot_, -1);
  return *this;
}

void Passing::forget() noexcept {
  if (slot_ < 0) return;
  Slot& slot = passing[static_cast<std::size_t>(std::exchange(slot_, -1))];
  slot.path[0] = '\0';
  slot.used.store(false);
}

void set_passing_child(pid_t group) noexcept {
  catch_deadly();
  passing_child.store(group);
}

SignalsHeld::SignalsHeld() noexcept {
  const sigset_t deadly = deadly_set();
  ::pthread_sigmask(SIG_BLOCK, &deadly, &before_);
}

SignalsHeld::~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

StopOnSignal::StopOnSignal() {
  noted_signal = 0;
  for (std::size_t i = 0; i < asking_signals.size(); ++i) {
    ::sigaction(asking_signals[i], nullptr, &before_[i]);
    if (before_[i].sa_handler != SIG_IGN) handle(asking_signals[i], note_or_die);
  }
}

StopOnSignal::~StopOnSignal() {
  for (std::size_t i = 0; i < asking_signals.size(); ++i) ::sigaction(asking_signals[i], &before_[i], nullptr);
}

int StopOnSignal::noted() noexcept { return noted_signal; }

void end_by(int signal) noexcept {
  ::signal(signal, SIG_DFL);
  sigset_t one;
  ::sigemptyset(&one);
  ::sigaddset(&one, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  ::raise(signal);
  ::_exit(128 + signal);  // a debugger swallowed it
}

}  // namespace ricochet::console
