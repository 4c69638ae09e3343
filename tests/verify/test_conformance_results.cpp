#include "../console/temporary_folder.hpp"
#include "conformance_cases.hpp"

#include <console/exit.hpp>

#include <catch2/catch.hpp>

#include <fstream>
#include <regex>

using namespace ricochet;
using namespace ricochet::verify::conformance;

namespace {

const std::string head = "# engine: Mine\n# version: 1.2\n# date: 2026-11-27\n# by: a test\n";
const std::string columns = "case,steps,body,x,y,z,vx,vy,vz,wx,wy,wz,contact_time,max_overlap,note\n";

Results read(const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream(folder / "r.csv") << text;
  return read_results(folder / "r.csv", all_cases());
}

/// What is said against the rows, without the folder.
std::string said(const std::string& rows, const std::string& before = head + columns) {
  try {
    read(before + rows);
  } catch (const console::BadInput& error) {
    const std::string what = error.what();
    return what.substr(what.find("r.csv"));
  }
  return "nothing";
}

}  // namespace

TEST_CASE("conformance: a results file is read back to the last bit") {
  Results results{"Mine", "1.2", "2026-11-27", "a test"};
  const Case c = case_named("normal-linear-force");
  Run run{25, c.bodies, 1.0 / 3e4, std::nullopt};
  run.bodies[0].velocity = {0.1, 1.0 / 3, 1e-300}, run.bodies[1].spin = {-2, 1e22, 1.0 / 7};
  results.cases = {{c.name, {run}, "said"}, {"torsion-none", {}, "no torsion, no words for it"}};
  const Results again = read(results_text(results));
  CHECK(again.engine == "Mine");
  CHECK(again.version == "1.2");
  CHECK(again.date == "2026-11-27");
  CHECK(again.by == "a test");
  REQUIRE(again.cases.size() == 2);
  REQUIRE(again.cases[0].runs.size() == 1);
  const Run& one = again.cases[0].runs[0];
  CHECK(one.steps == 25);
  CHECK(one.contact_time == run.contact_time);
  CHECK_FALSE(one.max_overlap);
  for (std::size_t i = 0; i < 2; ++i) {
    CHECK(one.bodies[i].position == run.bodies[i].position);
    CHECK(one.bodies[i].velocity == run.bodies[i].velocity);
    CHECK(one.bodies[i].spin == run.bodies[i].spin);
    CHECK(one.bodies[i].mass == c.bodies[i].mass);
  }
  CHECK(again.cases[1].runs.empty());
  CHECK(again.cases[1].note == "no torsion, no words for it");
  CHECK(again.find("torsion-none") == &again.cases[1]);
  CHECK(again.find("dem05") == nullptr);
}

TEST_CASE("conformance: what a file says of itself is read however its lines begin and end") {
  const std::string row = "dem05,,,,,,,,,,,,,,no words\n";
  for (const std::string& text :
       {"\xef\xbb\xbf" + head + columns + row,
        "#\tengine:\tMine\t\n #version : 1.2 \n#date:2026-11-27\n" + columns + row,
        std::regex_replace("\xef\xbb\xbf" + head + columns + row, std::regex("\n"), "\r\n")}) {
    const Results r = read(text);
    CHECK(r.engine == "Mine");
    CHECK(r.version == "1.2");
    CHECK(r.date == "2026-11-27");
    CHECK(r.find("dem05")->note == "no words");
  }
}

TEST_CASE("conformance: what a file says of itself is harmless wherever it is shown") {
  const Results r = read("# engine: =Mine()\n# version: 1\x1b[2J2\n# date: \t\n# by: + -@me-too\n" + columns +
                         "dem05,,,,,,,,,,,,,,=no\x07 words\n");
  CHECK(r.engine == "Mine()");
  CHECK(r.version == "1?[2J2");
  CHECK(r.by == "me-too");
  CHECK(r.cases[0].note == "no? words");
}

TEST_CASE("conformance: what printing takes of numbers is read off the file") {
  const auto rounded = [](const std::string& rows) { return read(head + columns + rows).cases[0].runs[0].rounded; };
  SECTION("%g: as many digits as the longest number has") {
    const Rounded r = rounded("dem05,25,1,0.0123457,0,-3.5,2e-05,0,100000,0,0,0,1.5e-6,,\n");
    CHECK(r.bodies[0].position.x == Approx(0.5e-7));
    CHECK(r.bodies[0].position.y == 0);
    CHECK(r.bodies[0].position.z == Approx(0.5e-5));
    CHECK(r.bodies[0].velocity.x == Approx(0.5e-10));
    CHECK(r.bodies[0].velocity.z == Approx(0.5));
    CHECK(r.contact_time == Approx(0.5e-11));
  }
  SECTION("%.6f: the same place of all, in each column's unit") {
    const Rounded r = rounded("dem05,25,1,0.012346,0.000000,-3.500000,1.000000,0.000001,0.100000,0.0,0,0,,,\n");
    CHECK(r.bodies[0].position.x == Approx(0.5e-8));  // not all: as many digits as -3.500000
    const Rounded f =
        rounded("dem05,25,1,0.012346,0.000000,-3.500000,1.000000,0.000001,0.100000,0.000000,0.000000,0.000002,,,\n");
    CHECK(f.bodies[0].position.x == Approx(0.5e-6));
    CHECK(f.bodies[0].velocity.y == Approx(0.5e-6));
    CHECK(f.bodies[0].spin.z == Approx(0.5e-6));
    // Zeros throughout are as open as their neighbours, or as all.
    CHECK(f.bodies[0].position.y == Approx(0.5e-6));
    CHECK(f.bodies[0].spin.x == Approx(0.5e-6));
    const Rounded still = rounded("dem05,25,1,0.01,0.00,-3.50,0.00,0.00,0.00,0.00,0.00,0.00,,,\n");
    CHECK(still.bodies[0].velocity.y == Approx(0.5e-2));
    const std::string millimetres = head + "case,steps,body,x [mm],y,z,vx,vy,vz,wx,wy,wz\n" +
                                    "dem05,25,1,12.345678,0.000000,1.000000,1.000000,0.000001,0.100000,0.000000,"
                                    "0.000000,0.000002\n";
    CHECK(read(millimetres).cases[0].runs[0].rounded.bodies[0].position.x == Approx(0.5e-9));
    const std::string places = head + "case,steps,body,x [mm],y [mm],z [mm],vx,vy,vz,wx,wy,wz\n" +
                               "dem05,25,1,12.345678,0.000000,1.000000,1.000000,0.000000,0.100000,0.000000,0.000000,"
                               "0.000002\n";
    const Rounded p = read(places).cases[0].runs[0].rounded;
    CHECK(p.bodies[0].position.y == Approx(0.5e-9));
    CHECK(p.bodies[0].velocity.y == Approx(0.5e-6));
  }
  SECTION("doubles to the last bit: nothing that counts") {
    const Rounded r = rounded("dem05,25,1,0.1,0,0,0.33333333333333331,0,0,0,0,0,,,\n");
    CHECK(r.bodies[0].position.x < 1e-16);
    CHECK(r.bodies[0].velocity.x < 1e-16);
  }
}

TEST_CASE("conformance: a file that is not UTF-8 is refused with the place of its first such byte") {
  CHECK(said("", "# engine: M\xfcller\n# version: 1\n" + columns) ==
        "r.csv:1: byte 0xfc is not UTF-8: must be a text in UTF-8");
  CHECK(said("dem05,,,,,,,,,,,,,,keine T\xf6ne\n") == "r.csv:6: byte 0xf6 is not UTF-8: must be a text in UTF-8");
  CHECK(said("dem05,,,,,,,,,,,,,,Töne η 𝒯\n") == "nothing");
  // Cut off, too long for what they say, half of a pair, beyond the last.
  for (const char* bad : {"\xc3", "\xc0\xaf", "\xe0\x80\xaf", "\xed\xa0\x80", "\xf0\x80\x80\xaf", "\xf4\x90\x80\x80",
                          "\xf5\x80\x80\x80", "\x80"})
    CHECK(said("dem05,,,,,,,,,,,,,," + std::string(bad) + "\n").find("is not UTF-8") != std::string::npos);
}

TEST_CASE("conformance: runs come in any order and are sorted") {
  const std::string tail = ",1,0,0,0,0,0,0,0,0,0,,,\n";
  const Results r = read(head + columns + "dem05,100" + tail + "dem05,25" + tail + "dem05,50" + tail);
  REQUIRE(r.cases[0].runs.size() == 3);
  CHECK(r.cases[0].runs[0].steps == 25);
  CHECK(r.cases[0].runs[2].steps == 100);
}

TEST_CASE("conformance: what is wrong with a results file is said with its place") {
  const std::string good = "dem05,25,1,0,0,0,0,0,0,0,0,0,,,\n";
  CHECK(said(good) == "nothing");
  CHECK(said("dem06,25,1,0,0,0,0,0,0,0,0,0,,,\n") == "r.csv:6: case = dem06: must be one of verify conformance --list");
  CHECK(said(good + "dem05,25,1,0,0,0,0,0,0,0,0,0,,,\n") == "r.csv:7: body = 1: must be given once a case and steps");
  CHECK(said("dem05,25,1,0,0,0,nan,0,0,0,0,0,,,\n") == "r.csv:6: vx = nan: must be a finite number");
  CHECK(said("dem05,25,1,inf,0,0,0,0,0,0,0,0,,,\n") == "r.csv:6: x = inf: must be a finite number");
  CHECK(said("dem05,25,1,0,0,0,0,0,0,0,0,,,,\n") == "r.csv:6: wz = nothing: must be a finite number");
  CHECK(said("dem05,25,1,0,0,0,0,0,0,0,0,0,x,,\n") == "r.csv:6: contact_time = x: must be a finite number");
  CHECK(said("dem05,25,1,0,0,0,1e100,0,0,0,0,0,,,\n") == "nothing");
  CHECK(said("dem05,25,1,0,0,0,-1.1e100,0,0,0,0,0,,,\n") == "r.csv:6: vx = -1.1e100: must be at most 1e+100");
  for (const std::string steps : {"0", "2.5", "-25", "10000001", "x"})
    CHECK(said("dem05," + steps + ",1,0,0,0,0,0,0,0,0,0,,,\n") ==
          "r.csv:6: steps = " + steps + ": must be a whole number from 1 to 10000000");
  CHECK(said("dem05,10000000,1,0,0,0,0,0,0,0,0,0,,,\n") == "nothing");
  for (const std::string body : {"0", "2", "1.5"})
    CHECK(said("dem05,25," + body + ",0,0,0,0,0,0,0,0,0,,,\n") ==
          "r.csv:6: body = " + body + ": must be a whole number from 1 to 1");
  CHECK(said("normal-elastic,25,2,0,0,0,0,0,0,0,0,0,,,\n") ==
        "r.csv: case normal-elastic, 25 steps: body 1 is missing: must be all 2");
  CHECK(said("dem05,,,,,,,,,,,,,,\n") ==
        "r.csv:6: steps = : must be a whole number, or there is a note why it was not run");
  const std::string noted = "dem05,,,,,,,,,,,,,,no friction\n";
  CHECK(said(noted) == "nothing");
  CHECK(said(noted + noted) == "r.csv:7: case = dem05: must be given once without steps");
  CHECK(said(good, columns) == "r.csv: a line \"# engine: …\" is missing: must name the engine");
  CHECK(said(good, "# engine: Mine\n" + columns) ==
        "r.csv: a line \"# version: …\" is missing: must name the engine's version");
  CHECK(said("1\n", head + "speed\n").find("column") != std::string::npos);
}
