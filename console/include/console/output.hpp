#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ricochet::console {

class ScratchFolder;
class Passing;

/// Throws what a path that cannot be written to is, by the system's error: BadInput; but a disk without room and a
/// system without free descriptors are no fault of the user's path: CannotWrite.
[[noreturn]] void throw_cannot_create(const std::string& path, int error);

/// A file that waits to take its place.
struct Waiting {
  std::string shown;   ///< as the user named it, for messages
  std::string target;  ///< links resolved
  std::string staged;  ///< where it waits; empty: written straight through
  std::string kept;    ///< where what the target was is, until all others have their places too
  std::unique_ptr<Passing> passing;
};

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
  friend class Together;
  void open_temporary(bool exists, unsigned mode);
  /// Closes the file, which is durable then; null where it is written straight through.
  Waiting* finish();

  Waiting waiting_;
  int file_ = -1;
};

/// A folder that is there, made if need be with those around it. What was made goes again at the end of the scope, and
/// on a signal that ends the program, if nothing has come into it.
class MadeFolder {
 public:
  /// Throws BadInput with the reason when it cannot be made.
  explicit MadeFolder(std::string path);
  ~MadeFolder();
  MadeFolder(const MadeFolder&) = delete;
  MadeFolder& operator=(const MadeFolder&) = delete;

  const std::string& path() const { return path_; }

 private:
  std::string path_;
  std::size_t made_ = 0;  // with those around it
  std::unique_ptr<Passing> passing_;
};

/// Files of one folder that appear together or not at all: written into a folder inside it that passes (where one is a
/// link, beside its end), made durable, and put in their places by commit(), while signals wait; where one cannot be,
/// all others are taken back. Otherwise as AtomicFile.
class OutputFolder {
 public:
  /// Throws BadInput with the reason when the folder, a MadeFolder, cannot be.
  explicit OutputFolder(std::string path);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// A name added twice gets the later bytes. Throws CannotWrite; BadInput where the name is a folder's or protected.
  void add(const std::string& name, std::string_view bytes);
  void commit();

 private:
  friend class Together;
  Waiting stage(const std::string& name, const std::string& shown, const std::string& target);

  MadeFolder folder_;
  std::unique_ptr<ScratchFolder> staging_;
  std::vector<Waiting> files_;
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
  friend class Together;
  std::unique_ptr<AtomicFile> file_;
};

/// All files that one command writes: they take their places together or not at all.
class Together {
 public:
  Together();
  ~Together();
  Together(const Together&) = delete;
  Together& operator=(const Together&) = delete;

  // Each throws as the constructor of what it makes, which lives as long as this does.
  OutputFolder& folder(const std::string& path);
  AtomicFile& file(const std::string& path);
  Output& output(const std::string& path);

  /// Signals wait meanwhile. Throws CannotWrite where one cannot take its place, BadInput where two have the same; all
  /// that was there before is there again then.
  void commit();

 private:
  std::vector<std::unique_ptr<OutputFolder>> folders_;
  std::vector<std::unique_ptr<AtomicFile>> files_;
  std::vector<std::unique_ptr<Output>> outputs_;
};

/// AtomicFile, write, commit.
void write_atomically(const std::string& path, std::string_view bytes);

/// Writes all bytes to stdout; throws CannotWrite when it is closed or full.
void write_stdout(std::string_view bytes);

/// Writes all bytes to a descriptor; throws CannotWrite with the name and the reason.
void write_all(int file, std::string_view bytes, std::string_view name);

}  // namespace ricochet::console
