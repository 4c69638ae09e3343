#include "temporary_folder.hpp"

#include <console/exit.hpp>
#include <console/input.hpp>
#include <console/output.hpp>
#include <console/scratch.hpp>
#include <console/signals.hpp>

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <csignal>

using namespace ricochet::console;

namespace {

/// Runs `body` in a child process and returns its wait status.
template <class Body>
int in_child(Body body) {
  const pid_t child = ::fork();
  if (child == 0) {
    for (int signal = 1; signal < SIGRTMIN; ++signal) std::signal(signal, SIG_DFL);  // Catch2 caught some
    body();
    ::_exit(0);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return status;
}

}  // namespace

TEST_CASE("a file is written whole and replaces the old one") {
  const TemporaryFolder folder;
  write_atomically(folder / "a.txt", "first");
  write_atomically(folder / "a.txt", "second");
  CHECK(read_file(folder / "a.txt") == "second");
  CHECK(folder.count() == 1);
}

TEST_CASE("a name that no file system takes is refused before anything is written") {
  const TemporaryFolder folder;
  const std::string path = folder / std::string(300, 'x');
  CHECK_THROWS_AS(AtomicFile(path), BadInput);
  CHECK_THROWS_WITH(AtomicFile(path), path + ": cannot write: File name too long");
  CHECK(folder.count() == 0);
}

TEST_CASE("without commit nothing is left and the old file stays") {
  const TemporaryFolder folder;
  write_atomically(folder / "a.txt", "old");
  {
    AtomicFile file(folder / "a.txt");
    file.write("half");
    CHECK(folder.count() == 2);
  }
  CHECK(read_file(folder / "a.txt") == "old");
  CHECK(folder.count() == 1);
}

TEST_CASE("a file keeps its permissions and a link its target") {
  const TemporaryFolder folder;
  write_atomically(folder / "a.txt", "old");
  ::chmod((folder / "a.txt").c_str(), 0640);
  std::filesystem::create_symlink("a.txt", folder / "link");
  write_atomically(folder / "link", "new");
  CHECK(std::filesystem::is_symlink(folder / "link"));
  CHECK(read_file(folder / "a.txt") == "new");
  struct stat status = {};
  ::stat((folder / "a.txt").c_str(), &status);
  CHECK((status.st_mode & 07777) == 0640);
}

TEST_CASE("a device is written through, not replaced") {
  write_atomically("/dev/null", "bytes");
  CHECK(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("a path that cannot be written is bad input, by name and reason") {
  const TemporaryFolder folder;
  CHECK_THROWS_AS(write_atomically(folder / "none/a.txt", "x"), BadInput);
  CHECK_THROWS_WITH(write_atomically("/none/a.txt", "x"), "/none/a.txt: cannot write: No such file or directory");
  CHECK_THROWS_AS(write_atomically(folder.path(), "x"), BadInput);
  CHECK_THROWS_AS(write_atomically("", "x"), BadInput);
  CHECK(folder.count() == 0);
}

TEST_CASE("a file that grows past the limit leaves the old one and no other") {
  const TemporaryFolder folder;
  write_atomically(folder / "a.txt", "old");
  const int status = in_child([&] {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1000, 1000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_atomically(folder / "a.txt", std::string(100000, 'x'));
    } catch (const Failed&) {
      ::_exit(7);
    }
  });
  CHECK(WEXITSTATUS(status) == 7);
  CHECK(read_file(folder / "a.txt") == "old");
  CHECK(folder.count() == 1);
}

TEST_CASE("a full device is reported") { CHECK_THROWS_AS(write_atomically("/dev/full", "x"), Failed); }

TEST_CASE("a signal removes the temporary file and still kills") {
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
  for (const int signal :
       {SIGINT,  SIGTERM, SIGHUP, SIGQUIT, SIGUSR1, SIGUSR2, SIGALRM, SIGXCPU, SIGVTALRM, SIGPROF,
        SIGPOLL, SIGPWR,  SIGSYS, SIGABRT, SIGSEGV, SIGBUS,  SIGFPE,  SIGILL,  SIGTRAP,   SIGSTKFLT}) {
    CAPTURE(signal);
    const TemporaryFolder folder;
    const int status = in_child([&] {
      AtomicFile file(folder / "a.txt");
      file.write("half");
      ::raise(signal);
    });
    CHECK(WIFSIGNALED(status));
    CHECK(WTERMSIG(status) == signal);
    CHECK(folder.count() == 0);
  }
}

TEST_CASE("the files of a folder appear together") {
  const TemporaryFolder folder;
  write_atomically(folder / "a.txt", "old");
  ::chmod((folder / "a.txt").c_str(), 0640);
  {
    OutputFolder output(folder.path());
    output.add("a.txt", "first");
    output.add("a.txt", "new");
    output.add("b.txt", "new");
    CHECK(read_file(folder / "a.txt") == "old");
    CHECK_FALSE(std::filesystem::exists(folder / "b.txt"));
    output.commit();
  }
  CHECK(read_file(folder / "a.txt") == "new");
  CHECK(read_file(folder / "b.txt") == "new");
  CHECK((std::filesystem::status(folder / "a.txt").permissions() & std::filesystem::perms::all) ==
        std::filesystem::perms(0640));
  CHECK(folder.count() == 2);
}

TEST_CASE("a folder's files that are not put in their places leave nothing") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "taken");
  {
    OutputFolder output(folder.path());
    output.add("a.txt", "half");
    CHECK_THROWS_WITH(output.add("taken", "x"), (folder / "taken") + ": cannot write: Is a directory");
  }
  { OutputFolder made(folder / "made"); }
  CHECK(folder.count() == 1);
  CHECK_THROWS_AS(OutputFolder("/dev/null/x"), BadInput);
  CHECK_THROWS_WITH(OutputFolder("-"), "-: must be a folder, which standard output is not");
  std::filesystem::create_symlink("nowhere", folder / "gone");
  CHECK_THROWS_WITH(OutputFolder(folder / "gone"), Catch::EndsWith("it is a link to nothing"));
}

TEST_CASE("a folder's files are all replaced, or none") {
  const TemporaryFolder folder, elsewhere;
  // A name that is a folder's by the time of the commit cannot be replaced by a file.
  const auto filled = [&](OutputFolder& output) {
    for (const std::string name : {"a.txt", "b.txt", "new.txt", "z.txt"}) output.add(name, "new");
  };
  for (const std::string name : {"a.txt", "b.txt"}) write_atomically(folder / name, "old");
  {
    OutputFolder output(folder.path());
    filled(output);
    std::filesystem::create_directory(folder / "z.txt");
    CHECK_THROWS_WITH(output.commit(), Catch::Contains("z.txt: cannot write"));
  }
  CHECK(read_file(folder / "a.txt") == "old");
  CHECK(read_file(folder / "b.txt") == "old");
  CHECK_FALSE(std::filesystem::exists(folder / "new.txt"));
  CHECK(folder.count() == 3);
  // The end of a link may lie in another folder, and in another file system.
  std::filesystem::remove(folder / "z.txt");
  write_atomically(elsewhere / "z", "old");
  std::filesystem::create_symlink(elsewhere / "z", folder / "z.txt");
  {
    OutputFolder output(folder.path());
    filled(output);
    CHECK(elsewhere.count() == 2);
    output.commit();
  }
  CHECK(read_file(elsewhere / "z") == "new");
  CHECK(std::filesystem::is_symlink(folder / "z.txt"));
  CHECK(folder.count() == 4);
  CHECK(elsewhere.count() == 1);
}

TEST_CASE("a link that leads nowhere, or round in a circle, is refused") {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("nowhere", folder / "dangling");
  std::filesystem::create_symlink("circle", folder / "circle");
  for (const std::string name : {"dangling", "circle"}) {
    CHECK_THROWS_WITH(write_atomically(folder / name, "x"),
                      (folder / name) + ": cannot write: a link that leads nowhere");
    OutputFolder output(folder.path());
    CHECK_THROWS_AS(output.add(name, "x"), BadInput);
  }
}

TEST_CASE("an output is neither an input nor another output, by whatever path, link or name still free") {
  const TemporaryFolder folder;
  const std::string there = folder / "there.csv", free = folder / "free.csv",
                    around = folder / "../" + std::filesystem::path(folder.path()).filename().string();
  std::ofstream(there) << "x";
  std::filesystem::create_symlink(there, folder / "link.csv");
  using Files = std::vector<NamedFile>;
  const auto complaint = [](const Files& inputs, const Files& outputs) -> std::string {
    try {
      require_apart(inputs, outputs);
      return "none";
    } catch (const BadInput& error) {
      return error.what();
    }
  };
  for (const std::string& path : {there, around + "/there.csv", folder / "link.csv"})
    CHECK(complaint({{"--fit", there}}, {{"-o", path}}) == "-o = " + path + ": must be another file than --fit reads");
  for (const std::string& path : {free, around + "/free.csv"})
    CHECK(complaint({}, {{"-o", free}, {"--report", path}}) ==
          "--report = " + path + ": must be another file than -o writes");
  CHECK(complaint({{"--fit", there}}, {{"-o", free}, {"--report", folder / "page.html"}}) == "none");
  CHECK(complaint({{"--fit", "-"}, {"--targets", ""}}, {{"-o", "-"}, {"--report", ""}}) == "none");
  CHECK(complaint({{"--fit", "/dev/null"}}, {{"-o", "/dev/null"}}) == "none");
}

TEST_CASE("what a killed process left is removed by the next one in that folder, and no more") {
  const TemporaryFolder folder;
  const int killed = in_child([&] {
    const AtomicFile file(folder / "a.txt");
    const OutputFolder output(folder.path());
    ::raise(SIGKILL);
  });
  CHECK(WTERMSIG(killed) == SIGKILL);
  CHECK(folder.count() == 2);
  std::ofstream(folder / ".a.txt.part") << "somebody's own";
  std::ofstream(folder / ".a.txt.1.0.part") << "of a process that lives";
  const AtomicFile ours(folder / "c.txt");
  { OutputFolder output(folder.path()); }
  write_atomically(folder / "b.txt", "b");
  CHECK(folder.count() == 4);
  CHECK(std::filesystem::exists(folder / ".a.txt.part"));
  CHECK(std::filesystem::exists(folder / ".a.txt.1.0.part"));
}

TEST_CASE("folders that were made for files that never came are gone again, those that were there stay") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "a");
  {
    OutputFolder out(folder.path() / "a/b/c");
    out.add("x.txt", "x");
    CHECK(std::filesystem::exists(folder.path() / "a/b/c"));
  }
  CHECK(std::filesystem::exists(folder.path() / "a"));
  CHECK_FALSE(std::filesystem::exists(folder.path() / "a/b"));
  OutputFolder out(folder.path() / "a/b/c");
  out.add("x.txt", "x");
  out.commit();
  CHECK(read_file(folder / "a/b/c/x.txt") == "x");
}

TEST_CASE("a signal takes back the folders that were made, however they are written, and no others") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "there");
  for (const std::string path : {"there/a/b/c", "a", "a/", "a//b///c", "there/../a/b/../c", "a/./b"}) {
    CAPTURE(path);
    const int status = in_child([&] {
      OutputFolder output(folder / path);
      output.add("x.txt", "x");
      ::raise(SIGTERM);
    });
    CHECK(WTERMSIG(status) == SIGTERM);
    CHECK(folder.count() == 1);
    CHECK(std::filesystem::is_empty(folder / "there"));
  }
  // What came to stay keeps its folders.
  in_child([&] {
    OutputFolder output(folder / "a/b");
    output.add("x.txt", "x");
    output.commit();
    ::raise(SIGTERM);
  });
  CHECK(read_file(folder / "a/b/x.txt") == "x");
}

TEST_CASE("folders that are made but have no room for a name inside are not left") {
  const TemporaryFolder folder;
  std::string deep = folder / "a";
  while (deep.size() < 4085) deep += "/" + std::string(std::min<std::size_t>(250, 4085 - deep.size()), 'd');
  CHECK_THROWS_AS(OutputFolder(deep), BadInput);
  CHECK(folder.count() == 0);
}

TEST_CASE("all files of a command are replaced, or none") {
  const TemporaryFolder folder;
  for (const std::string name : {"page", "answer"}) write_atomically(folder / name, "old");
  const auto write = [&](Together& all) {
    all.folder(folder / "figures").add("a.txt", "new");
    all.file(folder / "page").write("new");
    all.output(folder / "answer").write("new");
  };
  {
    Together all;
    write(all);
    // By the time of the commit the last is a folder's name.
    std::filesystem::remove(folder / "answer");
    std::filesystem::create_directory(folder / "answer");
    CHECK_THROWS_WITH(all.commit(), (folder / "answer") + ": cannot write: Is a directory");
  }
  CHECK(read_file(folder / "page") == "old");
  CHECK_FALSE(std::filesystem::exists(folder / "figures"));
  std::filesystem::remove(folder / "answer");
  Together all;
  write(all);
  CHECK(read_file(folder / "page") == "old");
  all.commit();
  CHECK(read_file(folder / "page") == "new");
  CHECK(read_file(folder / "answer") == "new");
  CHECK(read_file(folder / "figures/a.txt") == "new");
  CHECK(folder.count() == 3);
}

TEST_CASE("files that wait beside each other do not meet") {
  const TemporaryFolder folder, elsewhere;
  write_atomically(elsewhere / "b", "old");
  std::filesystem::create_symlink(elsewhere / "b", folder / "a");
  Together all;
  all.output(elsewhere / "a").write("answer");
  all.folder(folder.path()).add("a", "figure");  // waits in the same folder, under the name of a as well
  all.commit();
  CHECK(read_file(elsewhere / "a") == "answer");
  CHECK(read_file(elsewhere / "b") == "figure");
  CHECK(elsewhere.count() == 2);
}

TEST_CASE("two outputs that would be the same file are refused when their names are known") {
  const TemporaryFolder folder;
  write_atomically(folder / "a.txt", "old");
  for (const std::string name : {"a.txt", "b.txt"}) {
    Together all;
    all.folder(folder.path()).add(name, "x");
    const std::string other = folder.path().string() + "/./" + name;
    all.output(other).write("y");
    CHECK_THROWS_WITH(all.commit(), other + ": would be written twice: each output must have a name of its own");
  }
  CHECK(read_file(folder / "a.txt") == "old");
  CHECK(folder.count() == 1);
}

TEST_CASE("a folder that somebody holds is no leftover, even where no process has the number in its name") {
  const pid_t gone = ::fork();
  if (gone == 0) ::_exit(0);
  ::waitpid(gone, nullptr, 0);
  const TemporaryFolder folder;
  const ScratchFolder scratch(folder.path());
  std::string other = scratch.path();
  const std::string ours = std::to_string(::getpid()) + "-";
  const auto number = other.rfind(ours);
  REQUIRE(number != std::string::npos);
  other.replace(number, ours.size(), std::to_string(gone) + "-");
  // As from another namespace of processes.
  REQUIRE(::rename(scratch.path().c_str(), other.c_str()) == 0);
  { OutputFolder output(folder.path()); }
  CHECK(std::filesystem::exists(other));
  ::rename(other.c_str(), scratch.path().c_str());
}

TEST_CASE("a signal removes folders that pass, with what is in them") {
  const TemporaryFolder folder;
  const int status = in_child([&] {
    const OutputFolder output(folder.path());
    const ScratchFolder scratch(folder.path());
    for (int i = 0; i < 300; ++i) scratch.write("a-rather-long-name-for-a-file-" + std::to_string(i), "x");
    ::raise(SIGTERM);
  });
  CHECK(WTERMSIG(status) == SIGTERM);
  CHECK(folder.count() == 0);
}

TEST_CASE("a signal that is noted ends nothing, the second one everything, ignored ones stay ignored") {
  const int noted = in_child([] {
    std::signal(SIGHUP, SIG_IGN);
    const StopOnSignal signals;
    ::raise(SIGHUP);
    if (StopOnSignal::noted() != 0) ::_exit(1);
    ::raise(SIGTERM);
    ::_exit(StopOnSignal::noted());
  });
  CHECK(WEXITSTATUS(noted) == SIGTERM);
  const TemporaryFolder folder;
  const int twice = in_child([&] {
    const StopOnSignal signals;
    const AtomicFile file(folder / "a.txt");
    ::raise(SIGTERM);
    ::raise(SIGINT);
  });
  CHECK(WIFSIGNALED(twice));
  CHECK(WTERMSIG(twice) == SIGINT);
  CHECK(folder.count() == 0);
  CHECK(WTERMSIG(in_child([] { end_by(SIGHUP); })) == SIGHUP);
}

TEST_CASE("an input is read whole up to a GiB, and refused beyond, whatever it is") {
  const TemporaryFolder folder;
  const std::string path = folder / "large.json";
  write_atomically(path, "{}");
  CHECK(read_input(path) == "{}");
  REQUIRE(::truncate(path.c_str(), static_cast<off_t>(largest_input) + 1) == 0);  // takes no room
  CHECK_THROWS_WITH(read_input(path), path + ": too large: must be at most 1 GiB");
  CHECK_THROWS_WITH(read_input(folder / "none"), (folder / "none") + ": cannot be read: No such file or directory");
}
