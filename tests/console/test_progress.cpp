// The line on a terminal's stderr, seen from the terminal's other end.
#include <catch2/catch.hpp>
#include <console/node.hpp>
#include <console/progress.hpp>

#include <algorithm>
#include <chrono>
#include <regex>
#include <string>
#include <thread>

#include <fcntl.h>
#include <poll.h>
#include <stdlib.h>
#include <unistd.h>

using namespace ricochet::console;

namespace {

/// stderr is a terminal as long as it lives.
class Terminal {
 public:
  Terminal() : shown_(::posix_openpt(O_RDWR | O_NOCTTY)), before_(::dup(STDERR_FILENO)) {
    REQUIRE((shown_ >= 0 && ::grantpt(shown_) == 0 && ::unlockpt(shown_) == 0));
    const int line = ::open(::ptsname(shown_), O_RDWR | O_NOCTTY);
    REQUIRE(line >= 0);
    ::dup2(line, STDERR_FILENO);
    ::close(line);
  }
  ~Terminal() {
    restore();
    ::close(shown_);
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// All that has come so far; stderr is what it was.
  std::string text() {
    restore();
    std::string all;
    for (pollfd ready{shown_, POLLIN, 0}; ::poll(&ready, 1, 0) == 1 && (ready.revents & POLLIN) != 0;) {
      char bytes[4096];
      const auto n = ::read(shown_, bytes, sizeof bytes);
      if (n <= 0) break;
      all.append(bytes, static_cast<std::size_t>(n));
    }
    return all;
  }

 private:
  void restore() {
    if (before_ < 0) return;
    ::dup2(before_, STDERR_FILENO);
    ::close(before_);
    before_ = -1;
  }

  int shown_, before_;
};

const std::string wiped = "\r\033[K";

void wait(int milliseconds) { std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds)); }

}  // namespace

TEST_CASE("progress shows share and time left after a second, and wipes its line") {
  Terminal terminal;
  {
    Progress progress("work", 8);
    progress.advance(1);  // within the second: nothing
    wait(1010);
    progress.advance(1);  // a quarter in a second: three are left
    progress.advance(1);  // not five times a second
  }
  const std::string text = terminal.text();
  // Where the machine holds the test up more time is left, never less.
  CHECK(text.rfind(wiped + "work: 25 %, ", 0) == 0);
  CHECK(std::stoi(text.substr(wiped.size() + 12)) >= 3);
  const std::string end = " s left" + wiped;
  CHECK(text.substr(text.size() - end.size()) == end);
}

TEST_CASE("where stderr is no terminal progress is a line each time that some seconds have passed") {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const int before = ::dup(STDERR_FILENO);
  ::dup2(ends[1], STDERR_FILENO);
  {
    Progress progress("work", 4, std::chrono::milliseconds{500});
    progress.advance(1);  // too early
    wait(510);
    progress.advance(1);
    progress.advance(1);  // too early again
    wait(510);
    progress.advance(1);
  }
  ::dup2(before, STDERR_FILENO);
  for (const int end : {before, ends[1]}) ::close(end);
  std::string text(4096, '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::read(ends[0], text.data(), text.size()))));
  ::close(ends[0]);
  // Half of it took half a second or, where the machine holds the test up, more.
  CHECK(std::regex_match(text, std::regex("work: 50 %, [1-9] s left\nwork: 100 %, 0 s left\n")));
}

TEST_CASE("progress counts where the end is not known, and says nothing of what is quick") {
  Terminal terminal;
  {
    Progress quick("quick", 2);
    quick.advance();
    quick.advance();
    Progress open("grains", 0);
    wait(1010);
    open.advance(7);
  }
  CHECK(terminal.text() == wiped + "grains: 7" + wiped);
}

TEST_CASE("the parser of a large document tells how far it is: of every byte, in each of its two looks") {
  Terminal terminal;
  std::string text = "[0";
  for (int k = 0; k < 200'000; ++k) text += ",1";
  text += "]";
  {
    Progress progress("read", 0);
    wait(1010);
    const Json json = parse_json("f.json", text, "a document", &progress);
    CHECK(json.size() == 200'001);
    wait(210);
    progress.advance(0);
  }
  const std::string shown = terminal.text();
  const std::size_t whole = (text.size() / (1 << 16) + 1) * (1 << 16);
  CHECK(shown.find(wiped + "read: " + std::to_string(2 * whole) + wiped) != std::string::npos);
}
