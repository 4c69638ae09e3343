#include "cleanup.hpp"
#include "durable.hpp"
#include "leftovers.hpp"

#include <console/output.hpp>
#include <console/scratch.hpp>

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <system_error>
#include <utility>

namespace ricochet::console {

namespace {

std::string resolved(const std::string& path) {
  const std::unique_ptr<char, decltype(&std::free)> real(::realpath(path.c_str(), nullptr), std::free);
  return real ? std::string(real.get()) : path;
}

std::string folder_of(const std::string& path) {
  const auto slash = path.find_last_of('/');
  return slash == std::string::npos ? "./" : path.substr(0, slash + 1);
}

/// What is at the end of a path that a file is to be written to.
struct Target {
  bool exists, regular;
  mode_t mode;
};

/// Throws where a file cannot be put: a folder's name, or a file that may not be written. Such a file stays protected
/// even where its folder would allow to replace it.
Target look_at(const std::string& target, const std::string& shown) {
  struct stat status = {};
  const bool exists = ::stat(target.c_str(), &status) == 0;
  if (!exists && errno == ENAMETOOLONG) throw_cannot_create(shown, errno);  // the temporary one would be shorter
  if (struct stat link = {}; !exists && ::lstat(target.c_str(), &link) == 0 && S_ISLNK(link.st_mode))
    throw BadInput(fmt::format("{}: cannot write: a link that leads nowhere", shown));
  if (exists && S_ISDIR(status.st_mode)) throw_cannot_create(shown, EISDIR);
  const bool regular = exists && S_ISREG(status.st_mode);
  if (regular && ::access(target.c_str(), W_OK) != 0) throw_cannot_create(shown, errno);
  return {exists, regular, static_cast<mode_t>(exists ? status.st_mode & 07777 : 0666)};
}

void sync(int file, const std::string& shown) {
  if (::fsync(file) != 0) throw CannotWrite(shown, errno);
}

/// A rename survives a crash once the folder is on disk; not every file system offers that.
void sync_folder(const std::string& path) {
  if (const int folder = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); folder >= 0) {
    const Descriptor closed_at_the_end(folder);
    ::fsync(folder);
  }
}

}  // namespace

AtomicFile::AtomicFile(std::string path) : path_(std::move(path)), target_(resolved(path_)) {
  if (path_.empty()) throw BadInput("output = '': must be the name of a file");
  const Target target = look_at(target_, path_);
  if (!target.exists || target.regular) {
    open_temporary(target.exists, target.mode);
  } else {
    file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) throw_cannot_create(path_, errno);
  }
}

void AtomicFile::open_temporary(bool exists, unsigned mode) {
  const auto slash = target_.find_last_of('/');
  const std::string name = slash == std::string::npos ? target_ : target_.substr(slash + 1);
  remove_leftovers(folder_of(target_), hidden_scratch);
  const SignalsHeld held;
  for (int attempt = 0; file_ < 0; ++attempt) {
    temporary_ = folder_of(target_) + temporary_name(name, attempt);
    file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (file_ < 0 && (errno != EEXIST || attempt > 1000)) throw_cannot_create(path_, errno);
  }
  hold(file_);
  passing_ = std::make_unique<Passing>(Passing::Kind::file, temporary_);
  if (exists) ::fchmod(file_, mode);
}

AtomicFile::~AtomicFile() {
  if (file_ >= 0) ::close(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view bytes) { write_all(file_, bytes, path_); }

void AtomicFile::commit() {
  const bool device = temporary_.empty();
  if (!device) sync(file_, path_);
  if (::close(std::exchange(file_, -1)) != 0) throw CannotWrite(path_, errno);
  if (device) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) throw CannotWrite(path_, errno);
  temporary_.clear();
  passing_.reset();
  sync_folder(folder_of(target_));
}

OutputFolder::OutputFolder(std::string path) : path_(std::move(path)) {
  std::error_code error;
  for (std::filesystem::path at = path_; !at.empty() && !std::filesystem::exists(at, error); at = at.parent_path())
    made_.push_back(at.string());
  std::filesystem::create_directories(path_, error);
  if (error) throw BadInput(fmt::format("{}: cannot make the folder: {}", path_, error.message()));
  staging_ = std::make_unique<ScratchFolder>(path_);
}

OutputFolder::~OutputFolder() {
  for (const File& file : files_) ::unlink(file.staged.c_str());
  staging_.reset();
  for (const std::string& folder : made_) ::rmdir(folder.c_str());
}

void OutputFolder::add(const std::string& name, std::string_view bytes) {
  const std::string shown = path_ + "/" + name;
  const std::string target = resolved(shown);
  const Target at_target = look_at(target, shown);
  const auto known = std::find_if(files_.begin(), files_.end(), [&](const File& file) { return file.shown == shown; });
  const File& staged = known != files_.end() ? *known : files_.emplace_back(stage(name, shown, target));
  const int file = ::open(staged.staged.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw_cannot_create(shown, errno);
  const Descriptor closed_at_the_end(file);
  if (at_target.exists) ::fchmod(file, at_target.mode);
  write_all(file, bytes, shown);
  sync(file, shown);
}

/// Where a file waits: in a folder that is renamed from in one step. The end of a link may lie in another file system.
OutputFolder::File OutputFolder::stage(const std::string& name, const std::string& shown, const std::string& target) {
  if (folder_of(target) == resolved(path_) + "/" || folder_of(target) == folder_of(shown))
    return {shown, target, staging_->path() + "/" + name, staging_->path() + "/" + name + ".old", nullptr};
  File file{shown, target, folder_of(target) + temporary_name(name, 0), folder_of(target) + temporary_name(name, 1),
            nullptr};
  file.passing = std::make_unique<Passing>(Passing::Kind::file, file.staged);
  return file;
}

void OutputFolder::commit() {
  const SignalsHeld held;
  std::size_t done = 0;
  for (; done < files_.size(); ++done)
    if (const int error = files_[done].put(); error != 0) {
      const std::string failed = files_[done].shown;
      while (done-- > 0) files_[done].take_back();
      throw CannotWrite(failed, error);
    }
  for (const File& file : files_) {
    ::unlink(file.kept.c_str());
    sync_folder(folder_of(file.target));
  }
  files_.clear();
}

/// Puts the file in its place and keeps what was there beside it; the system's error, 0 for none.
int OutputFolder::File::put() const noexcept {
  ::unlink(kept.c_str());
  if (::link(target.c_str(), kept.c_str()) != 0 && errno != ENOENT) return errno;
  if (::rename(staged.c_str(), target.c_str()) == 0) return 0;
  const int error = errno;
  ::unlink(kept.c_str());
  return error;
}

void OutputFolder::File::take_back() const noexcept {
  if (::rename(kept.c_str(), target.c_str()) != 0) ::unlink(target.c_str());  // there was nothing
}

namespace {

/// Whether two paths lead to one regular file, which need not be there yet.
bool same_file(const std::string& a, const std::string& b) {
  struct stat at_a = {}, at_b = {};
  const bool exists = ::stat(a.c_str(), &at_a) == 0;
  if (exists != (::stat(b.c_str(), &at_b) == 0)) return false;
  if (exists) return S_ISREG(at_a.st_mode) && at_a.st_dev == at_b.st_dev && at_a.st_ino == at_b.st_ino;
  std::error_code error;
  const auto whole = std::filesystem::weakly_canonical(a, error);
  return !error && whole == std::filesystem::weakly_canonical(b, error) && !error;
}

bool is_file(const NamedFile& file) { return !file.path.empty() && file.path != "-"; }

}  // namespace

void require_apart(std::span<const NamedFile> inputs, std::span<const NamedFile> outputs) {
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const NamedFile& output = outputs[k];
    if (!is_file(output)) continue;
    for (const NamedFile& input : inputs)
      if (is_file(input) && same_file(input.path, output.path))
        throw BadInput(output.flag, output.path, fmt::format("another file than {} reads", input.flag));
    for (const NamedFile& other : outputs.first(k))
      if (is_file(other) && same_file(other.path, output.path))
        throw BadInput(output.flag, output.path, fmt::format("another file than {} writes", other.flag));
  }
}

Output::Output(const std::string& path)
    : file_(path.empty() || path == "-" ? nullptr : std::make_unique<AtomicFile>(path)) {}

void Output::write(std::string_view bytes) { file_ ? file_->write(bytes) : write_stdout(bytes); }

void Output::commit() {
  if (file_) file_->commit();
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

void write_all(int file, std::string_view bytes, std::string_view name) {
  while (!bytes.empty()) {
    const auto written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) throw CannotWrite(name, errno);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
}

}  // namespace ricochet::console
