#include "cleanup.hpp"
#include "durable.hpp"
#include "leftovers.hpp"
#include "places.hpp"

#include <console/exit.hpp>
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

}  // namespace

AtomicFile::AtomicFile(std::string path) {
  if (path.empty()) throw BadInput("output = '': must be the name of a file");
  waiting_.target = resolved(path);
  waiting_.shown = std::move(path);
  const Target target = look_at(waiting_.target, waiting_.shown);
  if (!target.exists || target.regular) {
    open_temporary(target.exists, target.mode);
  } else {
    file_ = ::open(waiting_.target.c_str(), O_WRONLY | O_CLOEXEC);
    if (file_ < 0) throw_cannot_create(waiting_.shown, errno);
  }
}

void AtomicFile::open_temporary(bool exists, unsigned mode) {
  const std::string folder = folder_of(waiting_.target);
  const auto slash = waiting_.target.find_last_of('/');
  const std::string name = slash == std::string::npos ? waiting_.target : waiting_.target.substr(slash + 1);
  remove_leftovers(folder, hidden_scratch);
  const SignalsHeld held;
  std::string temporary;
  for (int attempt = 0; file_ < 0; attempt += 2) {
    temporary = folder + temporary_name(name, attempt);
    waiting_.kept = folder + temporary_name(name, attempt + 1);
    file_ = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (file_ < 0 && (errno != EEXIST || attempt > 1000)) throw_cannot_create(waiting_.shown, errno);
  }
  waiting_.staged = temporary;
  hold(file_);
  waiting_.passing = std::make_unique<Passing>(Passing::Kind::file, temporary);
  if (exists) ::fchmod(file_, mode);
}

AtomicFile::~AtomicFile() {
  if (file_ >= 0) ::close(file_);
  if (!waiting_.staged.empty()) ::unlink(waiting_.staged.c_str());
}

void AtomicFile::write(std::string_view bytes) { write_all(file_, bytes, waiting_.shown); }

Waiting* AtomicFile::finish() {
  const bool device = waiting_.staged.empty();
  if (!device) sync(file_, waiting_.shown);
  if (::close(std::exchange(file_, -1)) != 0) throw CannotWrite(waiting_.shown, errno);
  return device ? nullptr : &waiting_;
}

void AtomicFile::commit() {
  if (Waiting* const file = finish()) put_in_place({file});
}

MadeFolder::MadeFolder(std::string path) : path_(std::move(path)) {
  if (path_ == "-") throw BadInput("-: must be a folder, which standard output is not");
  std::error_code error;
  for (std::filesystem::path at = path_; !at.empty() && !std::filesystem::exists(at, error); at = at.parent_path())
    ++made_;
  const SignalsHeld held;
  std::filesystem::create_directories(path_, error);
  if (error) {
    remove_empty_folders(path_, made_);
    std::error_code none;
    throw BadInput(fmt::format("{}: cannot make the folder: {}", path_,
                               std::filesystem::is_symlink(path_, none) ? "it is a link to nothing" : error.message()));
  }
  const std::string whole = std::filesystem::absolute(path_).string();
  passing_ = std::make_unique<Passing>(Passing::Kind::empty_folders, whole, made_);
}

MadeFolder::~MadeFolder() { remove_empty_folders(path_, made_); }

OutputFolder::OutputFolder(std::string path)
    : folder_(std::move(path)), staging_(std::make_unique<ScratchFolder>(folder_.path())) {}

OutputFolder::~OutputFolder() {
  for (const Waiting& file : files_) ::unlink(file.staged.c_str());
}

void OutputFolder::add(const std::string& name, std::string_view bytes) {
  const std::string shown = folder_.path() + "/" + name;
  const std::string target = resolved(shown);
  const Target at_target = look_at(target, shown);
  const auto known =
      std::find_if(files_.begin(), files_.end(), [&](const Waiting& file) { return file.shown == shown; });
  const Waiting& staged = known != files_.end() ? *known : files_.emplace_back(stage(name, shown, target));
  const int file = ::open(staged.staged.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) throw_cannot_create(shown, errno);
  const Descriptor closed_at_the_end(file);
  if (at_target.exists) ::fchmod(file, at_target.mode);
  write_all(file, bytes, shown);
  sync(file, shown);
}

/// Where a file waits: in a folder that is renamed from in one step. The end of a link may lie in another file system.
Waiting OutputFolder::stage(const std::string& name, const std::string& shown, const std::string& target) {
  if (folder_of(target) == resolved(folder_.path()) + "/" || folder_of(target) == folder_of(shown))
    return {shown, target, staging_->path() + "/" + name, staging_->path() + "/" + name + ".old", nullptr};
  const auto beside = [&](int attempt) { return folder_of(target) + temporary_name(name, attempt); };
  int attempt = 0;  // another file of ours may have that name
  while (::access(beside(attempt).c_str(), F_OK) == 0) attempt += 2;
  Waiting file{shown, target, beside(attempt), beside(attempt + 1), nullptr};
  file.passing = std::make_unique<Passing>(Passing::Kind::file, file.staged);
  return file;
}

void OutputFolder::commit() {
  std::vector<Waiting*> files;
  for (Waiting& file : files_) files.push_back(&file);
  put_in_place(files);
  files_.clear();
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

Together::Together() = default;
Together::~Together() = default;

OutputFolder& Together::folder(const std::string& path) {
  return *folders_.emplace_back(std::make_unique<OutputFolder>(path));
}

AtomicFile& Together::file(const std::string& path) { return *files_.emplace_back(std::make_unique<AtomicFile>(path)); }

Output& Together::output(const std::string& path) { return *outputs_.emplace_back(std::make_unique<Output>(path)); }

void Together::commit() {
  std::vector<Waiting*> all;
  for (const auto& folder : folders_)
    for (Waiting& file : folder->files_) all.push_back(&file);
  const auto take = [&](AtomicFile* file) {
    if (Waiting* const waiting = file ? file->finish() : nullptr) all.push_back(waiting);
  };
  for (const auto& file : files_) take(file.get());
  for (const auto& output : outputs_) take(output->file_.get());
  put_in_place(all);
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
