#include "cleanup.hpp"

#include <console/child.hpp>
#include <console/exit.hpp>
#include <console/output.hpp>

#include <fmt/format.h>

#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace ricochet::console {

namespace {

std::string reason(int error) { return std::generic_category().message(error); }

/// A file in memory: a child's input and outputs never touch the disk and no pipe can fill up and block.
class MemoryFile {
 public:
  explicit MemoryFile(const std::string& program) : file_(::memfd_create("ricochet", MFD_CLOEXEC)) {
    if (file_ < 0) throw Failed(fmt::format("{}: no memory file: {}", program, reason(errno)));
  }
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return file_; }

  void fill(std::string_view bytes) const {
    write_all(file_, bytes, "memory file");
    ::lseek(file_, 0, SEEK_SET);
  }

  std::string content() const {
    ::lseek(file_, 0, SEEK_SET);
    std::string all;
    std::array<char, 65536> chunk{};
    for (ssize_t n = 0; (n = ::read(file_, chunk.data(), chunk.size())) > 0;)
      all.append(chunk.data(), static_cast<std::size_t>(n));
    return all;
  }

 private:
  int file_;
};

/// posix_spawn's two descriptions of the child, freed at the end of the scope.
struct Start {
  Start() {
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawnattr_init(&attributes);
  }
  ~Start() {
    ::posix_spawn_file_actions_destroy(&actions);
    ::posix_spawnattr_destroy(&attributes);
  }
  Start(const Start&) = delete;
  Start& operator=(const Start&) = delete;

  /// A process group of its own, so that its own children can be ended with it, and the signals as a program expects
  /// them at its start.
  void isolate(const sigset_t& mask) {
    sigset_t defaults;
    ::sigemptyset(&defaults);
    for (const int signal : {SIGPIPE, SIGXFSZ}) ::sigaddset(&defaults, signal);
    ::posix_spawnattr_setsigdefault(&attributes, &defaults);
    ::posix_spawnattr_setsigmask(&attributes, &mask);
    ::posix_spawnattr_setpgroup(&attributes, 0);
    ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
  }

  posix_spawn_file_actions_t actions{};
  posix_spawnattr_t attributes{};
};

std::string_view name_of(std::string_view variable) { return variable.substr(0, variable.find('=')); }

/// What a program needs to be found and to start; Open MPI's are about the machine. All else is somebody's taste.
bool is_handed_on(std::string_view name) {
  constexpr std::array<std::string_view, 3> needed{"PATH", "LD_LIBRARY_PATH", "TMPDIR"};
  return std::find(needed.begin(), needed.end(), name) != needed.end() || name.starts_with("OMPI_");
}

/// In plain C gnuplot warns about its degree sign, and in others programs would write decimal commas. At home lie
/// start-up files that could change what is drawn or computed.
std::vector<std::string> environment_of(const Command& command) {
  std::vector<std::string> variables = command.environment;
  for (const char* const ours : {"LC_ALL=C.UTF-8", "HOME=/nonexistent"}) variables.emplace_back(ours);
  const std::size_t ours = variables.size();
  for (char** entry = environ; *entry; ++entry)
    if (is_handed_on(name_of(*entry)) &&
        std::none_of(variables.begin(), variables.begin() + static_cast<std::ptrdiff_t>(ours),
                     [&](const std::string& mine) { return name_of(mine) == name_of(*entry); }))
      variables.emplace_back(*entry);
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> all;
  all.reserve(words.size() + 1);
  for (std::string& word : words) all.push_back(word.data());
  all.push_back(nullptr);
  return all;
}

int waited(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

Ran run(const Command& command) {
  const std::string& program = command.arguments.front();
  const MemoryFile in(program), out(program), err(program);
  in.fill(command.input);
  Start start;
  if (!command.folder.empty()) ::posix_spawn_file_actions_addchdir_np(&start.actions, command.folder.c_str());
  ::posix_spawn_file_actions_adddup2(&start.actions, in.descriptor(), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&start.actions, out.descriptor(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&start.actions, err.descriptor(), STDERR_FILENO);
  std::vector<std::string> arguments = command.arguments, variables = environment_of(command);
  pid_t child = 0;
  int error = 0;
  {
    const SignalsHeld held;
    start.isolate(held.before());
    error = ::posix_spawnp(&child, program.c_str(), &start.actions, &start.attributes, pointers(arguments).data(),
                           pointers(variables).data());
    if (error == 0) set_passing_child(child);
  }
  if (error == ENOENT) return {false, 0, {}, {}};
  if (error != 0) throw Failed(fmt::format("{}: cannot start: {}", program, reason(error)));
  const int status = waited(child);
  set_passing_child(0);
  return {true, status, out.content(), err.content()};
}

}  // namespace ricochet::console
