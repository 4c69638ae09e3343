#include <catch2/catch.hpp>
#include <ricochet/motion/contact_list.hpp>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

using namespace ricochet;

namespace {

ContactState contact_of(std::uint32_t i, std::uint32_t j, double force) {
  ContactState c;
  c.record.i = i, c.record.j = j;
  c.force = force;
  return c;
}

}  // namespace

TEST_CASE("a list of contacts is in the order of their pairs, whoever comes and goes") {
  // Beside a map, which is in order by itself. Pairs of 30 bodies; first many come, then as many as go, then all go.
  std::mt19937 random(1);
  std::map<NearPair, double> expected;
  ContactList list;
  CHECK(list.empty());
  double next = 0;
  for (int turn = 0; turn < 400; ++turn) {
    CAPTURE(turn);
    const std::size_t coming = turn < 100 ? 6 : turn < 300 ? 3 : 0, going = turn < 100 ? 2 : 3;
    std::vector<std::uint32_t> gone;
    std::vector<ContactState> born;
    for (std::size_t n = 0; n < going && !expected.empty(); ++n) {
      const auto place = static_cast<std::uint32_t>(random() % list.size());
      if (std::find(gone.begin(), gone.end(), place) == gone.end()) gone.push_back(place);
    }
    std::sort(gone.begin(), gone.end());
    for (std::size_t n = 0; n < coming; ++n) {
      const auto i = static_cast<std::uint32_t>(random() % 30), j = i + 1 + static_cast<std::uint32_t>(random() % 30);
      const bool there = expected.contains({i, j}) || std::any_of(born.begin(), born.end(), [&](const ContactState& c) {
                           return pair_of(c) == NearPair{i, j};
                         });
      if (!there) born.push_back(contact_of(i, j, ++next));
    }
    std::sort(born.begin(), born.end(), [](const auto& a, const auto& b) { return pair_of(a) < pair_of(b); });
    for (const std::uint32_t place : gone) expected.erase(pair_of(list[place]));
    for (const ContactState& c : born) expected.emplace(pair_of(c), c.force);
    list.exchange(gone, born);

    REQUIRE(list.size() == expected.size());
    std::uint32_t place = 0;
    for (const auto& [pair, force] : expected) {
      REQUIRE(pair_of(list[place]) == pair);
      REQUIRE(list[place].force == force);
      REQUIRE(list.place_of(pair) == place);
      REQUIRE(list.place_of({pair.i, pair.j + 1}) == place + 1);  // of the next one, whether its pair is there or not
      ++place;
    }
    REQUIRE(list.place_of({100, 0}) == list.size());
    const std::vector<ContactState> all = list.in_order();
    REQUIRE(std::equal(list.begin(), list.end(), all.begin(), all.end(),
                       [](const auto& a, const auto& b) { return pair_of(a) == pair_of(b) && a.force == b.force; }));
  }
  CHECK(list.empty());
}

TEST_CASE("a contact stays where it is in memory until as many have come as there are") {
  std::vector<ContactState> first;
  for (std::uint32_t i = 0; i < 10; ++i) first.push_back(contact_of(i, i + 1, i));
  ContactList list(first);
  const auto side_by_side = [&] {
    for (std::size_t k = 0; k + 1 < list.size(); ++k)
      if (&list[k + 1] != &list[k] + 1) return false;
    return true;
  };
  CHECK(side_by_side());
  const ContactState* const stays = &list.front();
  const std::vector<std::uint32_t> last{9};
  for (std::uint32_t n = 0; n < 10; ++n) {  // the last one goes, another comes behind the first
    list.exchange(last, std::vector{contact_of(0, 50 - n, 50 - n)});
    CHECK(&list.front() == stays);
    CHECK(list[1].force == 50 - n);
    CHECK(side_by_side() == (n == 8));  // the records have gone round once
  }
  list.exchange(last, std::vector{contact_of(0, 40, 40)});
  CHECK(side_by_side());
  CHECK(list.front().force == 0);
  for (std::uint32_t k = 1; k < 10; ++k) CHECK(list[k].force == 39 + k);
}
