#pragma once

#include <string>
#include <string_view>

namespace ricochet::console {

/// A file that appears whole or not at all: written to a temporary file in the same folder, made durable (fsync) and
/// renamed by commit(). Without commit(), on an exception, and on SIGINT, SIGTERM or SIGHUP nothing is left behind
/// and a file that was there before stays as it was. Devices and pipes (-o /dev/null) are written straight through;
/// a symbolic link keeps pointing where it did. Not to be shared between threads.
class AtomicFile {
 public:
  /// Throws BadInput with the path and the reason when the file cannot be created.
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Throws Failed with the path and the reason (disk full, …).
  void write(std::string_view bytes);
  void commit();

 private:
  void discard() noexcept;

  std::string path_;       // as the user gave it, for messages
  std::string target_;     // links resolved
  std::string temporary_;  // empty: written straight through
  int slot_ = -1;          // where the signal handler finds the temporary file
  int file_ = -1;
};

/// AtomicFile, write, commit.
void write_atomically(const std::string& path, std::string_view bytes);

/// Writes all bytes to stdout; throws Failed when it is closed or full.
void write_stdout(std::string_view bytes);

/// To the file, atomically, or to stdout where `path` is empty.
void emit(const std::string& path, std::string_view bytes);

}  // namespace ricochet::console
