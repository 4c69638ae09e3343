#include <catch2/catch.hpp>
#include <ricochet/motion/engine/workers.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <numeric>
#include <set>
#include <thread>
#include <vector>

using namespace ricochet::motion;

TEST_CASE("workers do every part once a round, each part in a thread of its own, the first in the caller's") {
  for (const std::size_t threads : {1u, 2u, 5u}) {
    CAPTURE(threads);
    Workers workers(threads);
    CHECK(workers.threads() == threads);
    std::vector<std::thread::id> who(threads), before;
    std::vector<int> done(threads);
    for (int round = 1; round <= 2000; ++round) {
      workers.run([&](std::size_t part) {
        who.at(part) = std::this_thread::get_id();
        ++done[part];
      });
      // All are done as it returns, and none twice.
      REQUIRE(std::count(done.begin(), done.end(), round) == static_cast<std::ptrdiff_t>(threads));
      if (round > 1) REQUIRE(who == before);
      before = who;
    }
    CHECK(who.front() == std::this_thread::get_id());
    CHECK(std::set(who.begin(), who.end()).size() == threads);
  }
}

TEST_CASE("what one round of workers writes the next one reads") {
  constexpr std::size_t threads = 3, cells = 3000, rounds = 300;
  Workers workers(threads);
  // Each part takes the sum of what all parts wrote in the round before: x_k' = Σ x mod 97, of which all are the same.
  std::vector<unsigned> from(cells), to(cells);
  std::iota(from.begin(), from.end(), 1u);
  unsigned expected = std::accumulate(from.begin(), from.end(), 0u) % 97;
  for (std::size_t round = 0; round < rounds; ++round) {
    workers.run([&](std::size_t part) {
      const unsigned sum = std::accumulate(from.begin(), from.end(), 0u) % 97;
      std::fill(to.begin() + part * cells / threads, to.begin() + (part + 1) * cells / threads, sum + 1);
    });
    REQUIRE(std::all_of(to.begin(), to.end(), [&](unsigned x) { return x == expected + 1; }));
    std::swap(from, to);
    expected = static_cast<unsigned>(cells * (expected + 1) % 97);
  }
}

TEST_CASE("workers that sleep between rounds wake, and end unused") {
  using namespace std::chrono_literals;
  { const Workers unused(4); }
  Workers workers(2);
  std::atomic<int> parts = 0;
  for (int round = 0; round < 5; ++round) {
    std::this_thread::sleep_for(20ms);  // longer than a thread looks before it sleeps
    workers.run([&](std::size_t part) {
      if (part == 1) std::this_thread::sleep_for(20ms);  // the caller sleeps, too
      ++parts;
    });
    CHECK(parts == 2 * (round + 1));
  }
}
