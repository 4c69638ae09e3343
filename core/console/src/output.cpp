#include <console/exit.hpp>
#include <console/output.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <memory>
#include <system_error>
#include <utility>

namespace ricochet::console {

namespace {

// A signal handler may only reach what is static: the names of the temporary files that are open now.
struct Slot {
  std::atomic<bool> used{false};
  std::array<char, PATH_MAX> path{};
};
std::array<Slot, 16> open_files;

constexpr std::array deadly_signals{SIGINT, SIGTERM, SIGHUP};

extern "C" void remove_open_files(int signal) {
  for (const Slot& slot : open_files)
    if (slot.used.load()) ::unlink(slot.path.data());
  // The handler was installed with SA_RESETHAND: raised again, the signal ends the program as if never caught.
  ::raise(signal);
}

// Only signals that would kill the program are caught: one that it handles (simulate) or ignores (nohup) stays as is.
void install_handler() {
  for (const int signal : deadly_signals) {
    struct sigaction now = {};
    ::sigaction(signal, nullptr, &now);
    if (now.sa_handler != SIG_DFL) continue;
    struct sigaction ours = {};
    ours.sa_handler = remove_open_files;
    ours.sa_flags = static_cast<int>(SA_RESETHAND);
    ::sigaction(signal, &ours, nullptr);
  }
}

int register_file(const std::string& path) {
  install_handler();
  for (std::size_t i = 0; i < open_files.size(); ++i) {
    bool expected = false;
    Slot& slot = open_files[i];
    if (path.size() + 1 > slot.path.size()) return -1;
    // The path is complete before `used` is set for good; a signal between the two finds an empty name.
    if (!slot.used.compare_exchange_strong(expected, true)) continue;
    std::memcpy(slot.path.data() + 1, path.data() + 1, path.size());
    std::atomic_signal_fence(std::memory_order_seq_cst);
    slot.path[0] = path[0];
    return static_cast<int>(i);
  }
  return -1;  // more than 16 at once: still atomic, only not tidied up after a signal
}

void unregister_file(int slot) {
  if (slot < 0) return;
  auto& entry = open_files[static_cast<std::size_t>(slot)];
  entry.path[0] = '\0';
  entry.used.store(false);
}

std::string reason(int error) { return std::generic_category().message(error); }

void write_all(int file, std::string_view bytes, const std::string& name) {
  while (!bytes.empty()) {
    const auto written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw Failed(name + ": cannot write: " + reason(errno));
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::string resolved(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? std::string(real.get()) : path;
}

std::string folder_of(const std::string& path) {
  const auto slash = path.find_last_of('/');
  return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), target_(resolved(path_)) {
  struct stat status = {};
  const bool exists = ::stat(target_.c_str(), &status) == 0;
  if (path_.empty() || (exists && S_ISDIR(status.st_mode)))
    throw BadInput("-o", path_.empty() ? "''" : path_, "a file, not a folder");
  if (exists && !S_ISREG(status.st_mode)) {
    file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) throw BadInput(path_ + ": cannot write: " + reason(errno));
    return;
  }
  // A file that may not be written stays protected even where its folder would allow to replace it.
  if (exists && ::access(target_.c_str(), W_OK) != 0) throw BadInput(path_ + ": cannot write: " + reason(errno));
  const auto slash = target_.find_last_of('/');
  const std::string name = slash == std::string::npos ? target_ : target_.substr(slash + 1);
  for (int attempt = 0; file_ < 0; ++attempt) {
    const std::string suffix = "." + std::to_string(::getpid()) + "." + std::to_string(attempt) + ".part";
    // A name is at most 255 bytes long; the temporary one keeps as much of the target's as fits.
    temporary_ = (slash == std::string::npos ? "./" : folder_of(target_)) + "." + name.substr(0, 200) + suffix;
    slot_ = register_file(temporary_);  // before the file exists, so that no signal can fall in between
    file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                   exists ? status.st_mode & 07777 : 0666);
    const int error = errno;
    if (file_ >= 0) break;
    unregister_file(std::exchange(slot_, -1));
    if (error != EEXIST || attempt > 1000) throw BadInput(path_ + ": cannot write: " + reason(error));
  }
}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::discard() noexcept {
  if (file_ >= 0) ::close(std::exchange(file_, -1));
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
  unregister_file(std::exchange(slot_, -1));
}

void AtomicFile::write(std::string_view bytes) { write_all(file_, bytes, path_); }

void AtomicFile::commit() {
  const bool device = temporary_.empty();
  if (!device && ::fsync(file_) != 0) throw Failed(path_ + ": cannot write: " + reason(errno));
  if (::close(std::exchange(file_, -1)) != 0) throw Failed(path_ + ": cannot write: " + reason(errno));
  if (device) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) throw Failed(path_ + ": cannot write: " + reason(errno));
  temporary_.clear();
  unregister_file(std::exchange(slot_, -1));
  // The rename itself survives a crash once the folder is on disk; not every file system offers that.
  if (const int folder = ::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); folder >= 0) {
    ::fsync(folder);
    ::close(folder);
  }
}

void write_atomically(const std::string& path, std::string_view bytes) {
  AtomicFile file(path);
  file.write(bytes);
  file.commit();
}

void write_stdout(std::string_view bytes) {
  std::cout.flush();
  std::fflush(stdout);
  write_all(STDOUT_FILENO, bytes, "standard output");
}

void emit(const std::string& path, std::string_view bytes) {
  if (path.empty())
    write_stdout(bytes);
  else
    write_atomically(path, bytes);
}

}  // namespace ricochet::console
