#include "temporary_folder.hpp"

#include <console/child.hpp>

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>

#include <chrono>
#include <csignal>
#include <thread>

using namespace ricochet::console;

TEST_CASE("a program gets its input, folder and environment, and what it says comes back") {
  const TemporaryFolder folder;
  ::setenv("LC_ALL", "de_DE.UTF-8", 1);
  const Ran ran = run({.arguments = {"sh", "-c", "cat; pwd; echo $LC_ALL $WORD; echo oops >&2; exit 3"},
                       .folder = folder.path(),
                       .input = "line\n",
                       .environment = {"WORD=said"}});
  ::unsetenv("LC_ALL");
  CHECK(ran.found);
  CHECK(WEXITSTATUS(ran.status) == 3);
  CHECK(ran.out == "line\n" + folder.path().string() + "\nC.UTF-8 said\n");
  CHECK(ran.err == "oops\n");
  CHECK_FALSE(run({.arguments = {"no-such-program"}}).found);
}

TEST_CASE("a program sees of our environment only what it takes to start") {
  ::setenv("GNUTERM", "qt", 1);
  ::setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
  const Ran ran = run({.arguments = {"sh", "-c", "echo $GNUTERM,$HOME,$OMPI_ALLOW_RUN_AS_ROOT,$TMPDIR; echo $PATH"}});
  ::unsetenv("GNUTERM");
  ::unsetenv("OMPI_ALLOW_RUN_AS_ROOT");
  const char* const temporary = std::getenv("TMPDIR");
  CHECK(ran.out == ",/nonexistent,1," + std::string(temporary ? temporary : "") + "\n" + std::getenv("PATH") + "\n");
}

TEST_CASE("a program and its own children do not outlive a signal to this one") {
  const TemporaryFolder folder;
  const std::string pids = folder / "pids";
  const pid_t parent = ::fork();
  if (parent == 0) {
    std::signal(SIGTERM, SIG_DFL);  // Catch2 caught it
    run({.arguments = {"sh", "-c", "sleep 100 & echo $! $$ >made && mv made pids; wait"}, .folder = folder.path()});
    ::_exit(0);
  }
  while (!std::filesystem::exists(pids)) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  std::ifstream in(pids);
  pid_t grandchild = 0, child = 0;
  in >> grandchild >> child;
  REQUIRE(child > 0);
  ::kill(parent, SIGTERM);
  int status = 0;
  ::waitpid(parent, &status, 0);
  CHECK(WTERMSIG(status) == SIGTERM);
  CHECK(::kill(child, 0) != 0);  // waited for
  // Whoever inherits the grandchild waits for it in its own time; it must not sleep on.
  const std::string state_file = "/proc/" + std::to_string(grandchild) + "/stat";
  const auto asleep = [&] { return read_file(state_file).find(") S") != std::string::npos; };
  for (int i = 0; i < 400 && asleep(); ++i) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  CHECK_FALSE(asleep());
}
