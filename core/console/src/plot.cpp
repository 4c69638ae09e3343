#include "svg_theme.hpp"

#include <console/exit.hpp>
#include <console/output.hpp>
#include <console/plot.hpp>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <string_view>
#include <system_error>
#include <vector>

namespace ricochet::console {

namespace {

/// A file in memory: gnuplot's input and outputs never touch the disk and no pipe can fill up and block.
class MemoryFile {
 public:
  MemoryFile() : file_(::memfd_create("gnuplot", MFD_CLOEXEC)) {
    if (file_ < 0) throw Failed("gnuplot: no memory file: " + std::generic_category().message(errno));
  }
  ~MemoryFile() { ::close(file_); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  int descriptor() const { return file_; }

  void fill(std::string_view bytes) {
    while (!bytes.empty()) {
      const auto written = ::write(file_, bytes.data(), bytes.size());
      if (written < 0) throw Failed("gnuplot: cannot pass the script: " + std::generic_category().message(errno));
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
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

struct Ran {
  std::string out;
  std::string err;
  int status;
};

/// This process's environment in the C.UTF-8 locale: in plain C gnuplot warns about its degree sign, and in others
/// it would draw decimal commas.
std::vector<std::string> utf8_environment() {
  std::vector<std::string> variables{"LC_ALL=C.UTF-8"};
  for (char** entry = environ; *entry; ++entry)
    if (!std::string_view(*entry).starts_with("LC_ALL=")) variables.emplace_back(*entry);
  return variables;
}

Ran gnuplot(const std::string& script, const std::string& folder) {
  MemoryFile in;
  MemoryFile out;
  MemoryFile err;
  in.fill(script);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  ::posix_spawn_file_actions_adddup2(&actions, in.descriptor(), STDIN_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, out.descriptor(), STDOUT_FILENO);
  ::posix_spawn_file_actions_adddup2(&actions, err.descriptor(), STDERR_FILENO);
  std::array<char, 8> name{"gnuplot"};
  std::array<char*, 2> arguments{name.data(), nullptr};
  std::vector<std::string> variables = utf8_environment();
  std::vector<char*> environment;
  environment.reserve(variables.size() + 1);
  for (std::string& variable : variables) environment.push_back(variable.data());
  environment.push_back(nullptr);
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments.data(), environment.data());
  ::posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT) throw Failed("gnuplot: not found; Debian's package is gnuplot-nox");
  if (error != 0) throw Failed("gnuplot: cannot start: " + std::generic_category().message(error));
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return {out.content(), err.content(), status};
}

/// What all figures share. Grid and axes stay behind the data; line types are the palette.
constexpr const char* house_style =
    "set encoding utf8\nset datafile separator comma\nset border 3 lc rgb 'black' lw 1\nset tics nomirror out scale 0.5\n"
    "set grid back lt 1 lc rgb '#dddddd' lw 0.7, lt 1 lc rgb '#dddddd' lw 0.7\nset key reverse Left spacing 1.2 samplen 2\n"
    "set linetype 1 lc rgb '#0072b2' lw 2 pt 7\nset linetype 2 lc rgb '#d55e00' lw 2 pt 5\n"
    "set linetype 3 lc rgb '#009e73' lw 2 pt 9\nset linetype 4 lc rgb '#e69f00' lw 2 pt 13\n"
    "set linetype 5 lc rgb '#cc79a7' lw 2 pt 11\nset linetype 6 lc rgb '#56b4e9' lw 2 pt 6\n"
    "set linetype 7 lc rgb '#767676' lw 2 pt 4\nset linetype cycle 7\n";

std::string picture(const Figure& figure, const std::string& terminal, const std::string& folder) {
  const std::string size = std::to_string(figure.width) + "," + std::to_string(figure.height);
  const Ran ran = gnuplot("set terminal " + terminal + " size " + size + "\n" + house_style + figure.script + "\n", folder);
  // gnuplot ends with 0 on "warning: Skipping data file with no valid points": whatever it says is an error here.
  if (ran.status != 0 || !ran.err.empty() || ran.out.empty())
    throw Failed("gnuplot, figure " + figure.name + ": " + (ran.err.empty() ? "nothing drawn" : ran.err));
  return ran.out;
}

std::string vector_picture(const Figure& figure, const std::string& folder) {
  return themed(picture(figure, "svg dynamic font 'sans-serif,14' background rgb 'white'", folder), figure.caption,
                figure.finding);
}

/// A folder that is gone, with all that is in it, at the end of the scope.
class PassingFolder {
 public:
  PassingFolder() : path_((std::filesystem::temp_directory_path() / "ricochet-XXXXXX").string()) {
    if (!::mkdtemp(path_.data())) throw Failed(path_ + ": cannot make the folder: " + std::generic_category().message(errno));
  }
  ~PassingFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

}  // namespace

std::string draw(const Figure& figure, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw BadInput(folder + ": cannot make the folder: " + error.message());
  for (const DataFile& data : figure.data) write_atomically(folder + "/" + data.name, data.bytes);
  const std::string stem = folder + "/" + figure.name;
  std::string svg = vector_picture(figure, folder);
  write_atomically(stem + ".svg", svg);
  write_atomically(stem + ".png", picture(figure, "pngcairo font 'sans,11' background rgb 'white'", folder));
  return svg;
}

std::string svg_of(const Figure& figure) {
  const PassingFolder folder;
  for (const DataFile& data : figure.data) write_atomically(folder.path() + "/" + data.name, data.bytes);
  return vector_picture(figure, folder.path());
}

std::string gnuplot_version() {
  const Ran ran = gnuplot("set print '-'\nprint GPVAL_VERSION, ' patchlevel ', GPVAL_PATCHLEVEL\n", ".");
  if (ran.status != 0 || ran.out.empty()) throw Failed("gnuplot: it does not tell its version");
  return ran.out.substr(0, ran.out.find('\n'));
}

}  // namespace ricochet::console
