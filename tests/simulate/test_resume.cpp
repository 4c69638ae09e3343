// A run that is stopped in the middle of contacts of every law goes on to the same bytes.
#include "console/temporary_folder.hpp"
#include "open_contacts.hpp"

#include <catch2/catch.hpp>
#include <console/json.hpp>
#include <simulate/run.hpp>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <set>

using namespace ricochet;
using namespace ricochet::simulate;
using namespace ricochet::test;
namespace fs = std::filesystem;

namespace {

/// Forces that do nothing but stop the run in the middle of one of its steps, counted from 0.
void stop_at(Scene& scene, std::uint64_t step) {
  const double middle = (static_cast<double>(step) + 0.5) * scene.options.step;
  scene.setup.long_range = [middle, h = scene.options.step](double time, std::span<const Vec3>, std::span<Vec3>) {
    if (std::abs(time - middle) < 0.25 * h) std::raise(SIGINT);
  };
}

void do_nothing(Scene& scene) {
  scene.setup.long_range = [](double, std::span<const Vec3>, std::span<Vec3>) {};
}

}  // namespace

TEST_CASE("a run stopped in the middle of contacts of every law goes on to the same bytes") {
  const TemporaryFolder folder;
  Scene scene = open_contacts();
  do_nothing(scene);
  const fs::path whole = folder.path() / "whole";
  REQUIRE(run(scene, whole, false) == 0);
  // Right after the touch, where memories are half a step old; in the compression; later.
  for (const std::uint64_t stop : {0U, 400U, 900U}) {
    CAPTURE(stop);
    const fs::path parts = folder.path() / std::to_string(stop);
    stop_at(scene, stop);
    REQUIRE(run(scene, parts, false) == SIGINT);
    const console::Json state = console::Json::parse(read_file(parts / "state.json"));
    REQUIRE(state.at("steps") == stop + 1);
    std::set<std::string> laws;
    int rolling = 0, twisting = 0, rubbing = 0, strained = 0;
    for (const auto& contact : state.at("contacts")) {
      laws.insert(contact.at("law").get<std::string>());
      rubbing += contact.at("sliding") != console::Json({0, 0, 0});
      twisting += contact.at("torsion") != 0;
      rolling += contact.at("rolling") != console::Json({0, 0, 0});
      strained += contact.at("strained") != 0;
    }
    CHECK(laws.size() == LawKind::all().size());
    CHECK(rubbing >= 5);
    CHECK(twisting >= 5);
    CHECK(rolling >= 5);
    CHECK(strained >= 3);
    do_nothing(scene);
    REQUIRE(run(scene, parts, true) == 0);
    for (const char* file : {"trajectory.xyz", "contacts.csv", "energy.csv", "state.json"}) {
      CAPTURE(file);
      CHECK(read_file(parts / file) == read_file(whole / file));
    }
  }
}
