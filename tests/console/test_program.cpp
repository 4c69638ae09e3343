#include <console/output.hpp>
#include <console/program.hpp>

#include <ricochet/support/require.hpp>
#include <ricochet/version.hpp>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <system_error>

using namespace ricochet::console;

namespace {

struct Ran {
  int code;
  std::string out;
  std::string err;
};

std::string content(int file) {
  std::string all(static_cast<std::size_t>(::lseek(file, 0, SEEK_END)), '\0');
  [[maybe_unused]] const auto n = ::pread(file, all.data(), all.size(), 0);
  ::close(file);
  return all;
}

/// Runs a small program in a child process. `out` replaces its stdout where it is given.
Ran run(std::vector<const char*> arguments, const std::function<Exit()>& body = {}, int out = -1) {
  const int captured = ::memfd_create("out", 0);
  const int err = ::memfd_create("err", 0);
  std::cout.flush();  // Catch2's own lines must not be written a second time by the child
  const pid_t child = ::fork();
  if (child == 0) {
    ::dup2(out >= 0 ? out : captured, STDOUT_FILENO);
    ::dup2(err, STDERR_FILENO);
    CLI::App app("tries things", "try");
    OutputOptions output;
    double en = 0.5;
    std::optional<double> mass_eff;
    std::optional<unsigned> threads;
    add_version(app);
    add_output_options(app, output);
    add_number(app, "--en", en, "restitution [-]");
    add_number(app, "--mass-eff", mass_eff, "effective mass [kg]");
    add_count(app, "--threads", threads, 256, "that share the work");
    arguments.insert(arguments.begin(), "try");
    const auto shown = [&] {
      ricochet::support::require(en > 0 && en <= 1, "en", en, "in (0, 1]");
      if (mass_eff) ricochet::support::require_positive("mass_eff", *mass_eff);
      if (threads) en /= *threads;
      Output answer(output.file);
      answer.write("en " + std::to_string(en) + " " + std::to_string(static_cast<int>(output.format)) + "\n");
      answer.commit();
      return Exit::done;
    };
    ::_exit(run_program(app, static_cast<int>(arguments.size()), arguments.data(), body ? body : shown));
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, content(captured), content(err)};
}

}  // namespace

TEST_CASE("a program that succeeds is silent on stderr") {
  const Ran ran = run({"--en", "0.25", "--format=csv"});
  CHECK(ran.code == 0);
  CHECK(ran.out == "en 0.250000 2\n");
  CHECK(ran.err.empty());
}

TEST_CASE("an option of a whole number takes the least and the greatest") {
  CHECK(run({"--en", "1", "--threads", "1"}).out == "en 1.000000 0\n");
  CHECK(run({"--en", "1", "--threads", "256"}).out == "en 0.003906 0\n");
}

TEST_CASE("a dash for -o is stdout") { CHECK(run({"--en", "0.25", "-o", "-"}).out == "en 0.250000 0\n"); }

TEST_CASE("help and version are done") {
  CHECK(run({"--version"}).out == std::string("try ") + ricochet::version + "\n");
  const Ran help = run({"--help"});
  CHECK(help.code == 0);
  CHECK(help.out.find("--mass-eff") != std::string::npos);
}

TEST_CASE("every wrong command line is one line and exit code 2") {
  const std::vector<std::pair<std::vector<const char*>, std::string>> cases{
      {{"--en", "1.5"}, "try: --en = 1.5: must be in (0, 1]\n"},
      {{"--en", "abc"}, "try: --en = abc: must be a finite number\n"},
      {{"--en", "nan"}, "try: --en = nan: must be a finite number\n"},
      {{"--en", "1,5"}, "try: --en = 1,5: must be a finite number\n"},
      {{"--en"}, "try: --en: value missing: must be followed by one\n"},
      {{"--en", "0.1", "--en", "0.2"}, "try: --en: given 2 times: must be given once\n"},
      {{"--none", "1"}, "try: --none: not known: must be an option that `try --help` lists\n"},
      {{"extra"}, "try: extra: not known: must be an option that `try --help` lists\n"},
      {{"--mass-eff", "-1"}, "try: --mass-eff = -1: must be finite and > 0\n"},
      {{"--threads", "0"}, "try: --threads = 0: must be a whole number from 1 to 256\n"},
      {{"--threads", "257"}, "try: --threads = 257: must be a whole number from 1 to 256\n"},
      {{"--threads", "1.5"}, "try: --threads = 1.5: must be a whole number from 1 to 256\n"},
      {{"--threads", "two"}, "try: --threads = two: must be a whole number from 1 to 256\n"},
      {{"--format", "xml"}, "try: --format = xml: must be table, json, csv or markdown\n"},
      {{"-o", ""}, "try: --output = '': must not be empty\n"},
      {{"--en", "1\x1b[31m"}, "try: --en = 1\\x1b[31m: must be a finite number\n"},
      {{"--en",
        "1\xc2\x9b"
        "2J"},
       "try: --en = 1\\xc2\\x9b2J: must be a finite number\n"},
      {{"-o", "/none/x"}, "try: /none/x: cannot write: No such file or directory\n"}};
  for (const auto& [arguments, message] : cases) {
    const Ran ran = run(arguments);
    CHECK(ran.code == 2);
    CHECK(ran.err == message);
    CHECK(ran.out.empty());
  }
}

TEST_CASE("a program of several commands names what was typed and what there is") {
  const auto said = [](std::vector<const char*> arguments) {
    CLI::App app("tries things", "try");
    app.require_subcommand(1);
    int count = 0;
    for (const char* name : {"one", "two"}) app.add_subcommand(name)->add_option("--count", count)->type_name("N");
    arguments.insert(arguments.begin(), "try");
    const int err = ::memfd_create("err", 0), kept = ::dup(STDERR_FILENO);
    ::dup2(err, STDERR_FILENO);
    const int code = run_program(app, static_cast<int>(arguments.size()), arguments.data(), [] { return Exit::done; });
    ::dup2(kept, STDERR_FILENO);
    ::close(kept);
    CHECK(code == 2);
    return content(err);
  };
  CHECK(said({}) == "try: command: missing: must be one of one, two\n");
  CHECK(said({"three"}) == "try: command = three: must be one of one, two\n");
  CHECK(said({"one", "--report", "x"}) == "try: --report: not known: must be an option that `try one --help` lists\n");
  CHECK(said({"one", "--count", "2.5"}) == "try: --count = 2.5: must be a whole number\n");
  CHECK(said({"two", "--count", "1", "--count", "2"}) == "try: --count: given 2 times: must be given once\n");
}

TEST_CASE("exceptions become exit codes") {
  CHECK(run({}, [] { return Exit::gate_failed; }).code == 1);
  const Ran no_thread = run(
      {}, []() -> Exit { throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again)); });
  CHECK(no_thread.code == 4);
  CHECK(no_thread.err == "try: cannot start a thread: Resource temporarily unavailable\n");
  CHECK(run({}, []() -> Exit { throw BadInput("scene.json:3", "x", "a number"); }).err ==
        "try: scene.json:3 = x: must be a number\n");
  CHECK(run({}, []() -> Exit { throw Unreachable("en >= 0.2 only"); }).code == 3);
  CHECK(run({}, []() -> Exit { throw Failed("no convergence"); }).code == 4);
  CHECK(run({}, []() -> Exit { throw std::logic_error("two\nlines"); }).err == "try: two; lines\n");
  const Ran no_memory = run({}, []() -> Exit { throw std::bad_alloc(); });
  CHECK(no_memory.code == 4);
  CHECK(no_memory.err == "try: out of memory\n");
  CHECK(run({}, []() -> Exit { throw 7; }).code == 4);
}

TEST_CASE("a closed pipe and a full device are exit code 4 with one line") {
  std::array<int, 2> ends{};
  REQUIRE(::pipe(ends.data()) == 0);
  ::close(ends[0]);
  const Ran closed = run({}, {}, ends[1]);
  ::close(ends[1]);
  CHECK(closed.code == 4);
  CHECK(closed.err == "try: standard output: cannot write: Broken pipe\n");

  const int full = ::open("/dev/full", O_WRONLY);
  CHECK(run({}, {}, full).code == 4);
  CHECK(run({"--help"}, {}, full).code == 4);
  const auto by_stream = [] {
    std::cout << "text";
    return Exit::done;
  };
  CHECK(run({}, by_stream, full).code == 4);
  ::close(full);
}

TEST_CASE("a hint names the command that was run, and its words as a shell reads them") {
  CHECK(run_as("simulate") == "simulate");
  ::setenv("RICOCHET_RUN_BY", "./ricochet", 1);
  CHECK(run_as("simulate") == "./ricochet simulate");
  ::unsetenv("RICOCHET_RUN_BY");
  CHECK(shell_word("data/scenes/five-spheres_1.json") == "data/scenes/five-spheres_1.json");
  for (const std::string text : {"", "two words", "it's", "$HOME;`x`\"*"}) {
    FILE* const shell = ::popen(("printf %s " + shell_word(text)).c_str(), "r");
    std::array<char, 64> said{};
    const std::size_t length = std::fread(said.data(), 1, said.size(), shell);
    ::pclose(shell);
    CHECK(std::string(said.data(), length) == text);
  }
  const char* const words[] = {"/usr/bin/calibrate", "--with", "k=1 N/m", "--en", "0.5"};
  CHECK(typed("calibrate", 5, words) == "calibrate --with 'k=1 N/m' --en 0.5");
}
