#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::console {

class ScratchFolder;
class Passing;

/// A file that appears whole or not at all: written to a temporary file in the same folder, made durable (fsync) and
/// renamed by commit(). Without commit(), on an exception, and on SIGINT, SIGTERM or SIGHUP nothing is left behind
/// and a file that was there before stays as it was. Devices and pipes (-o /dev/null) are written straight through;
/// a symbolic link keeps pointing where it did. Not to be shared between threads.
class AtomicFile {
 public:
  /// Throws BadInput with the path and the reason when the file cannot be created, CannotWrite when there is no room.
  explicit AtomicFile(std::string path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Throws CannotWrite with the path and the reason (disk full, …).
  void write(std::string_view bytes);
  void commit();

 private:
  void open_temporary(bool exists, unsigned mode);

  std::string path_;       // as the user gave it, for messages
  std::string target_;     // links resolved
  std::string temporary_;  // empty: written straight through
  std::unique_ptr<Passing> passing_;
  int file_ = -1;
};

/// Files of one folder that appear together or not at all: written into a folder inside it that passes (where one is a
/// link, beside its end), made durable, and put in their places by commit(), while signals wait; where one cannot be,
/// all others are taken back. Otherwise as AtomicFile.
class OutputFolder {
 public:
  /// Makes the folder if it is missing; throws BadInput with the reason when it cannot.
  explicit OutputFolder(std::string path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// A name added twice gets the later bytes. Throws CannotWrite; BadInput where the name is a folder's or protected.
  void add(const std::string& name, std::string_view bytes);
  void commit();

 private:
  struct File {
    std::string shown, target, staged, kept;  // `kept`: what the target was
    std::unique_ptr<Passing> passing;
    int put() const noexcept;
    void take_back() const noexcept;
  };
  File stage(const std::string& name, const std::string& shown, const std::string& target);

  std::string path_;
  std::vector<std::string> made_;  // by us, the innermost first: gone again if nothing comes into them
  std::unique_ptr<ScratchFolder> staging_;
  std::vector<File> files_;
};

/// A file that a command line names, and the flag that does.
struct NamedFile {
  std::string flag, path;
};

/// Throws BadInput where an output is one of the inputs or another output, by whatever path or link; no path, "-" and
/// what is no regular file are nobody's.
void require_apart(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs);

/// Where a program's answer goes: the file, whole or not at all, or stdout (no path, or "-") as it comes.
class Output {
 public:
  explicit Output(const std::string& path);
  void write(std::string_view bytes);
  void commit();

 private:
  std::unique_ptr<AtomicFile> file_;
};

/// AtomicFile, write, commit.
void write_atomically(const std::string& path, std::string_view bytes);

/// Writes all bytes to stdout; throws CannotWrite when it is closed or full.
void write_stdout(std::string_view bytes);

/// Writes all bytes to a descriptor; throws CannotWrite with the name and the reason.
void write_all(int file, std::string_view bytes, std::string_view name);

}  // namespace ricochet::console
