// What has to be on the disc before a name points to it: seen in the calls of this very program, whose fsync and rename
// stand in front of the system's.
#include "temporary_folder.hpp"

#include <catch2/catch.hpp>
#include <console/exit.hpp>
#include <console/output.hpp>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <vector>

namespace {

/// Since the last look: "file", "folder" for what was made durable, "rename".
std::vector<std::string>& calls() {
  static std::vector<std::string> all;
  return all;
}

/// As on a file system whose files have one name each.
bool no_links = false;

}  // namespace

extern "C" int link(const char* from, const char* to) noexcept {
  if (no_links && ::access(from, F_OK) == 0) return errno = EPERM, -1;
  return static_cast<int>(::syscall(SYS_linkat, AT_FDCWD, from, AT_FDCWD, to, 0));
}

extern "C" int fsync(int file) {
  struct stat status = {};
  calls().emplace_back(::fstat(file, &status) == 0 && S_ISDIR(status.st_mode) ? "folder" : "file");
  return static_cast<int>(::syscall(SYS_fsync, file));
}

extern "C" int rename(const char* from, const char* to) noexcept {
  calls().emplace_back("rename");
  return static_cast<int>(::syscall(SYS_renameat2, AT_FDCWD, from, AT_FDCWD, to, 0));
}

using namespace ricochet::console;
using Calls = std::vector<std::string>;

TEST_CASE("a file is on the disc before it takes its name, and the name after that") {
  const TemporaryFolder folder;
  calls().clear();
  write_atomically(folder / "a.txt", "first");
  CHECK(calls() == Calls{"file", "rename", "folder"});
}

TEST_CASE("all files of a folder are on the disc before the first takes its name") {
  const TemporaryFolder folder;
  OutputFolder out(folder.path() / "d");
  calls().clear();
  out.add("a.txt", "a");
  out.add("b.txt", "b");
  CHECK(calls() == Calls{"file", "file"});
  out.commit();
  CHECK(calls() == Calls{"file", "file", "rename", "rename", "folder", "folder"});
}

TEST_CASE("where files have one name each, all files of a folder are replaced, or none") {
  const TemporaryFolder folder;
  for (const std::string name : {"a.txt", "b.txt"}) write_atomically(folder / name, "old");
  no_links = true;
  {
    OutputFolder out(folder.path());
    for (const std::string name : {"a.txt", "b.txt", "c.txt"}) out.add(name, "new");
    std::filesystem::create_directory(folder / "c.txt");
    CHECK_THROWS_AS(out.commit(), CannotWrite);
  }
  CHECK(read_file(folder / "a.txt") == "old");
  CHECK(read_file(folder / "b.txt") == "old");
  std::filesystem::remove(folder / "c.txt");
  OutputFolder out(folder.path());
  out.add("a.txt", "new");
  out.add("b.txt", "new");
  out.commit();
  no_links = false;
  CHECK(read_file(folder / "a.txt") == "new");
  CHECK(read_file(folder / "b.txt") == "new");
}
